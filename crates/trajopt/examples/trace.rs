//! Solves generated scenes from their own witness and prints the trace: `trace DIFFICULTY SEED N [auto]
//! [serpentine] [tol=1e-6]`: net length free, a serpentine hall, polished to a residual.

use pairtrawl_generate::{Kind, generate};
use pairtrawl_trajopt::{Problem, Settings, evaluate, optimize_watched};
use pairtrawl_world::World;

/// Seconds that this thread has spent on a processor.
fn processor_seconds() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 / 1e9
}

fn main() {
    let args: Vec<String> = std::env::args().collect();
    let number =
        |i: usize, default: u64| args.get(i).and_then(|a| a.parse().ok()).unwrap_or(default);
    let kind = if args.iter().any(|a| a == "serpentine") {
        Kind::Serpentine
    } else {
        Kind::Witness
    };
    let generated = generate(
        kind,
        number(1, 3) as u8,
        number(2, 1),
        number(3, 200) as usize,
    )
    .expect("a generated scene");
    let scene = &generated.scene;
    let free = args.iter().any(|a| a == "auto");
    let net_length = (!free).then_some(generated.net_length);
    let world = World::new(scene, net_length).expect("a world");
    let problem = Problem::new(scene, net_length, &world.pieces);
    let mut settings = Settings::default();
    if let Some(tolerance) = args.iter().find_map(|a| a.strip_prefix("tol=")) {
        settings.tolerance = tolerance.parse().expect("a number after tol=");
    }
    let clock = processor_seconds();
    let solution = optimize_watched(
        &problem,
        &generated.witness,
        &settings,
        &mut |iteration, r| {
            println!(
                "{iteration:4} dual {:9.2e} primal {:9.2e} compl {:9.2e} gap {:9.2e}",
                r.dual, r.primal, r.complementarity, r.gap
            );
            true
        },
    );
    let seconds = processor_seconds() - clock;
    println!(
        "{:?} after {} in {:.1} ms on the processor, net {:.3}",
        solution.status,
        solution.iterations,
        1e3 * seconds,
        solution.net_length
    );
    println!(
        "start {:?}",
        evaluate(scene, &generated.witness, generated.net_length)
    );
    println!(
        "end   {:?}",
        evaluate(scene, &solution.trajectory, solution.net_length)
    );
    for v in solution.violations.iter().take(5) {
        println!("{v:?}");
    }
    println!("{:?}", solution.shrunk_margins);
    let reference = pairtrawl_reference::Reference::of_scene(scene, &solution.trajectory);
    let certificate = pairtrawl_certificate::certify(
        scene,
        solution.net_length,
        &solution.trajectory,
        reference.as_ref().ok(),
    );
    for claim in &certificate.claims {
        println!(
            "{:26} {:5} {:10.6} {:?} {}",
            claim.id, claim.holds, claim.margin, claim.step, claim.detail
        );
    }
}
