use crate::check::{Candidate, check};
use crate::run::Run;
use crate::tighten::Tightening;
use crate::{Method, NetLength, PlanError, PlanOptions, RehearsalMode, Stage};
use pairtrawl_certificate::certify;
use pairtrawl_geometry::Pose;
use pairtrawl_model::{
    Certificate, ClaimId, Overrides, PairTrajectory, Plan, Rehearsal, RehearsalRecord, Scales,
    Scene, SceneReference, SolverReport,
};
use pairtrawl_reference::Reference;
use pairtrawl_route::{RouteError, baseline};
use pairtrawl_simulation::rehearse;
use pairtrawl_trajopt::{
    FirstLength, Problem, Residuals, Settings, ShrunkMargin, Solution, alternate, evaluate,
    optimize_from, optimize_watched,
};
use pairtrawl_world::World;

/// Everything that stays the same while attempts at a plan are made.
pub(crate) struct Course<'a> {
    pub scene: &'a Scene,
    pub scales: Scales,
    /// The scene in units of the length scale, as all that the planning stages see.
    pub scaled: &'a Scene,
    /// d_max, in units of the length scale; `None`: the optimizer chooses it.
    pub net_length: Option<f64>,
    pub world: &'a World,
    pub order: &'a [usize],
    pub options: &'a PlanOptions,
}

/// What an attempt starts from, in units of the length scale.
pub(crate) enum Origin<'a> {
    /// A centerline, from which the baseline follows, and the pair to begin with where that is another one.
    Centerline(Vec<Pose>, Option<PairTrajectory>),
    /// The rest of a plan that was made before, and its net length.
    Before(&'a PairTrajectory, f64),
}

impl Origin<'_> {
    fn centerline(&self) -> &[Pose] {
        match self {
            Self::Centerline(line, _) => line,
            Self::Before(..) => &[],
        }
    }

    /// From a good start the barrier begins low.
    fn settings(&self) -> Settings {
        match self {
            Self::Centerline(..) => Settings::default(),
            Self::Before(..) => Settings::warm(),
        }
    }
}

/// A pair of trajectories with its verdict, in m.
pub(crate) struct Attempt {
    pub net_length: f64,
    pub trajectory: PairTrajectory,
    pub centerline: Vec<Pose>,
    pub baseline: PairTrajectory,
    pub certificate: Certificate,
    pub solver: SolverReport,
    pub warnings: Vec<String>,
}

impl Course<'_> {
    /// A certified attempt, and its rehearsal unless that is to be skipped. One whose rehearsal fails is made again with
    /// more margin, a bounded number of times; the one with the fewest events counts.
    pub fn rehearsed_attempt(
        &self,
        origin: &Origin,
        run: &mut Run,
    ) -> Result<(Attempt, Option<RehearsalRecord>), PlanError> {
        let mut tightening = Tightening::NONE;
        let mut best = self.certified_attempt(origin, &mut tightening, run)?;
        if self.options.rehearsal == RehearsalMode::Skip {
            return Ok((best, None));
        }
        let mut record = self.rehearse(&best, run)?;
        let mut event = record.events.first().cloned();
        for _ in 0..self.options.rehearsal_rounds {
            let Some(failed) = event else { break };
            run.note(&format!(
                "rehearsal: {}; planning again with more margin",
                failed.kind.describe()
            ));
            tightening = tightening.after_event(&failed.kind);
            run.round += 1;
            match self.certified_attempt(origin, &mut tightening, run) {
                Ok(next) => {
                    let next_record = self.rehearse(&next, run)?;
                    event = next_record.events.first().cloned();
                    if next_record.events.len() < record.events.len() {
                        (best, record) = (next, next_record);
                    }
                }
                // With more margin there is no plan any more: the one at hand stays.
                Err(PlanError::NoPlan { .. }) => break,
                Err(error) => return Err(error),
            }
        }
        if self.options.rehearsal == RehearsalMode::Require && record.verdict != Rehearsal::Passed {
            return Err(PlanError::not_rehearsed(&record.verdict));
        }
        Ok((best, Some(record)))
    }

    /// An attempt whose every claim holds: optimizes, certifies, tightens where a claim fails, and tries again within the
    /// budget of rounds.
    pub fn certified_attempt(
        &self,
        origin: &Origin,
        tightening: &mut Tightening,
        run: &mut Run,
    ) -> Result<Attempt, PlanError> {
        let mut best = self.attempt(origin, tightening, run)?;
        for _ in 1..self.options.rounds {
            if best.certificate.is_valid() {
                break;
            }
            *tightening = tightening.after_claims(&best.certificate, &self.scales);
            run.round += 1;
            let next = self.attempt(origin, tightening, run)?;
            if next.failures() <= best.failures() {
                best = next;
            }
        }
        if best.certificate.is_valid() {
            Ok(best)
        } else {
            Err(PlanError::no_plan(
                &best,
                self.options.rounds,
                self.scene.planner.max_step,
            ))
        }
    }

    /// One attempt.
    fn attempt(
        &self,
        origin: &Origin,
        tightening: &Tightening,
        run: &mut Run,
    ) -> Result<Attempt, PlanError> {
        let Self {
            scene,
            scales,
            world,
            ..
        } = *self;
        let baseline = run
            .stage(Stage::Baseline, || self.baseline(origin, tightening))?
            .map_err(|error| error.in_meters(scales.length))?;
        let mut problem = Problem::new(self.scaled, self.net_length, &world.pieces);
        tightening.apply(&mut problem);
        let solution = run.watched_stage(Stage::Optimize, |may_go_on| {
            self.optimize(&problem, &baseline, origin, &mut |_, _| may_go_on())
        })?;

        let trajectory = scales.trajectory(scene, &solution.trajectory);
        let net_length = self.meters(solution.net_length);
        let certificate = run.stage(Stage::Certify, || {
            // A trajectory without a reference fails its claims for the same reason.
            let reference = Reference::of_scene(scene, &trajectory).ok();
            certify(scene, net_length, &trajectory, reference.as_ref())
        })?;
        Ok(Attempt {
            warnings: solution
                .shrunk_margins
                .iter()
                .map(|margin| shrunk_margin(scene, &scales, margin))
                .collect(),
            solver: SolverReport {
                status: solution.status,
                iterations: solution.iterations,
                kkt_error: solution
                    .residuals
                    .dual
                    .max(solution.residuals.primal)
                    .max(solution.residuals.complementarity),
                seconds: run.seconds(Stage::Optimize),
            },
            net_length,
            trajectory,
            centerline: origin
                .centerline()
                .iter()
                .map(|&p| scales.pose(p))
                .collect(),
            baseline: scales.trajectory(scene, &baseline),
            certificate,
        })
    }

    /// The optimization by the method that was asked for.
    fn optimize(
        &self,
        problem: &Problem,
        start: &PairTrajectory,
        origin: &Origin,
        go_on: &mut dyn FnMut(usize, &Residuals) -> bool,
    ) -> Solution {
        let settings = origin.settings();
        let first_length = match (self.options.method, origin) {
            (Method::Joint, Origin::Centerline(..)) => {
                return optimize_watched(problem, start, &settings, go_on);
            }
            (Method::Joint, Origin::Before(_, net_length)) => {
                return optimize_from(problem, start, *net_length, &settings, go_on);
            }
            (Method::Alternating, _) => FirstLength::Printed,
            (Method::AlternatingBounded, _) => FirstLength::Bounded,
        };
        alternate(self.scaled, problem, start, first_length, &settings, go_on).solution
    }

    /// The trajectories that the optimization starts from.
    fn baseline(
        &self,
        origin: &Origin,
        tightening: &Tightening,
    ) -> Result<PairTrajectory, RouteError> {
        let Self {
            scaled: scene,
            world,
            order,
            options,
            ..
        } = *self;
        let (line, pair) = match origin {
            Origin::Before(trajectory, _) => return Ok((*trajectory).clone()),
            Origin::Centerline(line, pair) => (line, pair),
        };
        let given = options.waypoints.or(scene.planner.waypoints);
        let first = match pair {
            Some(pair) => pair.clone(),
            None => baseline(world, scene, line, order, given)?,
        };
        let more = (first.len() as f64 * tightening.waypoints).round() as usize;
        if given.is_none() && more > first.len() {
            return baseline(world, scene, line, order, Some(more));
        }
        Ok(first)
    }

    /// A length that the optimizer returns, m. One that was given comes back as it was.
    fn meters(&self, length: f64) -> f64 {
        let given = self.options.net_length_for(self.scene);
        given
            .filter(|&given| self.scales.scaled(given) == length)
            .unwrap_or(self.scales.meters(length))
    }

    fn rehearse(&self, attempt: &Attempt, run: &mut Run) -> Result<RehearsalRecord, PlanError> {
        let options = pairtrawl_simulation::Options::default();
        Ok(run.stage(Stage::Rehearse, || {
            rehearse(
                self.scene,
                attempt.net_length,
                &attempt.trajectory,
                &options,
            )
        })??)
    }
}

impl Attempt {
    /// The plan that it becomes, with every claim of its file and the verdict of its rehearsal.
    pub fn into_plan(
        mut self,
        course: &Course,
        reference: &SceneReference,
        record: Option<&RehearsalRecord>,
    ) -> Plan {
        let scene = course.scene;
        if let Some(Rehearsal::Failed { event, time, place }) = record.map(|record| &record.verdict)
        {
            let (x, y) = (place.x, place.y);
            self.warnings.push(format!(
                "the plan is certified, but its rehearsal fails: {event} at {time:.1} s near ({x:.3}, {y:.3})"
            ));
        }
        let overrides = Overrides {
            net_length: course.options.net_length.map(|length| match length {
                NetLength::Auto => None,
                NetLength::Fixed(length) => Some(length),
            }),
        };
        let time_law = Reference::of_scene(scene, &self.trajectory)
            .map(|law| law.time_law())
            .unwrap_or_default();
        let candidate = Candidate {
            net_length: self.net_length,
            trajectory: &self.trajectory,
            scene: Some(reference),
            overrides: &overrides,
            time_law: Some(&time_law),
        };
        Plan {
            certificate: check(scene, reference, &candidate),
            cost: evaluate(scene, &self.trajectory, self.net_length),
            net_length: self.net_length,
            scene: reference.clone(),
            overrides,
            circles: course
                .world
                .circles
                .iter()
                .map(|c| course.scales.circle(c))
                .collect(),
            order: course.order.to_vec(),
            centerline: self.centerline,
            baseline: self.baseline,
            time_law,
            trajectory: self.trajectory,
            rehearsal: record.map_or(Rehearsal::Skipped, |record| record.verdict.clone()),
            solver: self.solver,
            warnings: self.warnings,
        }
    }

    /// How many claims fail.
    fn failures(&self) -> usize {
        self.certificate
            .claims
            .iter()
            .filter(|claim| !claim.holds)
            .count()
    }
}

/// A warning about a margin that the scene left no room for.
fn shrunk_margin(scene: &Scene, scales: &Scales, margin: &ShrunkMargin) -> String {
    let what = match margin.claim {
        ClaimId::NetEnclosesNoObstacle => "between net and obstacle",
        ClaimId::RobotsMissObjects => "between robot and object",
        _ => "between robot and obstacle",
    };
    let place = scales.place(margin.place);
    format!(
        "the margin {what} shrinks to {:.3} m of the {:.3} m wished for, at waypoint {} near ({:.3}, {:.3})",
        scales.meters(margin.left),
        scene.planner.clearance,
        margin.step,
        place.x,
        place.y
    )
}
