//! The claims of the paper, each with the rule that says what numbers make of it. Names in a rule are names of its evidence.

use crate::verdict::{Claim, Evidence, Outcome};
use Outcome::{NotShown, Shown, ShownIf};

fn shown_when(holds: bool, yes: &str, no: &str) -> Outcome {
    match holds {
        true => Shown(yes.to_owned()),
        false => NotShown(no.to_owned()),
    }
}

/// All of them, in the order of the paper.
pub const CLAIMS: &[Claim] = &[
    Claim {
        key: "plans",
        text: "Starting from a centerline and a baseline pair, the framework generates smooth and collision-free trajectories that gather all objects.",
        place: "Sections I and II, Fig. 2",
        rule: plans,
    },
    Claim {
        key: "alternating",
        text: "Optimizing one robot after the other improves efficiency and avoids local minima, compared with optimizing the whole trajectory at once.",
        place: "Section II-C, Algorithm 1",
        rule: alternating,
    },
    Claim {
        key: "longer-net",
        text: "A longer net is not better: the total cost is least at a length between the shortest and the longest.",
        place: "Section IV-B, Fig. 5 f",
        rule: longer_net,
    },
    Claim {
        key: "distance-alone",
        text: "Judged by the distance cost alone, nets of 2.5 m and 3.0 m are better than the estimated optimum.",
        place: "Section IV-B, Fig. 5 f",
        rule: distance_alone,
    },
    Claim {
        key: "executed-costs",
        text: "Costs of the executed trajectories follow those that were planned, over the length of the net.",
        place: "Section IV-B, Fig. 5 f",
        rule: executed_costs,
    },
    Claim {
        key: "mrac-gathers",
        text: "The adaptive controller tracks the whole trajectory and gathers all objects, at every net length.",
        place: "Section IV-B, Fig. 5 a-e",
        rule: mrac_gathers,
    },
    Claim {
        key: "model-based-fails",
        text: "The model-based controller becomes unstable as more objects are collected and ends in collisions.",
        place: "Section IV-B, Fig. 5 a-e",
        rule: model_based_fails,
    },
    Claim {
        key: "setup",
        text: "The experiments are made with the parameters that the paper states.",
        place: "Section IV-A, Table I",
        rule: setup,
    },
];

fn plans(e: &Evidence) -> Outcome {
    let all = e.get("plans") > 0.0
        && e.get("certified_plans") == e.get("plans")
        && e.get("objects_gathered_in_rehearsal") == e.get("objects");
    let better = e.get("J_optimized_hybrid_A*") < e.get("J_baseline_hybrid_A*");
    shown_when(
        all && better,
        "every claim of each certificate is proven, every rehearsal gathers all objects, and optimization lowers the cost of the baseline",
        "a plan is not certified, its rehearsal does not gather everything, or optimization does not lower the cost",
    )
}

fn alternating(e: &Evidence) -> Outcome {
    let (joint, open, bounded) = (
        e.get("J_joint"),
        e.get("J_alternating"),
        e.get("J_alternating_bounded_start"),
    );
    if open.min(bounded) < 0.999 * joint {
        return Shown("taking turns ends at a lower cost than optimizing both at once".to_owned());
    }
    let words = match open.is_finite() {
        true => {
            "taking turns ends within 0.1 % of what optimizing both robots and the net length at once finds, or above it: it avoids nothing here"
        }
        false => {
            "with the printed first length N dL_max taking turns finds no plan, and from a bounded one its cost is within 0.1 % of that of optimizing both robots at once, or above it"
        }
    };
    NotShown(words.to_owned())
}

fn longer_net(e: &Evidence) -> Outcome {
    let least = e.get("J_total_at_optimum");
    let inside = e.get("optimum") > e.get("shortest") && e.get("optimum") < e.get("longest");
    let rises = least < e.get("J_total_at_shortest") && least < e.get("J_total_at_longest");
    shown_when(
        inside && rises,
        "the total cost falls to the optimum and rises beyond it",
        "the total cost has its least at an end of the range",
    )
}

fn distance_alone(e: &Evidence) -> Outcome {
    let at = e.get("J_dist_at_optimum");
    shown_when(
        e.get("J_dist_at_2.5_m") < at && e.get("J_dist_at_3.0_m") < at,
        "both longer nets cost less distance",
        "a longer net costs no less distance",
    )
}

fn executed_costs(e: &Evidence) -> Outcome {
    let follows = e.get("greatest_difference_of_J_total") < 5.0
        && e.get("lengths_with_the_same_rank") == e.get("lengths");
    shown_when(
        follows,
        "executed costs are within 5 % of the planned ones and order the lengths in the same way",
        "executed costs differ by 5 % or more, or order the lengths differently",
    )
}

fn mrac_gathers(e: &Evidence) -> Outcome {
    shown_when(
        e.get("drives") > 0.0
            && e.get("drives_that_gather_everything") == e.get("drives")
            && e.get("greatest_error") < 0.1,
        "every drive gathers every object and stays within 10 cm of its reference",
        "a drive loses an object or strays by 10 cm or more",
    )
}

fn model_based_fails(e: &Evidence) -> Outcome {
    let fails = |name: &str| e.get(name) < e.get("drives");
    if !fails("complete_drives_on_the_floor") && !fails("complete_drives_of_a_net_above_the_floor")
    {
        return NotShown("the model-based law completes its drives".to_owned());
    }
    // Whether it fails with its load or before there is one.
    let with_load = |gathered: &str| e.get(gathered) >= 2.0;
    let collides = |drives: &str| e.get(drives) == e.get("drives");
    if with_load("objects_when_lost_on_the_floor") && collides("collisions_on_the_floor") {
        return Shown("it is lost after it has collected objects, and collides".to_owned());
    }
    if fails("complete_drives_of_a_net_above_the_floor")
        && with_load("objects_when_lost_of_a_net_above_the_floor")
        && collides("collisions_of_a_net_above_the_floor")
    {
        return ShownIf("the net hangs above the floor, as in the authors' own net model. A net that drags on the floor is lost before it holds two objects: its own friction is enough".to_owned());
    }
    NotShown("it does fail, but not with its load: the friction of the net is enough".to_owned())
}

fn setup(e: &Evidence) -> Outcome {
    let (stated, same) = (
        e.get("parameters_that_the_paper_states"),
        e.get("the_same_by_default"),
    );
    if same == stated {
        return Shown("every stated parameter is our default".to_owned());
    }
    match same >= stated - 1.0 {
        true => ShownIf("the inertia of the robot in the simulation is left out: its own model file has a tenth of the table's".to_owned()),
        false => NotShown("more than one default differs from what the paper states".to_owned()),
    }
}
