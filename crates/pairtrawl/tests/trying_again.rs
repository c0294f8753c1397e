//! What the planner does where the first attempt fails, and where the time runs out.

use pairtrawl::files::parse_scene;
use pairtrawl::model::{Scene, SceneReference, Warning};
use pairtrawl::{NotFound, Observer, PlanError, PlanOptions, Planned, RehearsalMode, Stage, plan};
use std::time::Duration;

/// A wall with two gaps: 0.66 m on the straight way, too narrow for two robots of 0.48 m however they stagger, and 1.8 m.
const TWO_GAPS: &str = r#"
format = "pairtrawl-scene/1"
name = "two gaps"

[area]
min = [0.0, 0.0]
max = [8.0, 6.0]
resolution = 0.05

[[obstacles]]
box = [3.95, 0.0, 4.05, 1.7]

[[obstacles]]
box = [3.95, 2.36, 4.05, 4.2]

[[objects]]
position = [6.0, 2.0]
radius = 0.03
mass = 0.02

[start]
left = [1.0, 2.3]
right = [1.0, 1.7]
heading = 0.0

[end]
left = [7.2, 2.3]
right = [7.2, 1.7]
heading = 0.0
"#;

fn scene(text: &str) -> Scene {
    parse_scene(text, "scene.toml")
        .expect("the scene is good")
        .scene
}

fn planned(
    text: &str,
    options: &PlanOptions,
    observer: &mut dyn Observer,
) -> Result<Planned, PlanError> {
    plan(&scene(text), &SceneReference::default(), options, observer)
}

#[test]
fn a_pair_that_gets_stuck_in_a_narrow_gap_takes_the_wide_one() {
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let plan = planned(TWO_GAPS, &options, &mut ())
        .expect("there is a plan")
        .plan;
    assert!(plan.certificate.is_valid());
    let at_wall = (0..plan.trajectory.len()).find(|&i| plan.trajectory.pair(i).midpoint().x > 4.0);
    let passage = plan
        .trajectory
        .pair(at_wall.expect("it comes to the end"))
        .midpoint();
    assert!(passage.y > 4.2, "{passage:?}");
    let is_told = |warning: &Warning| matches!(warning, Warning::OtherStart { failed: 1, start } if start.contains("around"));
    assert!(plan.warnings.iter().any(is_told), "{:?}", plan.warnings);
}

#[test]
fn where_there_is_no_other_way_the_detours_that_were_tried_are_told() {
    let closed = TWO_GAPS.replace("4.05, 4.2]", "4.05, 6.0]");
    let refused = planned(&closed, &PlanOptions::default(), &mut ());
    match refused {
        Err(PlanError::NoPlan(refused)) => {
            let NotFound { tried, best, .. } = *refused;
            assert!(tried.len() > 1, "{tried:?}");
            assert!(best.is_some_and(|best| !best.certificate.is_valid()));
        }
        other => panic!("{other:?}"),
    }
}

/// A clock that jumps past every limit when a stage begins.
struct LateIn {
    stage: Stage,
    now: f64,
}

impl Observer for LateIn {
    fn started(&mut self, stage: Stage, _round: usize) {
        if stage == self.stage {
            self.now = 1e6;
        }
    }

    fn now(&self) -> f64 {
        self.now
    }
}

#[test]
fn the_certified_plan_at_hand_is_returned_when_the_time_is_up() {
    let options = PlanOptions {
        time_limit: Some(Duration::from_secs(60)),
        ..PlanOptions::default()
    };
    let late_in = |stage| LateIn { stage, now: 0.0 };
    let made = planned(TWO_GAPS, &options, &mut late_in(Stage::Rehearse));
    let made = made.expect("it is certified");
    assert!(made.plan.certificate.is_valid() && made.rehearsal.is_none());
    let is_told = |warning: &Warning| matches!(warning, Warning::TimeLimit { limit: 60.0, .. });
    assert!(
        made.plan.warnings.iter().any(is_told),
        "{:?}",
        made.plan.warnings
    );
    // Where a passed rehearsal is required, that is no plan; nor is one before there is a certificate.
    let require = PlanOptions {
        rehearsal: RehearsalMode::Require,
        ..options.clone()
    };
    for (options, stage) in [(&require, Stage::Rehearse), (&options, Stage::Optimize)] {
        let refused = planned(TWO_GAPS, options, &mut late_in(stage));
        let error = refused.expect_err("the time is up");
        assert_eq!(error, PlanError::TimeLimit { limit: 60.0, stage });
    }
}
