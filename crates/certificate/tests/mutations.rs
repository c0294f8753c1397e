//! Valid plans, broken in every way that comes to mind: the certificate and a brute-force checker have to agree, and
//! whatever the checker refuses the certificate refuses.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod support;

use pairtrawl_certificate::certify;
use pairtrawl_geometry::Pose;
use std::collections::BTreeMap;
use support::Case;
use support::brute::{Opinion, opinions};
use support::build::{Leg, drive, hall};
use support::furnish::{brute_accepts, furnish, on_a_line, shape};
use support::random::Random;

/// Known solutions, and exact drives through halls furnished with shapes of every kind.
fn valid_plans(random: &mut Random) -> Vec<Case> {
    let mut cases: Vec<Case> = [1, 3, 4, 7, 9].map(support::witness).to_vec();
    for kind in 0..7 {
        let scene = hall(8.0, 6.0, 2.0, 5.0);
        let legs = [
            Leg {
                steps: 20,
                forward: 0.03,
                turn: 0.0,
            },
            Leg {
                steps: 25,
                forward: 0.03,
                turn: random.within(0.01, 0.03),
            },
            Leg {
                steps: 10,
                forward: 0.025,
                turn: 0.0,
            },
            Leg {
                steps: 25,
                forward: 0.03,
                turn: -random.within(0.01, 0.03),
            },
        ];
        let mut case = drive(&scene, &legs, 1.2);
        furnish(&mut case, kind, random, brute_accepts);
        cases.push(case);
    }
    cases
}

const KINDS: [&str; 16] = [
    "waypoint moved",
    "sides swapped",
    "obstacle grown into the band",
    "object moved",
    "net shortened",
    "headings splayed",
    "step reversed",
    "not a number",
    "clock changed",
    "waypoint dropped",
    "one robot delayed",
    "obstacle at a robot",
    "area shrunk",
    "map cell blocked",
    "stretch turned",
    "pair widened",
];

fn mutate(case: &mut Case, kind: usize, random: &mut Random) {
    let n = case.trajectory.len();
    let i = random.below(n);
    let trajectory = &mut case.trajectory;
    let right = random.below(2) == 0;
    match kind {
        0 => {
            let poses = if right {
                &mut trajectory.right
            } else {
                &mut trajectory.left
            };
            poses[i].x += random.of_any_size(1e-6, 0.3);
            poses[i].y += random.of_any_size(1e-6, 0.3);
        }
        1 => {
            // From some waypoint on, or all of it.
            let from = if random.below(2) == 0 { 0 } else { i };
            let (l, r) = (&mut trajectory.left, &mut trajectory.right);
            l[from..].swap_with_slice(&mut r[from..]);
        }
        2 | 11 => {
            let (low, high) = if kind == 2 { (-0.6, 1.6) } else { (-0.2, 0.2) };
            let p = on_a_line(case, random, low, high);
            let size = random.of_any_size(0.002, 0.5).abs();
            let shape = shape(p, size, random.below(5), random);
            case.scene.obstacles.push(shape);
        }
        3 => {
            let p = on_a_line(case, random, -0.3, 1.3);
            let j = random.below(case.scene.objects.len());
            case.scene.objects[j].position = p;
        }
        4 => case.net_length *= random.within(0.2, 1.1),
        5 => {
            let angle = random.of_any_size(1e-3, 1.5);
            let until = (i + 1 + random.below(n)).min(n);
            for k in i..until {
                trajectory.left[k].heading += angle;
                trajectory.right[k].heading -= angle;
            }
        }
        6 => {
            let poses = if right {
                &mut trajectory.right
            } else {
                &mut trajectory.left
            };
            poses.swap(i, (i + 1).min(n - 1));
        }
        7 => {
            let bad = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308][random.below(4)];
            let poses = if right {
                &mut trajectory.right
            } else {
                &mut trajectory.left
            };
            match random.below(5) {
                0 => poses[i].x = bad,
                1 => poses[i].y = bad,
                2 => poses[i].heading = bad,
                3 => case.net_length = if bad > 1.0 { -1.0 } else { bad },
                _ => trajectory.step_time = bad.min(0.0),
            }
        }
        8 => trajectory.step_time *= random.within(0.3, 1.2),
        9 => {
            trajectory.left.remove(i);
            if right {
                trajectory.right.remove(i);
            }
        }
        10 => {
            let lag = 1 + random.below(6);
            let poses = if right {
                &mut trajectory.right
            } else {
                &mut trajectory.left
            };
            for k in (1..n).rev() {
                poses[k] = poses[k.saturating_sub(lag)];
            }
        }
        12 => case.scene.area.max.x -= random.within(0.0, 4.0),
        13 => {
            if let Some(map) = &mut case.scene.map {
                let p = trajectory.left[i]
                    .position()
                    .lerp(trajectory.right[i].position(), random.within(-0.5, 1.5));
                let cell = map.to_cells(p);
                map.blocked[cell.y as usize * map.columns + cell.x as usize] = true;
            } else {
                case.net_length = 0.0;
            }
        }
        14 => {
            // Everything after waypoint i turns about it.
            let angle = random.of_any_size(1e-4, 1.0);
            let pivot = trajectory.left[i].position();
            for poses in [&mut trajectory.left, &mut trajectory.right] {
                for pose in &mut poses[i + 1..] {
                    let d = pose.position() - pivot;
                    let turned = pivot + d * angle.cos() + d.perp() * angle.sin();
                    *pose = Pose::at(turned, pose.heading + angle);
                }
            }
        }
        _ => {
            let stretch = random.within(0.5, 1.6);
            for k in 0..n {
                let (l, r) = (
                    trajectory.left[k].position(),
                    trajectory.right[k].position(),
                );
                let (m, d) = (l.lerp(r, 0.5), (l - r) * (0.5 * stretch));
                trajectory.left[k] = Pose::at(m + d, trajectory.left[k].heading);
                trajectory.right[k] = Pose::at(m - d, trajectory.right[k].heading);
            }
        }
    }
}

#[test]
fn the_certificate_judges_mutations_as_brute_force_does() {
    let mut random = Random(2026);
    let cases = valid_plans(&mut random);
    for (i, case) in cases.iter().enumerate() {
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
        assert!(certificate.is_valid(), "plan {i}: {certificate:#?}");
    }
    let (mut judged, mut refused) = (0, 0);
    let mut unclear: BTreeMap<&str, usize> = BTreeMap::new();
    let mut failures: BTreeMap<&str, usize> = BTreeMap::new();
    let mut by_kind = [0; KINDS.len()];
    for round in 0..1280 {
        let kind = round % KINDS.len();
        let mut case = cases[random.below(cases.len())].clone();
        mutate(&mut case, kind, &mut random);
        let opinions = opinions(&case.scene, case.net_length, &case.trajectory);
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
        for ((name, opinion), claim) in opinions.iter().zip(&certificate.claims) {
            assert_eq!(*name, claim.id.name());
            match opinion {
                Opinion::Holds => assert!(claim.holds, "{}, round {round}: {claim:?}", KINDS[kind]),
                Opinion::Fails => {
                    assert!(!claim.holds, "{}, round {round}: {claim:?}", KINDS[kind]);
                    *failures.entry(name).or_default() += 1;
                }
                Opinion::Unclear => *unclear.entry(name).or_default() += 1,
            }
        }
        judged += 1;
        if opinions.iter().any(|(_, o)| *o == Opinion::Fails) {
            refused += 1;
            by_kind[kind] += 1;
            assert!(!certificate.is_valid());
        }
    }
    println!(
        "{judged} judged, {refused} refused; failures by claim {failures:?}; unclear {unclear:?}"
    );
    println!(
        "refused by kind {:?}",
        KINDS.iter().zip(by_kind).collect::<Vec<_>>()
    );
    // The test is worth something: most mutations break something, every kind does, and every claim is broken often.
    assert!(refused > judged / 2);
    assert!(by_kind.iter().all(|&n| n >= 10), "{by_kind:?}");
    assert_eq!(failures.len(), 14, "{failures:?}");
    assert!(failures.values().all(|&n| n >= 30), "{failures:?}");
    assert!(unclear.values().all(|&n| n < judged / 10), "{unclear:?}");
}
