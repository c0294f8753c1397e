//! What is kept of a drive in physics.

use crate::control_loop::PairLoop;
use crate::sample::pair_pose;
use crate::statistics::ErrorCollector;
use pairtrawl_control::AdaptedParameters;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ControlSample, DragStatistics, Side, TrackingStatistics};
use pairtrawl_reference::Sample;
use pairtrawl_simulation::Simulation;

/// Drag is a mean over this long, s: contacts ring from step to step.
const DRAG_WINDOW: f64 = 0.02;

/// Errors, drag and samples of a drive.
pub(crate) struct Collector {
    errors: [ErrorCollector; 2],
    window: [Point; 2],
    window_steps: u64,
    window_every: u64,
    drag: [f64; 2],
    drag_sum: [f64; 2],
    drag_max: [f64; 2],
    windows: f64,
    max_torque: [f64; 2],
    samples: Vec<ControlSample>,
    sample_interval: f64,
}

impl Collector {
    pub fn new(time_step: f64, sample_interval: f64) -> Self {
        Self {
            errors: [ErrorCollector::default(); 2],
            window: [Point::ZERO; 2],
            window_steps: 0,
            window_every: (DRAG_WINDOW / time_step).round().max(1.0) as u64,
            drag: [0.0; 2],
            drag_sum: [0.0; 2],
            drag_max: [0.0; 2],
            windows: 0.0,
            max_torque: [0.0; 2],
            samples: Vec::new(),
            sample_interval,
        }
    }

    /// Force of net and contacts on each robot, mean over the last window, N.
    pub fn drag(&self) -> [f64; 2] {
        self.drag
    }

    /// Looks at the world after a step.
    pub fn step(&mut self, simulation: &Simulation) {
        let loads = simulation.loads();
        for side in Side::BOTH.map(Side::index) {
            let load = &loads[side];
            self.window[side] += load.load;
            for torque in load.torques {
                self.max_torque[side] = self.max_torque[side].max(torque.abs());
            }
        }
        self.window_steps += 1;
        if self.window_steps == self.window_every {
            self.drag = self.window.map(|sum| sum.norm() / self.window_every as f64);
            self.window = [Point::ZERO; 2];
            self.window_steps = 0;
            self.windows += 1.0;
            for side in Side::BOTH.map(Side::index) {
                self.drag_sum[side] += self.drag[side];
                self.drag_max[side] = self.drag_max[side].max(self.drag[side]);
            }
        }
    }

    /// Looks at the pair against the reference of the same instant.
    pub fn compare(
        &mut self,
        simulation: &Simulation,
        reference: &[Sample; 2],
        control: &PairLoop,
    ) {
        let time = simulation.time();
        let targets = pair_pose(reference);
        let robots = simulation.pair();
        let error = [
            robots.left.position().distance(targets.left.position()),
            robots.right.position().distance(targets.right.position()),
        ];
        for (collector, error) in self.errors.iter_mut().zip(error) {
            collector.take(time, error);
        }
        if time + 1e-9 < self.samples.len() as f64 * self.sample_interval {
            return;
        }
        let states = simulation.robots();
        let adapted = control.adapted();
        self.samples.push(ControlSample {
            time,
            reference: targets,
            robots,
            forward: states.map(|s| s.forward),
            turn_rate: states.map(|s| s.turn_rate),
            error,
            drag: self.drag,
            torque: simulation.loads().map(|l| l.torques),
            bias: adapted.map(|a| a.bias),
            state_gain: adapted.map(|a: AdaptedParameters<f64>| flat(a.state)),
            input_gain: adapted.map(|a| flat(a.input)),
        });
    }

    pub fn tracking(&self) -> [TrackingStatistics; 2] {
        self.errors.map(|e| e.statistics())
    }

    pub fn drag_statistics(&self) -> [DragStatistics; 2] {
        Side::BOTH.map(Side::index).map(|side| DragStatistics {
            mean: self.drag_sum[side] / self.windows.max(1.0),
            max: self.drag_max[side],
        })
    }

    pub fn max_torque(&self) -> [f64; 2] {
        self.max_torque
    }

    pub fn samples(&self) -> &[ControlSample] {
        &self.samples
    }

    pub fn into_samples(self) -> Vec<ControlSample> {
        self.samples
    }
}

fn flat([[a, b], [c, d]]: [[f64; 2]; 2]) -> [f64; 4] {
    [a, b, c, d]
}
