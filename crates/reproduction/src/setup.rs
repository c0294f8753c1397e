//! The paper's parameters beside the defaults of the code, generated from these.

use crate::chapter::Content;
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::verdict::Verdict;
use pairtrawl::execute::{Sensing, TORQUE_PERIOD, TRACKER_TICKS};
use pairtrawl::model::{PhysicsParameters, PlannerParameters, Robot};
use pairtrawl::report::study::Table;
use pairtrawl_control::{IntegralGains, MracGains, RobotModel, SupervisorLimits, TrackingGains};

/// A parameter of the paper and of ours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Its symbol.
    pub symbol: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The paper's value; `None`: the paper states none.
    pub paper: Option<f64>,
    /// Our default.
    pub ours: f64,
    /// Why they differ, or a remark.
    pub remark: &'static str,
}

fn stated(
    symbol: &'static str,
    meaning: &'static str,
    unit: &'static str,
    paper: f64,
    ours: f64,
) -> Parameter {
    Parameter {
        symbol,
        meaning,
        unit,
        paper: Some(paper),
        ours,
        remark: "",
    }
}

fn own(symbol: &'static str, meaning: &'static str, unit: &'static str, ours: f64) -> Parameter {
    Parameter {
        symbol,
        meaning,
        unit,
        paper: None,
        ours,
        remark: "",
    }
}

fn because(remark: &'static str, parameter: Parameter) -> Parameter {
    Parameter {
        remark,
        ..parameter
    }
}

/// The parameters of planning: Section IV-A of the paper.
pub fn planning() -> Vec<Parameter> {
    let p = PlannerParameters::default();
    vec![
        stated(
            "l",
            "half the separation of the baseline pair",
            "m",
            0.3,
            p.half_separation,
        ),
        stated(
            "N_total",
            "rounds of Algorithm 1",
            "",
            8.0,
            p.alternations as f64,
        ),
        stated("t1", "cost of driven distance", "1/m", 300.0, p.t1),
        stated("t2", "cost of turning", "1/rad", 10.0, p.t2),
        stated("K1", "cost of a waypoint in an obstacle", "", 1e7, p.k1),
        stated("K2", "gain of the potential of circles", "m^2", 1e7, p.k2),
        stated("K3", "cost of a separation out of bounds", "", 1e7, p.k3),
        stated("k_d1", "gain of J_e below d_rest", "", 20.0, p.kd1),
        stated("k_d2", "gain of J_e above d_rest", "1/m^2", 15.0, p.kd2),
        stated("b1", "smoothness of x", "1/m^2", 110.0, p.b1),
        stated("b2", "smoothness of y", "1/m^2", 110.0, p.b2),
        stated("b3", "smoothness of the heading", "1/rad^2", 1.0, p.b3),
        stated("a1", "weight of J_s", "", 1.0, p.a1),
        stated("a2", "weight of J_dist", "", 1.0, p.a2),
        stated("a3", "weight of J_obs", "", 1.0, p.a3),
        stated("a4", "weight of J_e", "", 1.0, p.a4),
        because(
            "the authors' data have 0.2 m",
            stated("dL_max", "longest step", "m", 0.05, p.max_step),
        ),
        stated(
            "dphi_max",
            "greatest turn in a step",
            "rad",
            0.1,
            p.max_turn,
        ),
        stated("d_min / d_max", "below it J_e is K3", "", 0.1, p.min_ratio),
        stated(
            "d_rest / d_max",
            "where J_e is zero",
            "",
            std::f64::consts::FRAC_2_PI,
            p.rest_ratio,
        ),
        because(
            "\"based on the robot's dimension\"; the authors' data have 0.4 m",
            own(
                "gamma",
                "margin of circles",
                "m",
                p.circle_margin.unwrap_or(Robot::default().radius),
            ),
        ),
        because(
            "ours: keeps robots abreast",
            own(
                "max_skew",
                "greatest angle of a heading to abreast",
                "rad",
                p.max_skew,
            ),
        ),
        because(
            "ours: room for nets and controllers",
            own(
                "clearance",
                "kept beyond the robot radius",
                "m",
                p.clearance,
            ),
        ),
        because(
            "that of the authors' runs",
            own("cruise", "speed of the time law", "m/s", p.cruise),
        ),
    ]
}

/// The paper's Table I.
pub fn table_1() -> Vec<Parameter> {
    let (physics, robot, model) = (
        PhysicsParameters::default(),
        Robot::default(),
        RobotModel::<f64>::paper(),
    );
    let remark = "net links of the paper are 0.1 m long, 0.01 m thick, 0.08 m high";
    vec![
        stated("m", "mass of a robot", "kg", 1.43, physics.robot_mass),
        stated(
            "J",
            "inertia of a robot, as controllers know it",
            "kg m^2",
            0.146,
            model.inertia,
        ),
        because(
            "the robot's own model file; the table has ten times as much",
            stated(
                "J",
                "inertia of a robot in the simulation",
                "kg m^2",
                0.146,
                physics.robot_inertia,
            ),
        ),
        stated("R", "half the track", "m", 0.144, robot.half_track),
        stated("r", "wheel radius", "m", 0.033, physics.wheel_radius),
        stated(
            "d",
            "center of mass ahead of the axle",
            "m",
            0.02,
            physics.center_of_mass,
        ),
        stated(
            "",
            "mass of a link of the net",
            "kg",
            0.002,
            physics.net_mass * physics.net_link,
        ),
        because(
            remark,
            stated("", "length of a link", "m", 0.1, physics.net_link),
        ),
        stated("", "thickness of a link", "m", 0.01, physics.net_thickness),
        stated("", "height of a link", "m", 0.08, physics.net_height),
        stated(
            "",
            "damping of a joint",
            "N m s/rad",
            1e-3,
            physics.hinge_damping,
        ),
        stated(
            "mu_1, mu_2",
            "friction of the net",
            "",
            0.2,
            physics.net_friction,
        ),
        because(
            "each object of a scene has its own",
            stated("m_i", "mass of a cube", "kg", 0.025, 0.025),
        ),
        because(
            "each object of a scene has its own",
            stated("", "edge of a cube", "m", 0.05, 0.05),
        ),
        stated(
            "",
            "rate of the tracking controller",
            "Hz",
            100.0,
            (1.0 / (TORQUE_PERIOD * TRACKER_TICKS as f64)).round(),
        ),
        stated(
            "",
            "rate of the torque controller",
            "Hz",
            500.0,
            (1.0 / TORQUE_PERIOD).round(),
        ),
        stated(
            "",
            "greatest torque of a wheel",
            "N m",
            3.0,
            physics.max_torque,
        ),
    ]
}

/// The gains of control, of which the paper states none.
pub fn control() -> Vec<Parameter> {
    let t = TrackingGains::<f64>::default();
    let g = MracGains::<f64>::default();
    let i = IntegralGains::<f64>::for_inertia(g.split_inertia);
    let s = SupervisorLimits::<f64>::default();
    let n = Sensing::default();
    vec![
        own("k1", "errors along the path", "1/s", t.along),
        own("k2", "errors across the path", "1/m^2", t.across),
        own("k3", "errors of the heading", "1/s", t.heading),
        own("L_1", "split inertia, forward", "kg", g.split_inertia[0]),
        own(
            "L_2",
            "split inertia, turning",
            "kg m^2",
            g.split_inertia[1],
        ),
        own("K_1", "velocity feedback, forward", "N s/m", g.feedback[0]),
        own(
            "K_2",
            "velocity feedback, turning",
            "N m s/rad",
            g.feedback[1],
        ),
        own(
            "Gamma_X1",
            "adaptation of Delta_X, forward",
            "kg",
            g.state_rate[0],
        ),
        own(
            "Gamma_m1",
            "adaptation of Delta_m, forward",
            "",
            g.input_rate[0],
        ),
        own(
            "Gamma_b1",
            "adaptation of the bias, forward",
            "N/m",
            g.bias_rate[0],
        ),
        own("K_I1", "integral law, forward", "N/m", i.integral[0]),
        own(
            "",
            "the supervisor stops beyond this error",
            "m",
            s.tracking_error,
        ),
        own("", "noise of positions", "m", n.position_noise),
        own("", "noise of headings", "rad", n.heading_noise),
        own("", "age of poses", "s", n.pose_delay),
    ]
}

/// The chapter.
pub(crate) fn chapter(_lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    content.text("Made from the defaults of the code, so it cannot drift from them.");
    let (planning, machine) = (planning(), table_1());
    content.table(table("Planning (Section IV-A)", &planning));
    content.table(table(
        "Physics and rates (Table I; torque: Section V-A)",
        &machine,
    ));
    content.table(table("Control: the paper states no gains", &control()));
    let stated: Vec<&Parameter> = planning
        .iter()
        .chain(&machine)
        .filter(|p| p.paper.is_some())
        .collect();
    let same = stated
        .iter()
        .filter(|p| p.paper.is_some_and(|paper| is_same(paper, p.ours)));
    content.verdict(Verdict::of(
        "setup",
        Evidence::default()
            .with("parameters_that_the_paper_states", stated.len() as f64, "")
            .with("the_same_by_default", same.count() as f64, ""),
    ));
    Ok(content)
}

/// Equal but for rounding.
fn is_same(paper: f64, ours: f64) -> bool {
    (paper - ours).abs() <= 1e-9 * paper.abs()
}

fn table(caption: &str, parameters: &[Parameter]) -> Table {
    let mut table = Table::new(
        caption,
        &[
            "symbol",
            "what it is",
            "#the paper",
            "#here",
            "unit",
            "remark",
        ],
    );
    for p in parameters {
        let paper = p.paper.map_or("not stated".to_owned(), number);
        table.row([
            p.symbol,
            p.meaning,
            &paper,
            &number(p.ours),
            p.unit,
            p.remark,
        ]);
    }
    table
}

/// With at most four significant decimals, without trailing zeros.
fn number(value: f64) -> String {
    if value.abs() >= 1e6 {
        return format!("{value:e}");
    }
    let text = format!("{value:.4}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
