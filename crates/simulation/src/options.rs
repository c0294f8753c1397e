use crate::SimulationError;

/// How finely to simulate and what to record.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// Time step of the physics, s; 1e-4 to 4e-3.
    pub time_step: f64,
    /// Solver iterations (substeps) per time step.
    pub iterations: usize,
    /// Gauss-Seidel sweeps over joints and contacts per solver iteration.
    pub sweeps: usize,
    /// Time between recorded frames, s.
    pub frame_interval: f64,
    /// Time for which the robots stand still after the last waypoint, s.
    pub settle_time: f64,
    /// A robot farther than this from its place in the plan counts as caught, m.
    pub max_deviation: f64,
}

impl Default for Options {
    /// For a verdict: steps of 1 ms. Pulled with 10 N a robot, a snagged net's hinges open by 0.2 mm.
    fn default() -> Self {
        Self {
            time_step: 1e-3,
            iterations: 4,
            sweeps: 4,
            frame_interval: 0.1,
            settle_time: 0.5,
            max_deviation: 0.05,
        }
    }
}

impl Options {
    /// For many runs: steps of 2 ms and a quarter of the sweeps, 3.5 times faster. Objects end within about 2 mm of where they
    /// end with fine steps; pulled with 10 N a robot, a snagged net's hinges open by 5 mm.
    pub fn quick() -> Self {
        Self {
            time_step: 2e-3,
            iterations: 2,
            sweeps: 2,
            ..Self::default()
        }
    }

    /// Checks every bound.
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
        check("time_step", self.time_step, 1e-4, 4e-3)?;
        check("iterations", self.iterations as f64, 1.0, 64.0)?;
        check("sweeps", self.sweeps as f64, 1.0, 64.0)?;
        check("frame_interval", self.frame_interval, self.time_step, 60.0)?;
        check("settle_time", self.settle_time, 0.0, 60.0)?;
        check("max_deviation", self.max_deviation, 1e-3, 10.0)
    }
}
