//! What is changed about the laws' default gains, to study them.

use pairtrawl_control::{ControllerParameters, LawParameters};

/// Which parameters of the adaptive law adapt. Without any it is its velocity feedback K alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AdaptedParts {
    /// Delta_X.
    pub state: bool,
    /// Delta_m.
    pub input: bool,
    /// Delta_b.
    pub bias: bool,
}

impl AdaptedParts {
    /// The whole law.
    pub const ALL: Self = Self {
        state: true,
        input: true,
        bias: true,
    };
    /// K alone.
    pub const NONE: Self = Self {
        state: false,
        input: false,
        bias: false,
    };
}

/// Changes of the laws' default gains. The default changes nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawOptions {
    /// Velocity feedback K of the adaptive and the integral law over the default.
    pub feedback: f64,
    /// Rates of adaptation, and the integral law's K_I, over the defaults.
    pub rates: f64,
    /// What the adaptive law adapts.
    pub adapts: AdaptedParts,
    /// Greatest torque that controllers command to a wheel, N m; `None`: the scene's `max_torque`.
    pub torque_limit: Option<f64>,
}

impl Default for LawOptions {
    fn default() -> Self {
        Self {
            feedback: 1.0,
            rates: 1.0,
            adapts: AdaptedParts::ALL,
            torque_limit: None,
        }
    }
}

impl LawOptions {
    /// Controllers with these changes.
    #[must_use]
    pub fn applied(&self, mut parameters: ControllerParameters<f64>) -> ControllerParameters<f64> {
        let times = |gains: &mut [f64; 2], factor: f64| *gains = gains.map(|gain| gain * factor);
        match &mut parameters.law {
            LawParameters::ModelBased => {}
            LawParameters::Integral(gains) => {
                times(&mut gains.velocity, self.feedback);
                times(&mut gains.integral, self.rates);
            }
            LawParameters::Mrac(gains) => {
                times(&mut gains.feedback, self.feedback);
                // P = Q / (2 K) and with it the meaning of the rates stays.
                times(&mut gains.lyapunov, self.feedback);
                times(&mut gains.state_bound, self.feedback);
                let rate = |adapts: bool| if adapts { self.rates } else { 0.0 };
                times(&mut gains.state_rate, rate(self.adapts.state));
                times(&mut gains.input_rate, rate(self.adapts.input));
                times(&mut gains.bias_rate, rate(self.adapts.bias));
            }
        }
        if let Some(limit) = self.torque_limit {
            parameters.limits.torque = limit;
        }
        parameters
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_control::MracGains;

    #[test]
    fn only_what_is_asked_for_changes() {
        let law = LawParameters::Mrac(MracGains::default());
        let before = ControllerParameters::with_law(law);
        assert_eq!(LawOptions::default().applied(before), before);
        let options = LawOptions {
            feedback: 2.0,
            adapts: AdaptedParts {
                bias: true,
                ..AdaptedParts::NONE
            },
            torque_limit: Some(0.1),
            ..LawOptions::default()
        };
        let after = options.applied(before);
        let LawParameters::Mrac(gains) = after.law else {
            panic!("another law: {after:?}");
        };
        let default = MracGains::<f64>::default();
        assert_eq!(gains.feedback, default.feedback.map(|k| 2.0 * k));
        assert_eq!((gains.state_rate, gains.input_rate), ([0.0; 2], [0.0; 2]));
        assert_eq!(gains.bias_rate, default.bias_rate);
        assert_eq!(after.limits.torque, 0.1);
    }
}
