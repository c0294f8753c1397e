//! Plan files: what is written reads back as the same bits, foreign plans are read, writing is all or nothing.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl::files::{
    csv_text, parse_plan, plan_json, read_plan, read_scene, tum_text, write_atomically, write_plan,
};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Certificate, Circle, Claim, ClaimId, Cost, Leave, LeftOut, LeftWhy, Overrides, PairTrajectory,
    Plan, Rehearsal, SceneReference, Side, SolverReport, SolverStatus,
};
use pairtrawl_reference::{Reference, ReferenceLimits};
use std::path::{Path, PathBuf};

fn plan() -> Plan {
    let poses = |y: f64| {
        (0..3)
            .map(|i| Pose::new(0.1 + f64::from(i) / 3.0, y, -0.1 * f64::from(i)))
            .collect::<Vec<_>>()
    };
    let trajectory = PairTrajectory {
        left: poses(0.7),
        right: poses(0.1),
        step_time: 0.248,
    };
    Plan {
        net_length: 1.0 / 3.0,
        baseline: trajectory.clone(),
        centerline: poses(0.4),
        trajectory,
        scene: SceneReference {
            name: "hall \"A\"".to_owned(),
            sha256: "00ff".to_owned(),
            content_sha256: Some("01fe".to_owned()),
        },
        time_law: Vec::new(),
        overrides: Overrides {
            net_length: Some(None),
            leave: Some(Leave::Unreachable),
        },
        circles: vec![Circle {
            center: Point::new(1.5, 2.5),
            radius: 0.3,
            objects: vec![3, 4],
        }],
        order: vec![0],
        left_out: vec![
            LeftOut {
                object: 1,
                why: LeftWhy::Proven,
                text: "pinned".to_owned(),
            },
            LeftOut {
                object: 7,
                why: LeftWhy::NotFound,
                text: "tried".to_owned(),
            },
        ],
        cost: Cost {
            smoothness: 1.0,
            distance: 2.0,
            obstacle: 0.0,
            expansion: 0.5,
        },
        certificate: Certificate {
            claims: vec![
                Claim {
                    id: ClaimId::Step,
                    holds: true,
                    margin: 0.25,
                    step: Some(1),
                    place: Some(Point::new(1.0, 2.0)),
                    detail: String::new(),
                },
                Claim {
                    id: ClaimId::Speed,
                    holds: true,
                    margin: f64::INFINITY,
                    step: None,
                    place: None,
                    detail: "left".to_owned(),
                },
            ],
        },
        rehearsal: Rehearsal::Failed {
            event: "snag".to_owned(),
            time: 1.5,
            place: Point::new(0.5, 0.25),
        },
        solver: SolverReport {
            status: SolverStatus::Converged,
            iterations: 31,
            kkt_error: 1e-7,
            seconds: 0.012,
        },
        warnings: vec![pairtrawl_model::Warning::Stated("narrow".to_owned())],
    }
}

#[test]
fn every_field_of_the_format_is_written() {
    let text = plan_json(&plan()).unwrap();
    let json: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(json["format"], "pairtrawl-plan/1");
    assert_eq!(json["left"][2][0], 0.1 + 2.0 / 3.0);
    assert_eq!(json["step_time"], 0.248);
    assert_eq!(json["scene"]["name"], "hall \"A\"");
    assert_eq!(json["overrides"]["net_length"], "auto");
    assert_eq!(json["baseline"]["right"][0][1], 0.1);
    assert_eq!(json["circles"][0]["objects"][1], 4);
    assert_eq!(json["order"][0], 0);
    assert_eq!(json["cost"]["total"], 3.5);
    assert_eq!(json["certificate"]["valid"], true);
    assert_eq!(json["certificate"]["claims"][0]["where"][1], 2.0);
    assert!(json["certificate"]["claims"][1]["margin"].is_null());
    assert_eq!(json["rehearsal"]["status"], "failed");
    assert_eq!(json["rehearsal"]["where"][0], 0.5);
    assert_eq!(json["solver"]["status"], "converged");
    assert_eq!(json["warnings"][0], "narrow");
    let mut positions: Vec<usize> = [
        "format",
        "net_length",
        "left",
        "right",
        "step_time",
        "scene",
        "cost",
        "certificate",
        "solver",
    ]
    .iter()
    .map(|k| text.find(&format!("\"{k}\":")).unwrap())
    .collect();
    let as_written = positions.clone();
    positions.sort_unstable();
    assert_eq!(positions, as_written);
}

#[test]
fn a_written_plan_reads_back_as_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.json");
    let plan = plan();
    write_plan(&path, &plan).unwrap();
    let read = read_plan(&path).unwrap();
    assert_eq!(read.net_length.to_bits(), plan.net_length.to_bits());
    assert_eq!(
        (&read.left, &read.right, read.step_time),
        (&plan.trajectory.left, &plan.trajectory.right, Some(0.248))
    );
    assert_eq!(
        (read.scene.as_ref(), read.overrides),
        (Some(&plan.scene), plan.overrides)
    );
    assert_eq!(
        (&read.centerline, &read.circles, &read.order, &read.left_out),
        (&plan.centerline, &plan.circles, &plan.order, &plan.left_out)
    );
    assert_eq!(
        (&read.rehearsal, &read.solver),
        (&plan.rehearsal, &plan.solver)
    );
    assert_eq!(
        (read.cost, read.baseline),
        (
            Some(plan.cost),
            Some((plan.baseline.left, plan.baseline.right))
        )
    );
    // Nothing else is left in the folder.
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn overrides_take_three_forms() {
    for choice in [None, Some(None), Some(Some(2.5))] {
        let plan = Plan {
            overrides: Overrides {
                net_length: choice,
                leave: None,
            },
            ..plan()
        };
        let read = parse_plan(&plan_json(&plan).unwrap(), Path::new("plan.json")).unwrap();
        assert_eq!(read.overrides.net_length, choice);
    }
}

#[test]
fn a_solver_or_rehearsal_stated_in_another_way_is_not_stated() {
    let mut json: serde_json::Value = serde_json::from_str(&plan_json(&plan()).unwrap()).unwrap();
    for foreign in [
        serde_json::json!("ipopt 3.14"),
        serde_json::json!({ "status": "solved" }),
        serde_json::json!({ "status": "optimal", "iterations": 5, "kkt_error": null, "seconds": 0.1 }),
    ] {
        json["solver"] = foreign.clone();
        json["rehearsal"] = foreign;
        let read = parse_plan(&json.to_string(), Path::new("plan.json")).unwrap();
        assert_eq!(read.solver.status, SolverStatus::NotStated);
        assert_eq!(read.rehearsal, Rehearsal::Skipped);
    }
}

#[test]
fn every_witness_is_read_and_lacks_may_be_filled() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let witnesses: Vec<PathBuf> = (1..=9)
        .map(|i| scenes.join(format!("witness-{i}")))
        .collect();
    for folder in &witnesses {
        let scene = read_scene(&folder.join("scene.toml")).unwrap().scene;
        let read = read_plan(&folder.join("witness.json")).unwrap();
        assert_eq!(Some(read.net_length), scene.net.length);
        assert_eq!(read.trajectory(&scene).step_time, 0.3);
        let without = pairtrawl::files::PlanFile {
            step_time: None,
            ..read
        };
        assert!((without.trajectory(&scene).step_time - 0.064_4 / 0.26).abs() < 1e-12);
    }
}

#[test]
fn csv_and_tum_have_a_line_for_each_waypoint_of_what_is_driven() {
    let poses = |y: f64| {
        let place = |i: i32| Point::new(0.1, y) + Point::unit(-0.2) * (f64::from(i) / 30.0);
        (0..3).map(|i| Pose::at(place(i), -0.2)).collect::<Vec<_>>()
    };
    let t = PairTrajectory {
        left: poses(0.7),
        right: poses(0.1),
        step_time: 0.248,
    };
    let limits = ReferenceLimits::of(&Default::default());
    let r = Reference::new(&Default::default(), &Default::default(), &t, &limits).unwrap();
    let csv = csv_text(&r);
    let lines: Vec<&str> = csv.lines().collect();
    assert_eq!(
        lines[0],
        "t,left_x,left_y,left_heading,right_x,right_y,right_heading,left_v,left_omega,right_v,right_omega"
    );
    assert_eq!(lines.len(), 4);
    let rows: Vec<Vec<f64>> = lines[1..]
        .iter()
        .map(|line| line.split(',').map(|x| x.parse().unwrap()).collect())
        .collect();
    // Poses are the plan's own bits, velocities those of the reference: none at both ends.
    for (i, row) in rows.iter().enumerate() {
        let (l, r) = (t.left[i], t.right[i]);
        assert_eq!(row[1..7], [l.x, l.y, l.heading, r.x, r.y, r.heading]);
    }
    let [left, right] = r.at(r.waypoint_time(1));
    assert_eq!(rows[1][0], r.waypoint_time(1));
    assert_eq!(rows[1][7..], [left.v, left.omega, right.v, right.omega]);
    assert!(left.v > 0.05 && rows[0][7..] == [0.0; 4] && rows[2][7..] == [0.0; 4]);

    let tum = tum_text(&r, Side::Left);
    let row: Vec<f64> = tum
        .lines()
        .nth(2)
        .unwrap()
        .split(' ')
        .map(|x| x.parse().unwrap())
        .collect();
    assert_eq!(row.len(), 8);
    assert_eq!(
        (row[0], row[1], row[2], row[3]),
        (r.duration(), t.left[2].x, t.left[2].y, 0.0)
    );
    assert!(
        (2.0 * row[6].atan2(row[7]) - t.left[2].heading).abs() < 1e-15
            && row[4] == 0.0
            && row[5] == 0.0
    );
}

#[test]
fn a_failed_write_comes_from_the_system_and_leaves_no_trace() {
    let folder = tempfile::tempdir().unwrap();
    let error = write_atomically(&folder.path().join("missing/plan.json"), b"x").unwrap_err();
    assert!(error.is_from_system());
    // A folder stands where the file should go.
    let target = folder.path().join("plan.json");
    std::fs::create_dir(&target).unwrap();
    assert!(
        write_atomically(&target, b"x")
            .unwrap_err()
            .is_from_system()
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[cfg(unix)]
#[test]
fn a_result_replaces_the_old_one_and_can_be_read_by_others() {
    use std::os::unix::fs::PermissionsExt;
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plan.csv");
    write_atomically(&path, b"old").unwrap();
    write_atomically(&path, b"new").unwrap();
    assert_eq!(std::fs::read(&path).unwrap(), b"new");
    let plain = folder.path().join("plain");
    std::fs::write(&plain, b"x").unwrap();
    let mode = |p: &Path| std::fs::metadata(p).unwrap().permissions().mode();
    assert_eq!(mode(&path), mode(&plain));
}

#[test]
fn a_comment_leaves_the_content_hash_and_a_number_changes_it() {
    let text = include_str!("../../../scenes/paper-experiment/scene.toml");
    let reference = |text: &str| {
        pairtrawl::files::parse_scene(text, "scene")
            .expect("a scene")
            .reference
    };
    let (plain, commented) = (reference(text), reference(&format!("# note\n{text}\n")));
    assert_ne!(plain.sha256, commented.sha256);
    assert_eq!(plain.content_sha256, commented.content_sha256);
    assert!(plain.content_sha256.is_some());
    // Each of these changes one thing that the scene says.
    for (table, line) in [
        ("robot", "half_track = 0.1441"),
        ("planner", "k1 = 1e6"),
        ("physics", "net_mass = 0.021"),
        ("planner", "waypoints = 300"),
    ] {
        let header = format!("[{table}]");
        let changed = if text.contains(&header) {
            text.replace(&header, &format!("{header}\n{line}"))
        } else {
            format!("{text}\n{header}\n{line}\n")
        };
        assert_ne!(
            plain.content_sha256,
            reference(&changed).content_sha256,
            "{line}"
        );
    }
}
