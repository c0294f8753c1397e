//! The U-shaped cost of the separation against none and against a fixed one: the paper's Fig. 6.

use crate::chapter::Content;
use crate::drawing::{points, track, whole};
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::scenes;
use crate::solving::{Rule, Solved, Start};
use crate::verdict::Verdict;
use pairtrawl::model::Scene;
use pairtrawl::model::numbers::{cost, length};
use pairtrawl::report::study::{Axis, Chart, Curve, Line, Mark, Note, Pen, Picture, Table};
use pairtrawl_parallel::prelude::*;

/// What the three rules give on one scene.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// The scene.
    pub scene: Scene,
    /// The lengths that were looked at, m.
    pub lengths: Vec<f64>,
    /// With the U-shaped cost, by length.
    pub u_shape: Vec<Solved>,
    /// With a fixed separation, by length.
    pub rigid: Vec<Solved>,
    /// Without any rule, whatever net it takes.
    pub none: Solved,
    /// Of `lengths`, the one whose trajectories are drawn.
    pub shown: usize,
}

/// Optimizes a scene under the three rules from the same start, for many lengths of net.
///
/// # Errors
/// When there is no way at all.
pub fn compare(scene: &Scene, lengths: &[f64], shown: usize) -> Result<Comparison, Stopped> {
    let start = Start::of(scene)?;
    let solve = |rule: Rule| -> Vec<Solved> {
        let one = |length: &f64| start.solve(scene, rule, Some(*length));
        lengths.par_iter().map(one).collect()
    };
    Ok(Comparison {
        scene: scene.clone(),
        lengths: lengths.to_vec(),
        u_shape: solve(Rule::UShape),
        rigid: solve(Rule::Rigid),
        none: start.solve(scene, Rule::None, Some(lengths[shown])),
        shown,
    })
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    let count: u32 = if lab.quick { 9 } else { 17 };
    let lengths: Vec<f64> = (0..count)
        .map(|i| 1.0 + 2.0 * f64::from(i) / f64::from(count - 1))
        .collect();
    content.text("Three scenes: the experiment, one with a gap of 1.5 m, and one with clusters half a meter wide (the latter two ours: the paper prints no coordinates). In each the three rules are optimized from the same start with the same number of waypoints: the U-shaped cost (ours and the paper's), no rule at all (its baseline 1), and a separation fixed at d_rest (its baseline 2). The second and the third are studies: their trajectories break claims and are no plans.");
    let (mut gaps, mut needs, mut least_excess, mut detours) =
        (0.0, Vec::new(), f64::INFINITY, Vec::new());
    let mut u_solved = 0.0;
    for (loaded, drawn) in [
        (scenes::experiment()?, 1.5),
        (scenes::narrow_gap()?, 1.5),
        (scenes::wide_clusters()?, 2.0),
    ] {
        lab.may_go_on()?;
        lab.host
            .doing(&format!("rules for the separation: {}", loaded.scene.name));
        let off = |i: &usize| (lengths[*i] - drawn).abs();
        let shown = (0..lengths.len())
            .min_by(|a, b| off(a).total_cmp(&off(b)))
            .unwrap_or(0);
        let found = compare(&loaded.scene, &lengths, shown)?;
        content.heading(&loaded.scene.name);
        content.figures(vec![chart(&found)], vec![picture(&found)]);
        content.table(stops(&found));
        let refused = |all: &[Solved]| all.iter().filter(|s| s.refused.is_some()).count() as f64;
        gaps += refused(&found.rigid);
        u_solved += lengths.len() as f64 - refused(&found.u_shape);
        needs.push((found.none.refused.is_none(), found.none.net_length));
        let solved = |all: &[Solved]| -> Vec<f64> {
            let costs = all.iter().filter(|s| s.refused.is_none());
            costs.map(|s| s.cost.distance).collect()
        };
        let least = |all: &[f64]| all.iter().copied().fold(f64::INFINITY, f64::min);
        let (u, rigid) = (solved(&found.u_shape), solved(&found.rigid));
        if found.none.refused.is_none() {
            least_excess = least_excess.min(least(&u) - found.none.cost.distance);
        }
        // How much farther a rigid pair drives with the longest nets than with its best one.
        if let Some(last) = rigid.last() {
            detours.push(100.0 * (last / least(&rigid) - 1.0));
        }
    }
    let all = 3.0 * lengths.len() as f64;
    let most = needs
        .iter()
        .filter(|n| n.0)
        .map(|n| n.1)
        .fold(f64::NAN, f64::max);
    content.verdict(Verdict::of(
        "no-rule",
        Evidence::default()
            .with(
                "least_J_dist_of_the_U-shape_above_that_of_no_rule",
                least_excess,
                "",
            )
            .with("longest_net_that_no_rule_needs", most, "m")
            .with("longest_optimum_of_the_U-shape", longest_optimum(lab)?, "m"),
    ));
    content.verdict(Verdict::of(
        "rigid",
        Evidence::default()
            .with("lengths_in_three_scenes", all, "")
            .with("lengths_without_a_solution", gaps, "")
            .with(
                "greatest_detour_at_the_longest_net",
                detours.iter().copied().fold(f64::NAN, f64::max),
                "%",
            ),
    ));
    content.verdict(Verdict::of(
        "u-shape",
        Evidence::default()
            .with("lengths_in_three_scenes", all, "")
            .with("lengths_with_a_solution_of_the_U-shape", u_solved, "")
            .with(
                "lengths_with_a_solution_of_a_fixed_separation",
                all - gaps,
                "",
            ),
    ));
    Ok(content)
}

/// The longest net that the U-shaped cost chooses in the three scenes, m.
fn longest_optimum(lab: &Lab) -> Result<f64, Stopped> {
    let scenes = [
        scenes::experiment()?,
        scenes::narrow_gap()?,
        scenes::wide_clusters()?,
    ];
    let mut longest = f64::NAN;
    for loaded in &scenes {
        lab.may_go_on()?;
        let solved = Start::of(&loaded.scene)?.solve(&loaded.scene, Rule::UShape, None);
        longest = f64::max(longest, solved.net_length);
    }
    Ok(longest)
}

fn chart(found: &Comparison) -> Chart {
    let curve = |label: &str, look: usize, line: Line, all: &[Solved]| Curve {
        label: label.to_owned(),
        points: (found.lengths.iter().zip(all))
            .map(|(l, s)| {
                (
                    *l,
                    if s.refused.is_none() {
                        s.cost.distance
                    } else {
                        f64::NAN
                    },
                )
            })
            .collect(),
        line,
        look,
        band: None,
    };
    let ends = [found.lengths[0], found.lengths[found.lengths.len() - 1]];
    let mut curves = vec![
        curve("rigid", 1, Line::Dashed, &found.rigid),
        curve("U-shape", 0, Line::Solid, &found.u_shape),
    ];
    if found.none.refused.is_none() {
        curves.push(Curve {
            label: "none".to_owned(),
            points: ends.map(|x| (x, found.none.cost.distance)).to_vec(),
            line: Line::Plain,
            look: 2,
            band: None,
        });
    }
    Chart {
        title: "Distance cost over the net".to_owned(),
        x: Axis::named("net length d_max (m)"),
        y: Axis::named("J_dist"),
        curves,
        marks: vec![Mark {
            x: found.none.net_length,
            label: "none needs".to_owned(),
        }],
        caption: "A gap in a curve: no solution.".to_owned(),
    }
}

fn picture(found: &Comparison) -> Picture {
    let at = found.lengths[found.shown];
    let mut picture = whole(
        &found.scene,
        &format!("Trajectories with a net of {}", length(at)),
    );
    let (u, rigid) = (&found.u_shape[found.shown], &found.rigid[found.shown]);
    for (solved, pen, name) in [
        (&found.none, Pen::Third, "no rule"),
        (rigid, Pen::Other, "rigid"),
        (u, Pen::Driven, "U-shape"),
    ] {
        if solved.refused.is_none() {
            for robot in [&solved.trajectory.left, &solved.trajectory.right] {
                picture.tracks.push(track(points(robot), pen, name));
            }
        }
    }
    if rigid.refused.is_some() {
        let place = found.scene.start.midpoint();
        picture.notes.push(Note {
            place,
            text: "rigid: no solution".to_owned(),
        });
    }
    picture
}

fn stops(found: &Comparison) -> Table {
    let mut table = Table::new(
        &format!(
            "No rule at all: J_dist {}, takes a net of {}{}. Where a rule has no solution:",
            cost(found.none.cost.distance),
            length(found.none.net_length),
            found
                .none
                .refused
                .as_ref()
                .map_or(String::new(), |why| format!(" (no solution: {why})")),
        ),
        &["rule", "net", "what stops it"],
    );
    for (name, all) in [("U-shape", &found.u_shape), ("rigid", &found.rigid)] {
        for (l, solved) in found.lengths.iter().zip(all) {
            if let Some(why) = &solved.refused {
                table.row([name.to_owned(), length(*l), why.clone()]);
            }
        }
    }
    if table.rows.is_empty() {
        table.row([
            "U-shape, rigid",
            "every length",
            "nothing: all have a solution",
        ]);
    }
    table
}
