//! What is looked up near a waypoint or step, against going through everything.

use super::case::Case;
use crate::active::ActiveSet;
use crate::anchor::Anchor;
use crate::block::Item;
use crate::constraints::{LineRules, PointRules};
use crate::iterate::Iterate;
use crate::row::Beginning;
use crate::term::QUAD;
use crate::tier::Tier;
use pairtrawl_geometry::{Convex, Hull, Point, Polygon};
use pairtrawl_model::Side;
use std::collections::BTreeSet;

const BEGINNING: Beginning = Beginning {
    elastic: 3e3,
    mu: 1.0,
};

fn cases() -> Vec<(Case, Iterate)> {
    [
        Case::new(2, 1, 80, false),
        Case::new(9, 2, 80, true),
        Case::tight(7, 3, 80, false),
        Case::tight(10, 4, 80, true),
    ]
    .map(|case| {
        let x = case.start();
        (case, x)
    })
    .into()
}

fn set_of(case: &Case, x: &Iterate) -> ActiveSet {
    ActiveSet::new(&case.problem, x, BEGINNING)
}

/// Distances in play beyond what is kept, of margins and of claims, m.
fn ahead(tier: Tier) -> f64 {
    match tier {
        Tier::Margin => 0.2,
        Tier::Claim => 0.15,
    }
}

#[test]
fn every_object_near_a_robot_is_found() {
    let mut found = 0;
    for (case, x) in cases() {
        let set = set_of(&case, &x);
        let rows: BTreeSet<(usize, Side, u32, Tier)> = set
            .points
            .items
            .iter()
            .filter_map(|r| match r.rule {
                PointRules::OffObject(rule) => {
                    Some((r.at.stage(), r.at.robot(), rule.object, rule.tier))
                }
                _ => None,
            })
            .collect();
        let scene = &case.made.scene;
        let mut expected = BTreeSet::new();
        for stage in 1..x.stages.len() - 1 {
            for robot in Side::BOTH {
                for (id, object) in scene.objects.iter().enumerate() {
                    for tier in Tier::BOTH {
                        let gap = x.position(stage, robot).distance(object.position)
                            - object.footprint_radius()
                            - scene.robot.radius
                            - case.kept(tier, case.problem.reserve.clearance);
                        if gap < ahead(tier) {
                            expected.insert((stage, robot, id as u32, tier));
                        }
                    }
                }
            }
        }
        assert!(
            rows == expected,
            "{:?}",
            rows.symmetric_difference(&expected)
        );
        found += rows.len();
    }
    assert!(found > 100, "{found}");
}

#[test]
fn every_obstacle_near_what_the_line_sweeps_is_found() {
    let mut found = 0;
    for (case, x) in cases() {
        let set = set_of(&case, &x);
        let key = |r: &Item<LineRules, QUAD>| {
            let LineRules::LineOffObstacle(rule) = r.rule;
            (r.at.stage(), rule.piece, rule.tier)
        };
        let rows: BTreeSet<(usize, u32, Tier)> = set.lines.items.iter().map(key).collect();
        for step in 0..x.stages.len() - 1 {
            let ends = [0, 1]
                .map(|k| Side::BOTH.map(|r| x.position(step + k, r)))
                .concat();
            let hull = Hull::of(&ends);
            // The nearest six, and those that overlap before all.
            let mut near: Vec<(f64, u32)> = Vec::new();
            for (id, convex) in case.pieces.iter().enumerate() {
                let gap = match convex {
                    Convex::Polygon(v) => hull.gap_to_polygon(&Polygon::new(v.clone())).distance,
                    Convex::Circle { center, radius } => {
                        hull.gap_to_disc(*center, *radius).distance
                    }
                };
                near.push((gap, id as u32));
            }
            near.sort_by(|a, b| a.0.total_cmp(&b.0));
            for &(gap, id) in near.iter().take(6) {
                for tier in Tier::BOTH {
                    let c = gap - case.kept(tier, case.problem.reserve.net_clearance);
                    let present = rows.contains(&(step, id, tier));
                    // Of a tier only where the margin's is too.
                    assert_eq!(present, c < ahead(tier), "{c} of {tier:?} {id} at {step}");
                    found += usize::from(present);
                }
            }
        }
    }
    assert!(found > 100, "{found}");
}

#[test]
fn crossings_are_where_a_search_of_all_waypoints_finds_them() {
    let mut objects = 0;
    for (case, mut x) in cases() {
        let mut set = set_of(&case, &x);
        for moved in [false, true] {
            if moved {
                // Eight waypoints earlier, and looked up again from where they were.
                x.stages.rotate_left(8);
                set.refresh(&case.problem, &x, BEGINNING);
            }
            for (id, object) in case.made.scene.objects.iter().enumerate() {
                let miss = |i: usize| {
                    let (l, r) = (x.position(i, Side::Left), x.position(i, Side::Right));
                    let unit = (l - r) / l.distance(r);
                    let from: Point = object.position - r;
                    let beyond = (-from.dot(unit)).max(from.dot(unit) - l.distance(r));
                    from.cross(unit).abs() + 4.0 * beyond.max(0.0)
                };
                let least = (1..x.stages.len() - 1)
                    .map(miss)
                    .fold(f64::INFINITY, f64::min);
                let given = miss(set.crossings[id]);
                assert!(given <= least + 1e-12, "object {id}: {given} for {least}");
                objects += 1;
            }
        }
    }
    assert!(objects > 10, "{objects}");
}
