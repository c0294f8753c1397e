//! One robot's controller: guard, tracking law, force law, limits, and a smooth stop that is latched until re-armed.

use crate::{
    AdaptedParameters, BodyForce, Desired, IntegralGains, IntegralLaw, Limits, Mode, MracGains,
    MracLaw, ParameterError, Pose, PoseEstimator, PoseGuard, PoseRefusal, Real, ReferenceSample,
    RobotModel, Step, StopCause, TorqueLimiter, TrackingError, TrackingGains, Velocity,
    WheelTorque, desired_velocity, model_based_force,
};

/// Which law turns the desired velocity into force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LawParameters<T> {
    /// Eq. 22 as printed.
    ModelBased,
    /// Eq. 22 with integral velocity feedback.
    Integral(IntegralGains<T>),
    /// Eqs. 25 to 30.
    Mrac(MracGains<T>),
}

/// Everything that a controller is built from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControllerParameters<T> {
    /// The nominal robot.
    pub model: RobotModel<T>,
    /// The tracking law.
    pub tracking: TrackingGains<T>,
    /// The force law.
    pub law: LawParameters<T>,
    /// Limits of commands and measurements.
    pub limits: Limits<T>,
    /// Part of a pose's correction that is taken at once, (0, 1]; see [`PoseEstimator`].
    pub pose_gain: T,
}

impl<T: Real> ControllerParameters<T> {
    /// The paper's robot and default gains with a law.
    pub fn with_law(law: LawParameters<T>) -> Self {
        Self {
            model: RobotModel::paper(),
            tracking: TrackingGains::default(),
            law,
            limits: Limits::default(),
            pose_gain: T::of(0.05),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Law<T> {
    ModelBased,
    Integral(IntegralLaw<T>),
    Mrac(MracLaw<T>),
}

/// A stop under way: where it began and how far it is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct StopRamp<T> {
    velocity: Velocity<T>,
    bias: [T; 2],
    elapsed: T,
}

/// The controller of one robot. Holds no clock and no heap; a copy of it is a snapshot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobotController<T> {
    model: RobotModel<T>,
    tracking: TrackingGains<T>,
    limits: Limits<T>,
    law: Law<T>,
    limiter: TorqueLimiter<T>,
    guard: PoseGuard<T>,
    estimator: PoseEstimator<T>,
    mode: Mode,
    desired: Desired<T>,
    error: TrackingError<T>,
    heading: T,
    velocity: Velocity<T>,
    since_track: T,
    saturated: bool,
    ramp: StopRamp<T>,
    commanded: Velocity<T>,
}

impl<T: Real> RobotController<T> {
    /// An armed controller.
    ///
    /// # Errors
    /// Names the first parameter that is out of range.
    pub fn new(parameters: &ControllerParameters<T>) -> Result<Self, ParameterError> {
        parameters.model.validate()?;
        parameters.tracking.validate()?;
        parameters.limits.validate()?;
        let limits = parameters.limits;
        let law = match parameters.law {
            LawParameters::ModelBased => Law::ModelBased,
            LawParameters::Integral(gains) => Law::Integral(IntegralLaw::new(gains)?),
            LawParameters::Mrac(gains) => Law::Mrac(MracLaw::new(gains)?),
        };
        Ok(Self {
            model: parameters.model,
            tracking: parameters.tracking,
            limits,
            law,
            limiter: TorqueLimiter::new(limits.torque, limits.torque_rate),
            guard: PoseGuard::new(limits.pose_age, limits.plausible_position),
            estimator: PoseEstimator::new(parameters.pose_gain)?,
            mode: Mode::Armed,
            desired: Desired::default(),
            error: TrackingError::default(),
            heading: T::ZERO,
            velocity: Velocity::default(),
            since_track: T::ZERO,
            saturated: false,
            ramp: StopRamp::default(),
            commanded: Velocity::default(),
        })
    }

    /// The tracker (100 Hz): a pose that was true `age` s ago, and the reference of now.
    ///
    /// A refused pose or reference starts a smooth stop. While the robot stops or stands, only the error is kept up.
    pub fn track(&mut self, pose: &Pose<T>, age: T, reference: &ReferenceSample<T>) {
        match self.guard.take(pose, age) {
            Err(PoseRefusal::Invalid) => return self.stop(StopCause::InvalidPose),
            Err(PoseRefusal::Stale) => return self.stop(StopCause::StalePose),
            Ok(()) => {}
        }
        let estimate = self.estimator.correct(pose, age, self.velocity);
        let error = TrackingError::between(&estimate, &reference.pose, self.tracking.offset);
        let desired = desired_velocity(&self.tracking, &error, reference, self.velocity);
        let sound = reference.is_finite()
            && desired.velocity.is_finite()
            && desired.acceleration.is_finite();
        if !sound {
            return self.stop(StopCause::InvalidReference);
        }
        self.error = error;
        self.heading = estimate.heading;
        if self.mode == Mode::Armed {
            self.mode = Mode::Running;
        }
        if self.mode == Mode::Running {
            self.desired = self.cut(desired);
            self.since_track = T::ZERO;
        }
    }

    /// The torque loop (500 Hz): wheel torques for the measured velocity, `dt` s after the last call.
    ///
    /// Always finite, within the torque and rate limits. A `dt` that is not in (0, 0.1] s counts as 0: torque then holds.
    pub fn torque(&mut self, velocity: Velocity<T>, dt: T) -> WheelTorque<T> {
        self.advance(Some(velocity), dt)
    }

    fn advance(&mut self, velocity: Option<Velocity<T>>, dt: T) -> WheelTorque<T> {
        let dt = if dt > T::ZERO && dt <= T::of(0.1) {
            dt
        } else {
            T::ZERO
        };
        if self.guard.advance(dt).is_err() {
            self.stop(StopCause::StalePose);
        }
        let sound = velocity.filter(|velocity| self.limits.accepts(*velocity));
        let body = if let Some(velocity) = sound {
            self.velocity = velocity;
            self.estimator.advance(velocity, dt);
            self.force(dt)
        } else {
            self.stop(StopCause::InvalidVelocity);
            self.blind_force(dt)
        };
        let (torque, saturated) = self.limiter.limit(self.model.wheel_torque(body), dt);
        self.saturated = saturated;
        torque
    }

    /// The torque loop without a measured velocity: the robot brakes without feedback and stops (latched).
    pub fn blind(&mut self, dt: T) -> WheelTorque<T> {
        self.advance(None, dt)
    }

    /// Starts a smooth stop, which stays latched; a stop under way keeps its first cause.
    pub fn stop(&mut self, cause: StopCause) {
        match self.mode {
            Mode::Stopping(_) | Mode::Stopped(_) => {}
            Mode::Armed => self.mode = Mode::Stopped(cause),
            Mode::Running => {
                let bias = match &self.law {
                    Law::ModelBased => [T::ZERO; 2],
                    Law::Integral(law) => law.accumulated(),
                    Law::Mrac(law) => law.adapted().bias.map(|b| -b),
                };
                // From the measured velocity: a robot that is held or not yet under way must not be driven on by its stop.
                let (v, bound) = (self.velocity, self.limits.desired);
                self.ramp = StopRamp {
                    velocity: Velocity {
                        linear: v.linear.limited(bound.linear),
                        angular: v.angular.limited(bound.angular),
                    },
                    bias,
                    elapsed: T::ZERO,
                };
                self.mode = Mode::Stopping(cause);
            }
        }
    }

    /// Ends a latched stop: the next good pose starts the law anew, with nothing adapted.
    pub fn rearm(&mut self) {
        self.mode = Mode::Armed;
        self.guard.reset();
        self.estimator.reset();
        self.desired = Desired::default();
        match &mut self.law {
            Law::ModelBased => {}
            Law::Integral(law) => law.reset(),
            Law::Mrac(law) => law.reset(),
        }
    }

    /// What the controller is doing.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The error of the last good pose.
    pub fn error(&self) -> &TrackingError<T> {
        &self.error
    }

    /// v_d of the last tracker call.
    pub fn desired(&self) -> &Desired<T> {
        &self.desired
    }

    /// The velocity that the robot is to have now, for robots that take velocities instead of torques: the desired one while it
    /// follows its reference, what is left of the first one while it stops, else zero.
    pub fn commanded(&self) -> Velocity<T> {
        self.commanded
    }

    /// True when the last torque was cut by a limit.
    pub fn is_saturated(&self) -> bool {
        self.saturated
    }

    /// Adapted parameters, when the law adapts; the integral law reports its integrator as a bias.
    pub fn adapted(&self) -> AdaptedParameters<T> {
        match &self.law {
            Law::ModelBased => AdaptedParameters::default(),
            Law::Integral(law) => AdaptedParameters {
                bias: law.accumulated().map(|b| -b),
                ..AdaptedParameters::default()
            },
            Law::Mrac(law) => *law.adapted(),
        }
    }

    /// tau_bar of the current mode.
    fn force(&mut self, dt: T) -> BodyForce<T> {
        match self.mode {
            Mode::Armed => {
                self.commanded = Velocity::default();
                BodyForce::default()
            }
            Mode::Running => self.law_force(dt),
            Mode::Stopping(_) | Mode::Stopped(_) => self.stop_force(dt),
        }
    }

    fn law_force(&mut self, dt: T) -> BodyForce<T> {
        self.since_track += dt;
        // Between two tracker calls v_d moves on along its derivative, for two periods of the tracker at most.
        let ahead = self.since_track.limited(T::of(0.02));
        let d = &self.desired;
        let at = |v: T, a: T, bound: T| (v + a * ahead).limited(bound);
        let desired = Desired {
            velocity: Velocity {
                linear: at(
                    d.velocity.linear,
                    d.acceleration.linear,
                    self.limits.desired.linear,
                ),
                angular: at(
                    d.velocity.angular,
                    d.acceleration.angular,
                    self.limits.desired.angular,
                ),
            },
            ..*d
        };
        self.commanded = desired.velocity;
        let step = Step {
            dt,
            saturated: self.saturated,
        };
        match &mut self.law {
            Law::ModelBased => {
                model_based_force(&self.model, &desired, self.heading, self.velocity.angular)
            }
            Law::Integral(law) => {
                law.force(&self.model, &desired, self.heading, self.velocity, step)
            }
            Law::Mrac(law) => law.force(&self.model, &desired, self.heading, self.velocity, step),
        }
    }

    /// Velocity feedback to a velocity that falls from the measured one to zero as 1 - 3 s^2 + 2 s^3.
    fn stop_force(&mut self, dt: T) -> BodyForce<T> {
        let left = self.stop_velocity(dt);
        let (wanted, b, k) = (self.commanded, self.ramp.bias, self.limits.stop_feedback);
        BodyForce {
            force: left * b[0] + k[0] * (wanted.linear - self.velocity.linear),
            torque: left * b[1] + k[1] * (wanted.angular - self.velocity.angular),
        }
    }

    /// A stop without feedback: what holds the learned drag, less most of what the fall of the velocity takes. Never all of it, so
    /// that the robot is not driven back; friction does the rest, and all of the turning, whose inertia is known less well.
    fn blind_force(&mut self, dt: T) -> BodyForce<T> {
        self.stop_velocity(dt);
        if !matches!(self.mode, Mode::Stopping(_)) {
            return BodyForce::default();
        }
        let time = self.limits.stop_time;
        let s = self.ramp.elapsed / time;
        let deceleration = T::of(6.0) * s * (T::ONE - s) / time * self.ramp.velocity.linear;
        BodyForce {
            force: self.ramp.bias[0] - T::of(0.8) * self.model.mass * deceleration,
            torque: T::ZERO,
        }
    }

    /// Moves the stop on, sets the velocity that it asks for and returns the part of the first one that is left.
    fn stop_velocity(&mut self, dt: T) -> T {
        let left = self.advance_ramp(dt);
        let first = self.ramp.velocity;
        self.commanded = Velocity {
            linear: left * first.linear,
            angular: left * first.angular,
        };
        left
    }

    /// Moves the stop on and returns the part of the first velocity that is left, 1 to 0.
    fn advance_ramp(&mut self, dt: T) -> T {
        match self.mode {
            Mode::Stopping(cause) => {
                self.ramp.elapsed += dt;
                let s = self.ramp.elapsed / self.limits.stop_time;
                if s < T::ONE {
                    return T::ONE - s * s * (T::of(3.0) - s - s);
                }
                self.mode = Mode::Stopped(cause);
                T::ZERO
            }
            _ => T::ZERO,
        }
    }

    /// A desired velocity within its limits; a component that is cut has no derivative.
    fn cut(&self, desired: Desired<T>) -> Desired<T> {
        let mut cut = desired;
        let bound = self.limits.desired;
        if desired.velocity.linear.abs() > bound.linear {
            cut.velocity.linear = desired.velocity.linear.limited(bound.linear);
            cut.acceleration.linear = T::ZERO;
        }
        if desired.velocity.angular.abs() > bound.angular {
            cut.velocity.angular = desired.velocity.angular.limited(bound.angular);
            cut.acceleration.angular = T::ZERO;
        }
        cut
    }
}
