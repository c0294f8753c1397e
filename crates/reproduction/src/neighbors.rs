//! Neighbors of the paper on the same scenes: topological separation, a fixed separation, and a search without dynamics.

use crate::chapter::Content;
use crate::drawing::{points, track, whole};
use crate::evidence::Evidence;
use crate::judged::Judged;
use crate::lab::{Lab, Stopped};
use crate::pair_search;
use crate::planning::plan_scene;
use crate::scenes;
use crate::solving::{Rule, Start};
use crate::verdict::Verdict;
use pairtrawl::PlanOptions;
use pairtrawl::RehearsalMode;
use pairtrawl::model::numbers::length;
use pairtrawl::model::{ClaimId, PairTrajectory};
use pairtrawl::report::study::{Pen, Picture, Table};
use pairtrawl_route::visiting_order;

/// Seed of the search.
const SEED: u64 = 1;

/// A pair of trajectories and its net, m; or why there is none.
type Found = Result<(PairTrajectory, f64), String>;

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    content.text("What methods near to the paper's give up on the same scenes. Topological separation has no bound on the net (its baseline 1). A fixed separation is its baseline 2. The search is ours in the spirit of Teshnizi and Shell: it samples positions of both robots, moves them on straight lines, bounds their distance by the net and keeps the line between them off obstacles, but knows no headings: at each corner both robots turn on the spot. All are judged by the same certificate and driven closely in physics with the same net, or the one that they need.");
    let mut table = Table::new(
        "",
        &[
            "scene and method",
            "#net",
            "#paths",
            "objects covered",
            "#clearance beyond the radius",
            "claims that fail",
            "driven",
        ],
    );
    let mut pictures = Vec::new();
    let (mut all, mut ours_gathered, mut ours_failing) = (0.0, 0.0, 0.0);
    let mut search_gathered = 0.0;
    let mut search_failing = 0.0;
    let scenes = [
        scenes::experiment()?,
        scenes::narrow_gap()?,
        scenes::wide_clusters()?,
    ];
    for loaded in &scenes {
        let scene = &loaded.scene;
        lab.may_go_on()?;
        lab.host.doing(&format!("neighbors: {}", scene.name));
        let net = scene.net.length.unwrap_or(1.5);
        let start = Start::of(scene)?;
        let options = PlanOptions {
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        };
        let ours = plan_scene(lab, loaded, &options)?.plan.trajectory;
        let mut methods: Vec<(&str, Pen, Found)> = vec![("ours", Pen::Driven, Ok((ours, net)))];
        let free = start.solve(scene, Rule::None, Some(net));
        let solved = |s: crate::solving::Solved| match s.refused {
            None => Ok((s.trajectory, s.net_length)),
            Some(why) => Err(why),
        };
        methods.push(("topological", Pen::Third, solved(free)));
        methods.push((
            "fixed separation",
            Pen::Other,
            solved(start.solve(scene, Rule::Rigid, Some(net))),
        ));
        let order =
            visiting_order(&start.world, scene).map_err(|e| Stopped::failed(&scene.name, e))?;
        let found = pair_search::search(scene, &start.world, &order, net, SEED);
        let found = found.map(|way| (pair_search::waypoints(scene, &way), net));
        methods.push(("search", Pen::Planned, found));
        let mut picture = whole(scene, &scene.name);
        all += scene.objects.len() as f64;
        for (name, pen, found) in methods {
            let label = format!("{}: {name}", scene.name);
            let (trajectory, net) = match found {
                Ok(found) => found,
                Err(why) => {
                    table.row([
                        label,
                        length(net),
                        String::new(),
                        String::new(),
                        String::new(),
                        format!("no solution: {why}"),
                        String::new(),
                    ]);
                    continue;
                }
            };
            let judged = Judged::of(scene, &trajectory, net);
            let covered = if judged.holds(ClaimId::EveryObjectCovered) {
                "all"
            } else {
                "not all"
            };
            table.row([
                label,
                length(judged.net_length),
                length(judged.paths),
                covered.to_owned(),
                length(judged.clearance()),
                judged.failing(),
                judged.driven(),
            ]);
            match name {
                "ours" => {
                    ours_gathered += judged.gathered() as f64;
                    ours_failing += judged.failures() as f64;
                }
                "search" => {
                    search_gathered += judged.gathered() as f64;
                    search_failing += judged.failures() as f64;
                }
                _ => {}
            }
            draw(&mut picture, &trajectory, pen, name);
        }
        pictures.push(picture);
    }
    content.pictures(pictures);
    content.table(table);
    content.verdict(Verdict::of(
        "neighbors",
        Evidence::default()
            .with("objects_in_three_scenes", all, "")
            .with("gathered_by_ours", ours_gathered, "")
            .with("failing_claims_of_ours", ours_failing, "")
            .with("gathered_by_the_search", search_gathered, "")
            .with("failing_claims_of_the_search", search_failing, ""),
    ));
    Ok(content)
}

fn draw(picture: &mut Picture, pair: &PairTrajectory, pen: Pen, name: &str) {
    for robot in [&pair.left, &pair.right] {
        picture.tracks.push(track(points(robot), pen, name));
    }
}
