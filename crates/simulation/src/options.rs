use crate::{Engine, SimulationError};
use pairtrawl_model::{Scene, Units};

/// How finely to simulate and what to record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// What computes the motion.
    pub engine: Engine,
    /// Time step of the physics, s; for a machine of the paper's size ([`Self::for_scene`]) 1e-5 to 2e-2 (rapier: to 4e-3).
    pub time_step: f64,
    /// Time between recorded frames, s.
    pub frame_interval: f64,
    /// Time for which the robots stand still after the last waypoint, s.
    pub settle_time: f64,
    /// A robot farther than this from its place in the plan counts as caught, m.
    pub max_deviation: f64,
}

impl Default for Options {
    /// For a verdict: steps of 10 ms.
    fn default() -> Self {
        Self {
            engine: Engine::Implicit,
            time_step: 1e-2,
            frame_interval: 0.1,
            settle_time: 0.5,
            max_deviation: 0.05,
        }
    }
}

impl Options {
    /// For many runs: steps of 20 ms. Objects end within some millimeters of where they end with fine steps.
    pub fn quick() -> Self {
        Self {
            time_step: 2e-2,
            ..Self::default()
        }
    }

    /// rapier in steps of 1 ms. Pulled with 10 N a robot, a snagged net's hinges open by 0.2 mm.
    #[cfg(feature = "rapier")]
    pub fn rapier() -> Self {
        Self {
            engine: Engine::Rapier(crate::RapierSolver {
                iterations: 4,
                sweeps: 4,
            }),
            time_step: 1e-3,
            ..Self::default()
        }
    }

    /// The same for the machine of a scene: what these options are for one of the paper's size on Earth, with times and
    /// lengths grown in proportion to it. No change for the default machine.
    pub fn for_scene(&self, scene: &Scene) -> Self {
        let Units { length, time, .. } = Units::of_machine(scene);
        self.scaled(length, time)
    }

    /// The same for a controller that sets the drive every `tick` seconds: as [`Self::for_scene`], with the time step a whole
    /// part of the tick.
    pub fn for_control(&self, scene: &Scene, tick: f64) -> Self {
        let scaled = self.for_scene(scene);
        Self {
            time_step: tick / (tick / scaled.time_step).ceil(),
            ..scaled
        }
    }

    /// In units of the machine instead of SI units.
    pub(crate) fn in_units(&self, units: &Units) -> Self {
        let scaled = self.scaled(1.0 / units.length, 1.0 / units.time);
        Self {
            time_step: units.tidy(self.time_step / units.time),
            ..scaled
        }
    }

    fn scaled(&self, length: f64, time: f64) -> Self {
        Self {
            time_step: self.time_step * time,
            frame_interval: self.frame_interval * time,
            settle_time: self.settle_time * time,
            max_deviation: self.max_deviation * length,
            ..*self
        }
    }

    /// Checks every bound; in units of the machine.
    pub(crate) fn validate(&self) -> Result<(), SimulationError> {
        let check = |name, value: f64, low: f64, high: f64| {
            if (low..=high).contains(&value) {
                Ok(())
            } else {
                Err(SimulationError::Option {
                    name,
                    value,
                    low,
                    high,
                })
            }
        };
        check(
            "time_step",
            self.time_step,
            1e-5,
            self.engine.longest_step(),
        )?;
        check("frame_interval", self.frame_interval, self.time_step, 60.0)?;
        check("settle_time", self.settle_time, 0.0, 60.0)?;
        check("max_deviation", self.max_deviation, 1e-3, 10.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_scene::scene;

    #[test]
    fn a_controlled_step_is_a_whole_part_of_the_tick_and_right_for_the_machine() {
        let default = Options::default();
        assert_eq!(
            default.for_control(&scene(Vec::new()), 0.002).time_step,
            0.002
        );
        for radius in [0.0048, 0.1, 2.4, 240.0] {
            let mut scene = scene(Vec::new());
            scene.robot.radius = radius;
            let options = default.for_control(&scene, 0.002);
            let steps = 0.002 / options.time_step;
            assert!(
                (steps - steps.round()).abs() < 1e-9 && steps > 0.5,
                "{steps}"
            );
            let units = Units::of_machine(&scene);
            assert!(
                options.time_step <= 1e-2 * units.time * (1.0 + 1e-12),
                "{radius}"
            );
            assert_eq!(options.in_units(&units).validate(), Ok(()), "{radius}");
        }
    }
}
