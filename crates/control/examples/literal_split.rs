//! How long the filter on the measured acceleration must be for the printed split M_k = (M_k - I) + I to be stable, over the
//! delay of the loop: J_k 0.146 kg m^2 in the controller, 0.0152 kg m^2 about the axle in the plant, 500 Hz.
//!
//! `cargo run --example literal_split -p pairtrawl-control`; `docs/control.md` quotes the table.

use pairtrawl_control::{Desired, InertiaSplit, MracGains, MracLaw, RobotModel, Step, Velocity};

const PERIOD: f64 = 0.002;
const PLANT: [f64; 2] = [1.43, 0.0152];

/// True when a push of 0.1 rad/s dies out within 20 s.
fn is_stable(split: InertiaSplit<f64>, delay: f64) -> bool {
    let Ok(mut law) = MracLaw::new(MracGains {
        split,
        ..MracGains::default()
    }) else {
        return false;
    };
    let mut line = vec![[0.0; 2]; (delay / PERIOD).round() as usize];
    let mut x = [0.0, 0.1];
    for _ in 0..10_000 {
        let velocity = Velocity::from_array(x);
        let step = Step {
            dt: PERIOD,
            saturated: false,
        };
        let body = law.force(
            &RobotModel::paper(),
            &Desired::default(),
            0.0,
            velocity,
            step,
        );
        line.push([body.force, body.torque]);
        let u = line.remove(0);
        x = [
            x[0] + PERIOD * u[0] / PLANT[0],
            x[1] + PERIOD * u[1] / PLANT[1],
        ];
        if x[1].is_nan() || x[1].abs() > 1e3 {
            return false;
        }
    }
    x[1].abs() < 0.05
}

fn main() {
    println!("delay s | shortest stable filter s | default split");
    for delay in [
        0.0, 0.002, 0.004, 0.01, 0.02, 0.03, 0.04, 0.06, 0.08, 0.10, 0.12,
    ] {
        let literal = |filter_time: f64| is_stable(InertiaSplit::Literal { filter_time }, delay);
        let (mut low, mut high) = (5e-4_f64, 20.0_f64);
        let shortest = if literal(low) {
            "any".to_owned()
        } else if literal(high) {
            for _ in 0..24 {
                let middle = (low * high).sqrt();
                if literal(middle) {
                    high = middle
                } else {
                    low = middle
                }
            }
            format!("{high:.3}")
        } else {
            "none".to_owned()
        };
        let default = if is_stable(InertiaSplit::Reference, delay) {
            "stable"
        } else {
            "unstable"
        };
        println!("{delay:7.3} | {shortest:>24} | {default}");
    }
}
