//! Cold and warm solves over generated scenes, from the baseline of the route: `quantiles [SCENES] [N] [FIRST SEED]
//! [DIFFICULTY]`.
//!
//! Prints for each difficulty the share of certified results and quantiles of iterations and milliseconds on the processor
//! (not wall time: the machine may be busy).

use pairtrawl_generate::{Kind, generate};
use pairtrawl_model::{PairTrajectory, SolverStatus};
use pairtrawl_reference::Reference;
use pairtrawl_route::{baseline, hybrid_a_star, visiting_order};
use pairtrawl_trajopt::{Problem, Settings, Solution, optimize, optimize_from};
use pairtrawl_world::World;

/// Milliseconds that this thread has spent on a processor.
fn processor_ms() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    1e3 * time.tv_sec as f64 + time.tv_nsec as f64 / 1e6
}

/// One solve.
struct Outcome {
    ms: f64,
    iterations: f64,
    certified: bool,
    /// Claims that fail, and by how much.
    failed: Vec<String>,
    status: SolverStatus,
}

fn timed(scene: &pairtrawl_model::Scene, solve: impl Fn() -> Solution) -> (Outcome, Solution) {
    let before = processor_ms();
    let solution = solve();
    let ms = processor_ms() - before;
    let reference = Reference::of_scene(scene, &solution.trajectory);
    let certificate = pairtrawl_certificate::certify(
        scene,
        solution.net_length,
        &solution.trajectory,
        reference.as_ref().ok(),
    );
    let outcome = Outcome {
        ms,
        iterations: solution.iterations as f64,
        certified: certificate.is_valid(),
        failed: certificate
            .claims
            .iter()
            .filter(|claim| !claim.holds)
            .map(|claim| format!("{} {:.2e}", claim.id, claim.margin))
            .collect(),
        status: solution.status,
    };
    (outcome, solution)
}

/// Says which solve ended without a certified result.
fn report(kind: &str, difficulty: u8, seed: u64, outcome: &Outcome, solution: &Solution) {
    if !outcome.certified {
        let worst = solution.violations.first();
        println!(
            "  {kind}, difficulty {difficulty} seed {seed}: {:?}, fails: {}, worst: {worst:?}",
            outcome.status,
            outcome.failed.join(", ")
        );
    }
}

fn quantile(values: &mut [f64], q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * q).round() as usize]
}

fn row(name: &str, outcomes: &[Outcome]) {
    let of = |f: fn(&Outcome) -> f64| outcomes.iter().map(f).collect::<Vec<_>>();
    let (mut ms, mut iterations) = (of(|o| o.ms), of(|o| o.iterations));
    let certified = outcomes.iter().filter(|o| o.certified).count();
    println!(
        "{name:14} certified {certified:4}/{:<4} iterations p50 {:3} p99 {:3} max {:3}   ms p50 {:6.1} p99 {:6.1} max {:6.1}",
        outcomes.len(),
        quantile(&mut iterations, 0.5),
        quantile(&mut iterations, 0.99),
        quantile(&mut iterations, 1.0),
        quantile(&mut ms, 0.5),
        quantile(&mut ms, 0.99),
        quantile(&mut ms, 1.0),
    );
}

fn start(world: &World, scene: &pairtrawl_model::Scene, n: usize) -> Option<PairTrajectory> {
    let order = visiting_order(world, scene).ok()?;
    let centerline = hybrid_a_star::centerline(world, scene, &order).ok()?;
    baseline(world, scene, &centerline, &order, Some(n))
        .or_else(|_| baseline(world, scene, &centerline, &order, None))
        .ok()
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let number =
        |i: usize, default: u64| args.get(i).and_then(|a| a.parse().ok()).unwrap_or(default);
    let (scenes, n, first) = (number(1, 20), number(2, 200) as usize, number(3, 1));
    let (mut all_cold, mut all_warm) = (Vec::new(), Vec::new());
    let only = number(4, 0) as u8;
    for difficulty in (1..=10).filter(|d| only == 0 || only == *d) {
        let (mut cold, mut warm, mut no_start) = (Vec::new(), Vec::new(), 0);
        for seed in first..first + scenes {
            let Ok(generated) = generate(Kind::Witness, difficulty, seed, n) else {
                continue;
            };
            let mut scene = generated.scene;
            scene.net.length = None;
            let Ok(world) = World::new(&scene, None) else {
                continue;
            };
            let Some(start) = start(&world, &scene, n) else {
                no_start += 1;
                continue;
            };
            let problem = Problem::new(&scene, None, &world.pieces);
            let (outcome, solution) =
                timed(&scene, || optimize(&problem, &start, &Settings::default()));
            report("cold", difficulty, seed, &outcome, &solution);
            // A small change of the scene: obstacles and objects keep their places, the first object moves by 2 cm.
            let mut changed = scene.clone();
            if let Some(object) = changed.objects.first_mut() {
                object.position.x += 0.02;
            }
            let problem = Problem::new(&changed, None, &world.pieces);
            let again = || {
                optimize_from(
                    &problem,
                    &solution.trajectory,
                    solution.net_length,
                    &Settings::warm(),
                    &mut |_, _| true,
                )
            };
            if outcome.certified {
                let (outcome, solution) = timed(&changed, again);
                report("warm", difficulty, seed, &outcome, &solution);
                warm.push(outcome);
            }
            cold.push(outcome);
        }
        row(&format!("difficulty {difficulty}"), &cold);
        if no_start > 0 {
            println!("  no start for {no_start}");
        }
        all_cold.extend(cold);
        all_warm.extend(warm);
    }
    row("all, cold", &all_cold);
    row("all, warm", &all_warm);
}
