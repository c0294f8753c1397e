//! One control step: the budget is 1 microsecond, and nothing is allocated.

use divan::{AllocProfiler, Bencher, black_box};
use pairtrawl_control::{
    ControllerParameters, IntegralGains, LawParameters, MracGains, Pose, ReferenceSample,
    RobotController, Velocity,
};

#[global_allocator]
static ALLOC: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

/// Pose, reference and torque in one: the tracker's step and the torque loop's step together.
fn step(bencher: Bencher, law: LawParameters<f64>) {
    let mut controller =
        RobotController::new(&ControllerParameters::with_law(law)).expect("default gains");
    let pose = Pose {
        x: 0.01,
        y: -0.02,
        heading: 0.7,
    };
    let reference = ReferenceSample {
        pose: Pose {
            x: 0.0,
            y: 0.0,
            heading: 0.72,
        },
        velocity: Velocity {
            linear: 0.2,
            angular: 0.1,
        },
        acceleration: Velocity::default(),
    };
    let velocity = Velocity {
        linear: 0.19,
        angular: 0.11,
    };
    bencher.bench_local(|| {
        controller.track(black_box(&pose), 0.01, black_box(&reference));
        controller.torque(black_box(velocity), 0.002)
    });
}

#[divan::bench]
fn model_based(bencher: Bencher) {
    step(bencher, LawParameters::ModelBased);
}

#[divan::bench]
fn integral(bencher: Bencher) {
    step(bencher, LawParameters::Integral(IntegralGains::default()));
}

#[divan::bench]
fn mrac(bencher: Bencher) {
    step(bencher, LawParameters::Mrac(MracGains::default()));
}
