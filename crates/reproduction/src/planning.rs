//! Planning: the paper's Figs. 2 and 3, its time, and Algorithm 1.

use crate::chapter::{Content, Timing};
use crate::drawing::{points, whole};
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::scenes;
use crate::selection::{Case, Selection, selections};
use crate::verdict::Verdict;
use pairtrawl::files::LoadedScene;
use pairtrawl::geometry::Point;
use pairtrawl::model::numbers::{cost, duration, length};
use pairtrawl::report::study::{Note, Pen, Picture, Table, Track};
use pairtrawl::trajopt::evaluate;
use pairtrawl::{
    CenterlineMethod, Method, NetLength, PlanError, PlanOptions, Planned, RehearsalMode, plan,
};

/// N of the time that the paper states, and the time, s.
pub const PAPER_WAYPOINTS: usize = 200;
/// See [`PAPER_WAYPOINTS`].
pub const PAPER_SECONDS: f64 = 180.3;

/// Plans a scene with its net length chosen by the planner, the centerline found in one way.
///
/// # Errors
/// When there is no plan, or the host stops it.
pub fn planned_with(
    lab: &Lab,
    loaded: &LoadedScene,
    method: CenterlineMethod,
) -> Result<Planned, Stopped> {
    let options = PlanOptions {
        centerline: Some(method),
        net_length: Some(NetLength::Auto),
        ..PlanOptions::default()
    };
    plan_scene(lab, loaded, &options)
}

/// Plans a scene.
///
/// # Errors
/// When there is no plan, or the host stops it.
pub fn plan_scene(
    lab: &Lab,
    loaded: &LoadedScene,
    options: &PlanOptions,
) -> Result<Planned, Stopped> {
    let mut watch = lab.watch();
    plan(&loaded.scene, &loaded.reference, options, &mut watch)
        .map_err(|error| Stopped::from_plan(&loaded.scene.name, &error))
}

/// J with the paper's N under each method of optimization, on the experiment with its net length open; none where the
/// method finds no plan.
///
/// # Errors
/// When the host stops it.
pub fn methods(lab: &Lab) -> Result<[Option<f64>; 3], Stopped> {
    let loaded = scenes::experiment()?;
    let mut costs = [None; 3];
    let all = [
        Method::Joint,
        Method::Alternating,
        Method::AlternatingBounded,
    ];
    for (found, method) in costs.iter_mut().zip(all) {
        let options = PlanOptions {
            method,
            explore: false,
            net_length: Some(NetLength::Auto),
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        };
        let mut watch = lab.watch();
        match plan(&loaded.scene, &loaded.reference, &options, &mut watch) {
            Ok(planned) => *found = Some(planned.plan.cost.total()),
            Err(PlanError::Interrupted) => return Err(Stopped::Interrupted),
            Err(_) => {}
        }
    }
    Ok(costs)
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    let loaded = scenes::simulation()?;
    lab.host
        .doing("planning the simulation with both planners of the centerline");
    content.text("The simulation's scene is a reconstruction: twelve cubes, start and end are the authors', the thirteenth cube and the obstacles are ours, since the paper prints no coordinates. Below: centerline, baseline pair (eqs. 1 to 3) and the optimized pair, the net's length chosen by the planner.");
    let mut table = Table::new(
        "Planned with each planner of the centerline",
        &[
            "centerline",
            "#net",
            "#J of the baseline",
            "#J optimized",
            "#paths",
            "#waypoints",
            "#iterations",
            "claims proven",
            "rehearsal",
        ],
    );
    let mut pictures = Vec::new();
    let mut evidence = Evidence::default();
    let (mut certified, mut gathered, mut objects) = (0, 0, 0);
    let mut first = None;
    for method in [CenterlineMethod::HybridAStar, CenterlineMethod::RrtStar] {
        let planned = planned_with(lab, &loaded, method)?;
        let p = &planned.plan;
        let before = evaluate(&loaded.scene, &p.baseline, p.net_length).total();
        let (left, right) = p.trajectory.path_lengths();
        let record = planned.rehearsal.as_ref();
        let kept = record.map_or(0, |r| r.gathered_count());
        certified += usize::from(p.certificate.is_valid());
        gathered += kept;
        objects += loaded.scene.objects.len();
        table.row([
            method.name().to_owned(),
            length(p.net_length),
            cost(before),
            cost(p.cost.total()),
            length(left + right),
            p.trajectory.len().to_string(),
            p.solver.iterations.to_string(),
            format!(
                "{} of {}",
                p.certificate.claims.iter().filter(|c| c.holds).count(),
                p.certificate.claims.len()
            ),
            format!("{kept} of {} gathered", loaded.scene.objects.len()),
        ]);
        evidence = evidence
            .with(
                &format!("J_baseline_{}", method.name().replace(' ', "_")),
                before,
                "",
            )
            .with(
                &format!("J_optimized_{}", method.name().replace(' ', "_")),
                p.cost.total(),
                "",
            );
        pictures.push(fig_2(&loaded, &planned, method));
        first.get_or_insert(planned);
    }
    content.pictures(pictures);
    content.table(table);
    if let Some(planned) = &first {
        fig_3(&mut content, &loaded, planned);
    }
    content.verdict(Verdict::of(
        "plans",
        evidence
            .with("plans", 2.0, "")
            .with("certified_plans", certified as f64, "")
            .with("objects", objects as f64, "")
            .with("objects_gathered_in_rehearsal", gathered as f64, ""),
    ));
    algorithm_1(lab, &mut content)?;
    time(lab, &mut content)?;
    Ok(content)
}

fn fig_2(loaded: &LoadedScene, planned: &Planned, method: CenterlineMethod) -> Picture {
    let p = &planned.plan;
    let track = |points: Vec<Point>, pen: Pen, name: &str| Track {
        points,
        pen,
        name: name.to_owned(),
        stops: false,
    };
    let mut picture = whole(&loaded.scene, &format!("Fig. 2 with {}", method.name()));
    picture.tracks = vec![
        track(points(&p.centerline), Pen::Planned, "centerline"),
        track(points(&p.baseline.left), Pen::Third, "baseline pair"),
        track(points(&p.baseline.right), Pen::Third, "baseline pair"),
        track(points(&p.trajectory.left), Pen::Driven, "optimized pair"),
        track(points(&p.trajectory.right), Pen::Driven, "optimized pair"),
    ];
    picture
}

/// One picture for each case of Fig. 3, from the centerline of a plan.
fn fig_3(content: &mut Content, loaded: &LoadedScene, planned: &Planned) {
    content.heading("Fig. 3: which of four candidates become the baseline");
    let plan = &planned.plan;
    let all = selections(
        &plan.centerline,
        &plan.circles,
        loaded.scene.planner.half_separation,
    );
    let count = |case: Case| all.iter().filter(|s| s.case == case).count();
    content.text(format!(
        "Of the {} points of this plan's centerline that lie in or on a circle, both outer candidates are on the circle at {} (case 1), one is on the circle and one at l at {} (case 2), both are at l at {} (case 3). One waypoint of each is drawn.",
        all.len(), count(Case::Circle), count(Case::Mixed), count(Case::Line),
    ));
    let mut pictures = Vec::new();
    for (case, title) in [
        (Case::Circle, "Case 1: both on the circle"),
        (Case::Mixed, "Case 2: one of each"),
        (Case::Line, "Case 3: both at l"),
    ] {
        // In the middle of the longest stretch the case is seen best.
        let of_case: Vec<&Selection> = all.iter().filter(|s| s.case == case).collect();
        let Some(one) = of_case.get(of_case.len() / 2) else {
            continue;
        };
        pictures.push(selected(loaded, planned, one, title));
    }
    content.pictures(pictures);
}

fn selected(loaded: &LoadedScene, planned: &Planned, one: &Selection, title: &str) -> Picture {
    let mut picture = whole(&loaded.scene, title);
    picture.scene.circles = vec![planned.plan.circles[one.circle].clone()];
    let reach = Point::new(1.0, 0.8);
    let middle = one.pose.position();
    picture.window = Some([middle - reach, middle + reach]);
    let track = |points: Vec<Point>, pen: Pen, name: &str| Track {
        points,
        pen,
        name: name.to_owned(),
        stops: false,
    };
    picture.tracks = vec![
        track(points(&planned.plan.centerline), Pen::Planned, "centerline"),
        track(one.on_line.to_vec(), Pen::Squares, "at l (eq. 1)"),
        track(
            one.on_circle.to_vec(),
            Pen::Dots,
            "on the circle (eqs. 2, 3)",
        ),
        track(one.taken.to_vec(), Pen::Driven, "taken: the outer two"),
    ];
    picture.notes = vec![
        Note {
            place: one.taken[0],
            text: "left".to_owned(),
        },
        Note {
            place: one.taken[1],
            text: "right".to_owned(),
        },
    ];
    picture
}

fn algorithm_1(lab: &Lab, content: &mut Content) -> Result<(), Stopped> {
    lab.host.doing("optimizing one robot after the other");
    let costs = lab.remember("methods", || methods(lab))?;
    content.heading("Algorithm 1");
    let mut table = Table::new(
        "The experiment, net length open, one start, every method with the same costs and constraints",
        &["method", "#J", ""],
    );
    let names = [
        ("both robots and the net length at once (default)", ""),
        (
            "one robot after the other, first d_max = N dL_max as printed",
            "8 rounds",
        ),
        ("one robot after the other, first d_max bounded", "8 rounds"),
    ];
    for ((name, words), found) in names.iter().zip(costs) {
        table.row([
            (*name).to_owned(),
            found.map_or("no certified plan".to_owned(), cost),
            (*words).to_owned(),
        ]);
    }
    content.table(table);
    let [joint, open, bounded] = costs.map(|c| c.unwrap_or(f64::INFINITY));
    content.verdict(Verdict::of(
        "alternating",
        Evidence::default()
            .with("J_joint", joint, "")
            .with("J_alternating", open, "")
            .with("J_alternating_bounded_start", bounded, ""),
    ));
    Ok(())
}

fn time(lab: &Lab, content: &mut Content) -> Result<(), Stopped> {
    lab.host.doing("planning the experiment with 200 waypoints");
    let loaded = scenes::experiment()?;
    let mut rows = Vec::new();
    for (name, explore) in [
        ("one start", false),
        ("exploring several starts (default)", true),
    ] {
        let options = PlanOptions {
            waypoints: Some(PAPER_WAYPOINTS),
            explore,
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        };
        let begin = lab.host.now();
        let planned = plan_scene(lab, &loaded, &options)?;
        let seconds = lab.host.now() - begin;
        content.timings.push(Timing {
            name: format!("planning the experiment, N = {PAPER_WAYPOINTS}, {name}"),
            seconds,
        });
        rows.push((
            name,
            seconds,
            planned.plan.cost.total(),
            planned.plan.solver.iterations,
        ));
    }
    content.heading("Time to plan");
    let mut table = Table::new(
        "The experiment at N = 200, from the scene to the certificate. The paper's scene is not published: ours is a reconstruction, and its machine (Ryzen 9 5950X, Matlab's fmincon) is another, so the times compare orders of magnitude. They are the only numbers of this page that differ between runs.",
        &["", "#time", "#J", "#iterations"],
    );
    for (name, seconds, j, iterations) in rows {
        table.row([
            name.to_owned(),
            duration(seconds),
            cost(j),
            iterations.to_string(),
        ]);
    }
    table.row(["the paper", "180.3 s", "not stated", "not stated"]);
    content.table(table);
    Ok(())
}
