//! Adaptive control, fairly: against the printed law, velocity feedback alone and an integral law, over loads, delays, noise
//! and torque; which part of the adaptive law carries it, and where each law loses stability.

use crate::chapter::Content;
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::laws::{
    BIAS, Condition, FEEDBACK, FULL, INTEGRAL, INTEGRAL_TABLE, Law, MODEL_BASED, Outcome, PRINTED,
    driven,
};
use crate::net_length::lifted;
use crate::planning::plan_scene;
use crate::scenes;
use crate::verdict::Verdict;
use pairtrawl::model::{Plan, Scene};
use pairtrawl::report::study::{Axis, Band, Chart, Curve, Line, Table};
use pairtrawl::{PlanOptions, RehearsalMode};

/// A condition that is varied.
struct Sweep {
    key: &'static str,
    title: &'static str,
    axis: &'static str,
    values: &'static [f64],
    quick: &'static [f64],
    set: fn(&mut Condition, f64),
}

const SWEEPS: [Sweep; 7] = [
    Sweep {
        key: "load",
        title: "Payload",
        axis: "masses, times 15 to 50 g",
        values: &[1.0, 4.0, 16.0, 24.0, 32.0],
        quick: &[1.0, 16.0],
        set: |c, v| c.load = v,
    },
    Sweep {
        key: "net-friction",
        title: "Friction of the net",
        axis: "times 0.2",
        values: &[0.0, 0.5, 1.0, 4.0, 8.0],
        quick: &[0.0, 4.0],
        set: |c, v| c.net_friction = v,
    },
    Sweep {
        key: "object-friction",
        title: "Friction of the objects",
        axis: "times 0.2",
        values: &[0.25, 1.0, 4.0],
        quick: &[4.0],
        set: |c, v| c.object_friction = v,
    },
    Sweep {
        key: "pose-delay",
        title: "Age of poses",
        axis: "s",
        values: &[0.0, 0.06, 0.12, 0.18],
        quick: &[0.12],
        set: |c, v| c.pose_delay = Some(v),
    },
    Sweep {
        key: "velocity-delay",
        title: "Age of velocities",
        axis: "s",
        values: &[0.002, 0.02, 0.04, 0.06, 0.08, 0.1],
        quick: &[0.04, 0.08],
        set: |c, v| c.velocity_delay = v,
    },
    Sweep {
        key: "noise",
        title: "Noise of poses",
        axis: "standard deviation of positions (m)",
        values: &[0.0, 0.01, 0.03, 0.1],
        quick: &[0.03],
        set: |c, v| c.noise = v,
    },
    Sweep {
        key: "torque",
        title: "Torque limit",
        axis: "N m a wheel",
        values: &[0.01, 0.02, 0.04, 0.08, 3.0],
        quick: &[0.02],
        set: |c, v| c.torque = Some(v),
    },
];

/// Laws that every sweep compares.
const COMPARED: [Law; 4] = [FULL, INTEGRAL, FEEDBACK, MODEL_BASED];

/// The experiment with its plan.
fn planned(lab: &Lab) -> Result<(Scene, Plan), Stopped> {
    let loaded = scenes::experiment()?;
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let plan = plan_scene(lab, &loaded, &options)?.plan;
    Ok((loaded.scene, plan))
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    let (scene, plan) = planned(lab)?;
    let seeds = if lab.quick { 2 } else { 6 };
    let many = if lab.quick { 3 } else { 20 };
    content.text(format!("The experiment's plan, driven by each law in full physics. Velocities are those of the wheels, so a wheel that slips misleads its controller. Nothing stops a pair that is lost (a robot more than 25 cm from its reference). Errors are root mean squares of the worse robot; intervals hold 10 to 90 % of the drives ({many} seeds in the tables of the laws and the parts, {seeds} at each point of the curves)."));
    let run = |key: &str, law: &Law, condition: &Condition, seeds: usize| {
        lab.host.doing(&format!("driving: {key}, {}", law.name));
        let name = format!("tracking-{key}-{}", law.name.replace([' ', ','], "_"));
        lab.remember(&name, || driven(lab, &scene, &plan, law, condition, seeds))
    };
    laws(&mut content, &run, many)?;
    parts(&mut content, &run, many)?;
    content.heading("Over loads, sensors and torque");
    let mut charts = Vec::new();
    let mut edges = Table::new(
        "The first value at which a law loses the pair in at least one drive",
        &["", "adaptive", "integral", "K alone", "model-based"],
    );
    for sweep in &SWEEPS {
        let values = if lab.quick { sweep.quick } else { sweep.values };
        let mut curves = Vec::new();
        let mut row = vec![format!("{} ({})", sweep.title, sweep.axis)];
        for (look, law) in COMPARED.iter().enumerate() {
            let mut outcomes = Vec::new();
            for value in values {
                let mut condition = Condition::PLAIN;
                (sweep.set)(&mut condition, *value);
                outcomes.push(run(
                    &format!("{}-{value}", sweep.key),
                    law,
                    &condition,
                    seeds,
                )?);
            }
            let first = values.iter().zip(&outcomes).find(|(_, o)| o.lost > 0);
            row.push(first.map_or("none".to_owned(), |(v, _)| v.to_string()));
            curves.push(curve(law.name, look, values, &outcomes));
        }
        edges.row(row);
        charts.push(Chart {
            title: sweep.title.to_owned(),
            x: Axis::named(&format!("{} ({})", sweep.title.to_lowercase(), sweep.axis)),
            y: Axis::from_zero("rms error (cm)"),
            curves,
            marks: Vec::new(),
            caption: String::new(),
        });
    }
    content.charts(charts);
    content.text("A curve ends where a law loses the pair in every drive.");
    content.table(edges);
    gains(lab, &mut content, &run, seeds)?;
    above_the_floor(lab, &mut content, &scene, &plan, seeds)?;
    Ok(content)
}

type Run<'r> = dyn Fn(&str, &Law, &Condition, usize) -> Result<Outcome, Stopped> + 'r;

fn curve(name: &str, look: usize, values: &[f64], outcomes: &[Outcome]) -> Curve {
    let all = |o: &Outcome| o.lost < o.drives;
    let of = |o: &Outcome, k: usize| {
        if all(o) {
            (100.0 * o.rms[k]).min(30.0)
        } else {
            f64::NAN
        }
    };
    Curve {
        label: name.to_owned(),
        points: values
            .iter()
            .zip(outcomes)
            .map(|(v, o)| (*v, of(o, 1)))
            .collect(),
        line: if look.is_multiple_of(2) {
            Line::Solid
        } else {
            Line::Dashed
        },
        look,
        band: Some(Band {
            low: outcomes.iter().map(|o| of(o, 0)).collect(),
            high: outcomes.iter().map(|o| of(o, 2)).collect(),
        }),
    }
}

fn centimeters([low, middle, high]: [f64; 3]) -> String {
    format!(
        "{:.2} ({:.2} to {:.2})",
        100.0 * middle,
        100.0 * low,
        100.0 * high
    )
}

fn heads(first: &'static str) -> [&'static str; 7] {
    [
        first,
        "gathers everything",
        "lost",
        "#rms at 1x (cm)",
        "gathers at 16x",
        "lost at 16x",
        "#rms at 16x (cm)",
    ]
}

fn cells(law: &Law, plain: &Outcome, heavy: &Outcome) -> Vec<String> {
    let mut row = vec![law.name.to_owned()];
    for o in [plain, heavy] {
        row.push(format!("{} of {}", o.complete, o.drives));
        row.push(match o.first_lost {
            Some(time) => format!("{} of {}, from {time:.0} s", o.lost, o.drives),
            None => "never".to_owned(),
        });
        row.push(centimeters(o.rms));
    }
    row
}

const HEAVY: Condition = Condition {
    load: 16.0,
    ..Condition::PLAIN
};

fn laws(content: &mut Content, run: &Run, many: usize) -> Result<(), Stopped> {
    content.heading("The laws");
    let mut table = Table::new("At the paper's load and at sixteen times it", &heads("law"));
    let mut evidence = Evidence::default().with("drives", many as f64, "");
    for law in [FULL, FEEDBACK, INTEGRAL, INTEGRAL_TABLE, MODEL_BASED] {
        let plain = run("laws-1x", &law, &Condition::PLAIN, many)?;
        let heavy = run("laws-16x", &law, &HEAVY, many)?;
        table.row(cells(&law, &plain, &heavy));
        for (name, key) in [
            (FULL.name, "adaptive"),
            (INTEGRAL.name, "integral"),
            (FEEDBACK.name, "feedback_alone"),
        ] {
            if law.name == name {
                evidence = evidence
                    .with("drives", plain.drives as f64, "")
                    .with(&format!("complete_at_1x_{key}"), plain.complete as f64, "")
                    .with(&format!("complete_at_16x_{key}"), heavy.complete as f64, "")
                    .with(&format!("rms_at_1x_{key}"), plain.rms[1], "m")
                    .with(&format!("rms_at_16x_{key}"), heavy.rms[1], "m");
            }
        }
    }
    content.table(table);
    content.verdict(Verdict::of("adaptation-needed", evidence));
    Ok(())
}

fn parts(content: &mut Content, run: &Run, many: usize) -> Result<(), Stopped> {
    content.heading("Which part of the adaptive law carries it");
    let mut table = Table::new(
        "The adaptive law with some of its parts",
        &heads("what adapts"),
    );
    let mut evidence = Evidence::default();
    for (law, key) in [
        (FULL, "whole_law"),
        (BIAS, "bias_alone"),
        (PRINTED, "as_printed"),
        (FEEDBACK, "nothing"),
    ] {
        let plain = run("laws-1x", &law, &Condition::PLAIN, many)?;
        let heavy = run("laws-16x", &law, &HEAVY, many)?;
        table.row(cells(&law, &plain, &heavy));
        evidence = evidence.with(&format!("rms_at_16x_{key}"), heavy.rms[1], "m");
        if key == "as_printed" {
            evidence = evidence.with("drives", heavy.drives as f64, "").with(
                "complete_at_16x_as_printed",
                heavy.complete as f64,
                "",
            );
        }
    }
    content.table(table);
    content.text("The bias is ours: the printed law adapts to forces in proportion to velocity and input, but a dragged net is dry friction, a force that does not grow with speed.");
    content.verdict(Verdict::of("printed-adaptation", evidence));
    Ok(())
}

/// The paper's remark on gains and torque, as a map.
fn gains(lab: &Lab, content: &mut Content, run: &Run, seeds: usize) -> Result<(), Stopped> {
    content.heading("Gains and saturation");
    let rates: &[f64] = if lab.quick {
        &[0.1, 1.0, 10.0]
    } else {
        &[0.1, 0.3, 1.0, 3.0, 10.0]
    };
    let torques: &[f64] = if lab.quick {
        &[0.04, 3.0]
    } else {
        &[0.02, 0.04, 0.08, 0.2, 3.0]
    };
    let mut table = Table::new(
        "Eight times the load: rms error in cm over rates of adaptation and the torque limit of a wheel; \u{2717}: lost in at least one drive",
        &[
            "rates",
            "#0.02 N m",
            "#0.04 N m",
            "#0.08 N m",
            "#0.2 N m",
            "#3 N m",
        ],
    );
    if lab.quick {
        table
            .heads
            .retain(|(head, _)| ["rates", "0.04 N m", "3 N m"].contains(&head.as_str()));
    }
    let (mut slow, mut usual, mut fast, mut saturated) = (f64::NAN, f64::NAN, f64::NAN, f64::NAN);
    for &rate in rates {
        let mut row = vec![format!("x {rate}")];
        for &torque in torques {
            let law = Law {
                rates: rate,
                ..FULL
            };
            let condition = Condition {
                torque: Some(torque),
                load: 8.0,
                ..Condition::PLAIN
            };
            let o = run(&format!("gains-{rate}-{torque}"), &law, &condition, seeds)?;
            row.push(if o.lost > 0 {
                "\u{2717}".to_owned()
            } else {
                format!("{:.2}", 100.0 * o.rms[1])
            });
            match (rate, torque) {
                (0.1, 3.0) => slow = o.rms[1],
                (1.0, 3.0) => usual = o.rms[1],
                (10.0, 3.0) => fast = o.rms[1],
                (1.0, 0.04) => saturated = o.lost as f64,
                _ => {}
            }
        }
        table.row(row);
    }
    content.table(table);
    content.verdict(Verdict::of(
        "gains",
        Evidence::default()
            .with("rms_at_a_tenth_of_the_rates", slow, "m")
            .with("rms_at_the_rates", usual, "m")
            .with("rms_at_ten_times_the_rates", fast, "m")
            .with("drives_lost_with_0.04_N_m", saturated, ""),
    ));
    Ok(())
}

/// The model-based law with a net that does not touch the floor.
fn above_the_floor(
    lab: &Lab,
    content: &mut Content,
    scene: &Scene,
    plan: &Plan,
    seeds: usize,
) -> Result<(), Stopped> {
    content.heading("A net above the floor");
    let lifted = lifted(scene);
    let mut table = Table::new(
        "The experiment with a net that touches the floor and one that does not",
        &[
            "law",
            "net",
            "gathers everything",
            "lost",
            "in the net then",
            "drives with a collision",
        ],
    );
    for (law, scene, net) in [
        (MODEL_BASED, scene, "on the floor"),
        (MODEL_BASED, &lifted, "above the floor"),
        (FULL, &lifted, "above the floor"),
    ] {
        lab.host.doing("driving with a net above the floor");
        let o = driven(lab, scene, plan, &law, &Condition::PLAIN, seeds)?;
        table.row([
            law.name.to_owned(),
            net.to_owned(),
            format!("{} of {}", o.complete, o.drives),
            o.first_lost.map_or("never".to_owned(), |time| {
                format!("{} of {}, from {time:.1} s", o.lost, o.drives)
            }),
            o.held_when_lost
                .map_or(String::new(), |n| format!("{n} at least")),
            format!("{} of {}", o.collisions, o.drives),
        ]);
    }
    content.table(table);
    Ok(())
}
