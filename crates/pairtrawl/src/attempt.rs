//! One attempt at a plan: baseline -> optimize -> certify, and what becomes of it.

use crate::check::{Candidate, check};
use crate::error::PlanError;
use crate::no_plan::NoPlan;
use crate::observer::Stage;
use crate::options::{Method, NetLength};
use crate::prepare::Prepared;
use crate::run::Run;
use crate::sampling::weighed;
use crate::tighten::Tightening;
use pairtrawl_certificate::certify;
use pairtrawl_execution::{ExecutionError, rehearse_while};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{
    Certificate, Claim, ClaimId, Overrides, PairTrajectory, Plan, Rehearsal, RehearsalRecord,
    Scales, SceneReference, SolverReport, SolverStatus, Warning,
};
use pairtrawl_reference::Reference;
use pairtrawl_route::{RouteError, baseline};
use pairtrawl_trajopt::{
    FirstLength, Problem, Residuals, Settings, ShrunkMargin, Solution, alternate, evaluate,
    optimize_from, optimize_watched,
};

/// A prepared scene and the order in which its circles are visited: what stays the same while attempts are made.
pub(crate) struct Course<'a> {
    pub prepared: &'a Prepared<'a>,
    pub order: &'a [usize],
}

/// What an attempt starts from, in units of the length scale.
pub(crate) enum Origin<'a> {
    /// A centerline, from which the baseline follows, and the pair to begin with where that is another one.
    Centerline(&'a [Pose], Option<&'a PairTrajectory>),
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

/// A claim that fails by more than this is out of reach, in units of the length scale or rad.
const HOPELESS: f64 = 0.04;

/// A pair of trajectories with its verdict, in m.
pub(crate) struct Attempt {
    pub net_length: f64,
    pub trajectory: PairTrajectory,
    /// When the reference passes the waypoints, s.
    time_law: Vec<f64>,
    pub certificate: Certificate,
    pub solver: SolverReport,
    centerline: Vec<Pose>,
    baseline: PairTrajectory,
    warnings: Vec<Warning>,
}

impl<'a> Course<'a> {
    pub fn new(prepared: &'a Prepared<'a>, order: &'a [usize]) -> Self {
        Self { prepared, order }
    }

    /// One attempt, as strict as the tightening says.
    pub fn attempt(
        &self,
        origin: &Origin,
        tightening: &Tightening,
        run: &mut Run,
    ) -> Result<Attempt, PlanError> {
        let Prepared {
            ref scene,
            ref scales,
            ref scaled,
            ref world,
            net_length,
            ..
        } = *self.prepared;
        let baseline = run
            .stage(Stage::Baseline, || self.baseline(origin, tightening))?
            .map_err(|error| self.prepared.route_error(error))?;
        let mut problem = Problem::new(scaled, net_length, &world.pieces);
        tightening.apply(&mut problem);
        let problem = weighed(&problem, &baseline);
        let solution = run.watched_stage(Stage::Optimize, |may_go_on| {
            self.optimize(&problem, &baseline, origin, &mut |_, _| may_go_on())
        })?;

        let trajectory = scales.trajectory(scene, &solution.trajectory);
        let net_length = self.prepared.meters(solution.net_length);
        // Without a reference nobody could drive it, whatever its waypoints prove.
        let reference = Reference::of_scene(scene, &trajectory)?;
        let certificate = run.unfinished_stage(Stage::Certify, |_| {
            certify(scene, net_length, &trajectory, Some(&reference))
        })?;
        let shrunk = solution.shrunk_margins.iter();
        let unpolished = self.unpolished(&solution);
        Ok(Attempt {
            net_length,
            trajectory,
            time_law: reference.time_law(),
            certificate,
            solver: SolverReport {
                status: solution.status,
                iterations: solution.iterations,
                kkt_error: solution.residual,
                seconds: run.seconds(Stage::Optimize),
            },
            centerline: (origin.centerline().iter())
                .map(|&pose| scales.pose(pose))
                .collect(),
            baseline: scales.trajectory(scene, &baseline),
            warnings: (shrunk.map(|margin| self.shrunk_margin(margin)))
                .chain(unpolished)
                .collect(),
        })
    }

    /// What a solved problem lacks of the residual that was asked for.
    fn unpolished(&self, solution: &Solution) -> Option<Warning> {
        let tolerance = self.prepared.options.tolerance?;
        let short = solution.status == SolverStatus::Converged && solution.residual > tolerance;
        short.then_some(Warning::NotPolished {
            residual: solution.residual,
            tolerance,
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
        let settings = Settings {
            tolerance: match self.prepared.options.method {
                Method::Joint => self.prepared.options.tolerance.unwrap_or(f64::INFINITY),
                // Its rounds end above the joint optimum anyway.
                Method::Alternating | Method::AlternatingBounded => f64::INFINITY,
            },
            ..origin.settings().settled()
        };
        let first_length = match (self.prepared.options.method, origin) {
            (Method::Joint, Origin::Centerline(..)) => {
                return optimize_watched(problem, start, &settings, go_on);
            }
            (Method::Joint, Origin::Before(_, net_length)) => {
                return optimize_from(problem, start, *net_length, &settings, go_on);
            }
            (Method::Alternating, _) => FirstLength::Printed,
            (Method::AlternatingBounded, _) => FirstLength::Bounded,
        };
        let scene = &self.prepared.scaled;
        alternate(scene, problem, start, first_length, &settings, go_on).solution
    }

    /// The trajectories that the optimization starts from.
    fn baseline(
        &self,
        origin: &Origin,
        tightening: &Tightening,
    ) -> Result<PairTrajectory, RouteError> {
        let (line, pair) = match *origin {
            Origin::Before(trajectory, _) => return Ok(trajectory.clone()),
            Origin::Centerline(line, pair) => (line, pair),
        };
        let given = self.prepared.options.waypoints_for(&self.prepared.scene);
        let first = match pair {
            Some(pair) => pair.clone(),
            None => self.baseline_along(line, given)?,
        };
        let more = (first.len() as f64 * tightening.waypoints).round() as usize;
        if given.is_none() && more > first.len() {
            return self.baseline_along(line, Some(more));
        }
        Ok(first)
    }

    fn baseline_along(
        &self,
        line: &[Pose],
        waypoints: Option<usize>,
    ) -> Result<PairTrajectory, RouteError> {
        let Prepared { world, scaled, .. } = self.prepared;
        baseline(world, scaled, line, self.order, waypoints)
    }

    /// Why no attempt is certified, after that number of rounds; `worst` fails by most in the best one.
    pub fn no_plan(&self, best: &Attempt, worst: &Claim, rounds: usize) -> NoPlan {
        let max_step = self.prepared.scene.planner.max_step;
        let (left, right) = best.baseline.path_lengths();
        let (waypoints, course) = (best.baseline.len(), left.max(right));
        if course > waypoints.saturating_sub(1) as f64 * max_step {
            return NoPlan::TooFewWaypoints {
                waypoints,
                max_step,
                course,
            };
        }
        NoPlan::ClaimFails {
            claim: worst.clone(),
            rounds,
            solver: best.solver.status,
        }
    }

    /// Drives an attempt in physics.
    pub fn rehearse(&self, attempt: &Attempt, run: &mut Run) -> Result<RehearsalRecord, PlanError> {
        let (net_length, trajectory) = (attempt.net_length, &attempt.trajectory);
        let options = pairtrawl_simulation::Options::default();
        let scene = &self.prepared.scene;
        let reference = Reference::of_scene(scene, trajectory)?;
        let record = run.watched_stage(Stage::Rehearse, |may_go_on| {
            rehearse_while(scene, net_length, &reference, &options, may_go_on)
        })?;
        Ok(record.map_err(ExecutionError::from)?)
    }

    /// A warning about a margin that the scene left no room for.
    fn shrunk_margin(&self, margin: &ShrunkMargin) -> Warning {
        let scales = &self.prepared.scales;
        Warning::MarginShrunk {
            claim: margin.claim,
            left: scales.meters(margin.left),
            wished: self.prepared.scene.planner.clearance,
            waypoint: margin.step,
            place: scales.place(margin.place),
        }
    }
}

impl Attempt {
    /// The claim that fails by most; `None` when all hold.
    pub fn worst(&self) -> Option<&Claim> {
        let failing = self.certificate.claims.iter().filter(|claim| !claim.holds);
        failing.min_by(|a, b| a.margin.total_cmp(&b.margin))
    }

    /// True when a claim fails by far more than what happens between waypoints, and the optimizer has found no way to mend it.
    pub fn is_hopeless(&self, scales: &Scales) -> bool {
        let mut failing = self.certificate.claims.iter().filter(|claim| !claim.holds);
        let by_far = |claim: &Claim| match claim.id {
            ClaimId::EveryObjectCovered => true,
            id if id.unit() == "m" => claim.margin < -HOPELESS * scales.length,
            _ => claim.margin < -HOPELESS,
        };
        self.solver.status != SolverStatus::Converged && failing.any(by_far)
    }

    /// The plan is to say that the time was up before this was done.
    pub fn warn_of_time_limit(&mut self, limit: f64, missing: &'static str) {
        self.warnings.push(Warning::TimeLimit { limit, missing });
    }

    /// How many claims fail.
    pub fn failures(&self) -> usize {
        let failing = self.certificate.claims.iter().filter(|claim| !claim.holds);
        failing.count()
    }

    /// The plan is to say that other starts failed before this one.
    pub fn warn_of_other_start(&mut self, failed: usize, start: String) {
        self.warnings.push(Warning::OtherStart { failed, start });
    }

    /// The same as the picture of a search that failed needs it: it is no plan and names no scene.
    pub fn into_no_plan(self, course: &Course, record: Option<&RehearsalRecord>) -> Plan {
        self.into_plan(course, &SceneReference::default(), record)
    }

    /// The plan that it becomes, with every claim of its file and the verdict of its rehearsal.
    pub fn into_plan(
        mut self,
        course: &Course,
        reference: &SceneReference,
        record: Option<&RehearsalRecord>,
    ) -> Plan {
        let Prepared {
            ref scene,
            options,
            ref scales,
            ref world,
            ref left_out,
            ..
        } = *course.prepared;
        let rehearsal = record.map_or(Rehearsal::Skipped, |record| record.verdict.clone());
        if let Rehearsal::Failed { event, time, place } = &rehearsal {
            self.warnings.push(Warning::RehearsalFails {
                event: event.clone(),
                time: *time,
                place: *place,
            });
        }
        let overrides = Overrides {
            net_length: options.net_length.map(NetLength::fixed),
            leave: options.leave,
        };
        let candidate = Candidate {
            net_length: self.net_length,
            trajectory: &self.trajectory,
            scene: Some(reference),
            overrides: &overrides,
            time_law: Some(&self.time_law),
            left_out,
        };
        Plan {
            certificate: check(scene, reference, &candidate),
            cost: evaluate(scene, &self.trajectory, self.net_length),
            net_length: self.net_length,
            scene: reference.clone(),
            overrides,
            circles: world.circles.iter().map(|c| scales.circle(c)).collect(),
            order: course.order.to_vec(),
            left_out: left_out.clone(),
            centerline: self.centerline,
            baseline: self.baseline,
            time_law: self.time_law,
            trajectory: self.trajectory,
            rehearsal,
            solver: self.solver,
            warnings: self.warnings,
        }
    }
}
