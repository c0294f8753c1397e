//! Many runs with everything unknown drawn at random, in full physics or on reduced plants: which law keeps the pair on its path?

use crate::ExecutionError;
use crate::full_run::FullRun;
use crate::monte_carlo_options::{MonteCarloOptions, Plants};
use crate::observer::ExecutionObserver;
use crate::options::controller_parameters;
use crate::outcome::Outcome;
use crate::plant::{Drag, PlantParameters};
use crate::reduced_run::ReducedRun;
use crate::sensing::{Normal, Sensing};
use crate::statistics::{mixed_seed, quantile};
use pairtrawl_control::SupervisorLimits;
use pairtrawl_model::{ControllerKind, PairTrajectory, Scene};
use pairtrawl_parallel::prelude::*;
use pairtrawl_reference::Reference;

/// What one law did.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarloRow {
    /// The law.
    pub controller: ControllerKind,
    /// Runs that were finished.
    pub runs: usize,
    /// Of these, how many stayed within the tolerance and reached the end.
    pub successes: usize,
    /// Of these, how many the supervisor stopped.
    pub stopped: usize,
    /// Runs that did not succeed and asked a wheel (in full physics: a robot) for more force than its tires can pass to the floor:
    /// no law could.
    pub failures_beyond_traction: usize,
    /// 50, 90 and 99 % quantiles of a run's root mean square error, m, after the first second and until the end or the stop.
    pub rms: [f64; 3],
    /// The same of a run's greatest error, m.
    pub max: [f64; 3],
    /// Greatest torque of a wheel in any run, N m.
    pub max_torque: f64,
    /// In full physics: mean number of objects in the net at the end of a run, those that the plan leaves not counted.
    pub gathered: Option<f64>,
}

/// The table.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarlo {
    /// One row for each law of which at least one run was finished.
    pub rows: Vec<MonteCarloRow>,
    /// Runs that were finished, over all laws.
    pub runs: usize,
    /// Runs that were asked for, over all laws.
    pub runs_wanted: usize,
    /// True when it was stopped before all runs were finished.
    pub interrupted: bool,
}

/// Runs the table. The observer's index counts runs over all laws.
///
/// # Errors
/// When the trajectory or an option cannot be used.
pub fn monte_carlo(
    scene: &Scene,
    trajectory: &PairTrajectory,
    options: &MonteCarloOptions,
    observer: &dyn ExecutionObserver,
) -> Result<MonteCarlo, ExecutionError> {
    let reference = Reference::of_scene(scene, trajectory)?;
    let full = match options.plants {
        Plants::Reduced => None,
        Plants::Full {
            net_length,
            physics,
        } => Some(FullRun {
            scene,
            trajectory,
            reference: &reference,
            net_length,
            physics,
            options,
        }),
    };
    let mut rows = Vec::new();
    for (row, &controller) in options.controllers.iter().enumerate() {
        let outcomes = (0..options.runs)
            .into_par_iter()
            .map(|run| {
                if observer.interrupted() {
                    return Ok(None);
                }
                let outcome = match &full {
                    Some(full) => full.drive(controller, run as u64, observer)?,
                    None => one_run(scene, &reference, options, controller, run as u64, observer)?,
                };
                if outcome.is_some() {
                    observer.finished(row * options.runs + run);
                }
                Ok(outcome)
            })
            .collect::<Result<Vec<_>, ExecutionError>>()?;
        let finished: Vec<Outcome> = outcomes.into_iter().flatten().collect();
        if !finished.is_empty() {
            let mut row = summarize(controller, &finished, options.tolerance);
            row.gathered = row.gathered.filter(|_| full.is_some());
            rows.push(row);
        }
    }
    let runs = rows.iter().map(|row: &MonteCarloRow| row.runs).sum();
    let runs_wanted = options.runs * options.controllers.len();
    Ok(MonteCarlo {
        rows,
        runs,
        runs_wanted,
        interrupted: runs < runs_wanted,
    })
}

fn one_run(
    scene: &Scene,
    reference: &Reference,
    options: &MonteCarloOptions,
    kind: ControllerKind,
    run: u64,
    observer: &dyn ExecutionObserver,
) -> Result<Option<Outcome>, ExecutionError> {
    // Drawn from the run's own seed, so that every law meets the same conditions.
    let seed = mixed_seed(options.seed, run);
    let mut draw = Normal::new(seed);
    let mut plants = || {
        let mass = draw.between(options.mass_factor);
        PlantParameters::new(
            &scene.robot,
            &scene.physics,
            mass,
            draw.between(options.inertia_factor),
        )
    };
    let plants = [plants(), plants()];
    let delay = draw.between(options.delay);
    let sensing = Sensing {
        position_noise: options.position_noise,
        heading_noise: options.heading_noise,
        pose_delay: delay,
        velocity_delay: if options.delayed_velocity {
            delay
        } else {
            Sensing::default().velocity_delay
        },
        ..Sensing::default()
    };
    let drags = [(); 2].map(|()| GrowingDrag::draw(&mut draw, options.drag, reference.duration()));
    let run = ReducedRun {
        reference,
        controller: controller_parameters(scene, kind, options.nominal_inertia),
        supervisor: SupervisorLimits::default(),
        sensing: [sensing; 2],
        plants,
        drag: &|time| drags.each_ref().map(|d| d.at(time)),
        seeds: [mixed_seed(seed, 1), mixed_seed(seed, 2)],
    };
    let beyond_traction = (plants.iter().zip(&drags))
        .any(|(plant, drag)| drag.greatest_wheel_force(plant) > plant.traction);
    Ok(run.drive(observer)?.map(|outcome| Outcome {
        tracking: outcome.tracking,
        stopped: outcome.stopped.is_some(),
        max_torque: outcome.max_torque,
        beyond_traction,
        gathered: 0,
    }))
}

/// A drag that grows in eight even steps and whose direction swings.
#[derive(Clone, Copy, Debug)]
pub struct GrowingDrag {
    /// In the end, N.
    pub force: f64,
    /// Duration of the run, s.
    pub duration: f64,
    /// Amplitude of the direction, rad.
    pub swing: f64,
    /// Period of the direction, s.
    pub period: f64,
    /// Phase of the direction, rad.
    pub phase: f64,
}

/// Steps of a growing drag.
const DRAG_STEPS: f64 = 8.0;

impl GrowingDrag {
    fn draw(draw: &mut Normal, force: [f64; 2], duration: f64) -> Self {
        Self {
            force: draw.between(force),
            duration,
            swing: draw.between([0.0, std::f64::consts::FRAC_PI_3]),
            period: draw.between([5.0, 20.0]),
            phase: draw.between([0.0, std::f64::consts::TAU]),
        }
    }

    /// The greatest force that standing against it asks of one wheel, N.
    fn greatest_wheel_force(&self, plant: &PlantParameters) -> f64 {
        // cos a + (hitch / R) sin a is greatest where tan a = hitch / R.
        let lever = plant.hitch / plant.half_track;
        let angle = self.swing.min(libm::atan(lever));
        0.5 * self.force * (libm::cos(angle) + lever * libm::sin(angle))
    }

    /// The drag at a time, s.
    pub fn at(&self, time: f64) -> Drag {
        let step = (time / self.duration * DRAG_STEPS)
            .ceil()
            .clamp(0.0, DRAG_STEPS);
        let angle = std::f64::consts::TAU * time / self.period + self.phase;
        Drag {
            force: self.force * step / DRAG_STEPS,
            direction: self.swing * libm::sin(angle),
        }
    }
}

fn summarize(controller: ControllerKind, runs: &[Outcome], tolerance: f64) -> MonteCarloRow {
    let succeeds = |r: &Outcome| !r.stopped && r.worst() <= tolerance;
    let quantiles = |value: &dyn Fn(&Outcome) -> f64| {
        let mut values: Vec<f64> = runs.iter().map(value).collect();
        [0.5, 0.9, 0.99].map(|q| quantile(&mut values, q))
    };
    MonteCarloRow {
        controller,
        runs: runs.len(),
        successes: runs.iter().filter(|r| succeeds(r)).count(),
        stopped: runs.iter().filter(|r| r.stopped).count(),
        failures_beyond_traction: runs
            .iter()
            .filter(|r| !succeeds(r) && r.beyond_traction)
            .count(),
        rms: quantiles(&Outcome::rms),
        max: quantiles(&Outcome::worst),
        max_torque: runs.iter().map(|r| r.max_torque).fold(0.0, f64::max),
        gathered: Some(runs.iter().map(|r| r.gathered as f64).sum::<f64>() / runs.len() as f64),
    }
}
