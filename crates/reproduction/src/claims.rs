//! The claims of the paper, each with the rule that says what numbers make of it. Names in a rule are names of its evidence.

mod control;
mod planning;

use crate::evidence::Claim;

/// All of them, in the order of the paper.
pub const CLAIMS: &[Claim] = &[
    Claim {
        key: "plans",
        text: "Starting from a centerline and a baseline pair, the framework generates smooth and collision-free trajectories that gather all objects.",
        place: "Sections I and II, Fig. 2",
        rule: planning::plans,
    },
    Claim {
        key: "alternating",
        text: "Optimizing one robot after the other improves efficiency and avoids local minima, compared with optimizing the whole trajectory at once.",
        place: "Section II-C, Algorithm 1",
        rule: planning::alternating,
    },
    Claim {
        key: "longer-net",
        text: "A longer net is not better: the total cost is least at a length between the shortest and the longest.",
        place: "Section IV-B, Fig. 5 f",
        rule: planning::longer_net,
    },
    Claim {
        key: "distance-alone",
        text: "Judged by the distance cost alone, nets of 2.5 m and 3.0 m are better than the estimated optimum.",
        place: "Section IV-B, Fig. 5 f",
        rule: planning::distance_alone,
    },
    Claim {
        key: "executed-costs",
        text: "Costs of the executed trajectories follow those that were planned, over the length of the net.",
        place: "Section IV-B, Fig. 5 f",
        rule: planning::executed_costs,
    },
    Claim {
        key: "mrac-gathers",
        text: "The adaptive controller tracks the whole trajectory and gathers all objects, at every net length.",
        place: "Section IV-B, Fig. 5 a-e",
        rule: control::mrac_gathers,
    },
    Claim {
        key: "model-based-fails",
        text: "The model-based controller becomes unstable as more objects are collected and ends in collisions.",
        place: "Section IV-B, Fig. 5 a-e",
        rule: control::model_based_fails,
    },
    Claim {
        key: "length-simulation",
        text: "The optimal net for the simulation is 2.32 m long.",
        place: "Section IV-B",
        rule: planning::length_simulation,
    },
    Claim {
        key: "length-experiment",
        text: "The optimal net for the experiment is 1.45 m long.",
        place: "Section V-B",
        rule: planning::length_experiment,
    },
    Claim {
        key: "length-estimate",
        text: "Given an environment, the framework can gauge the optimal net length.",
        place: "Abstract, Section VI",
        rule: planning::length_estimate,
    },
    Claim {
        key: "no-rule",
        text: "Without a rule for the separation the travel is shortest, but it may need an unrealistic net.",
        place: "Section IV-C, Fig. 6",
        rule: planning::no_rule,
    },
    Claim {
        key: "rigid",
        text: "A fixed separation may find no solution for a short net and cause detours with a long one.",
        place: "Section IV-C, Fig. 6",
        rule: planning::rigid,
    },
    Claim {
        key: "u-shape",
        text: "The U-shaped cost finds solutions for various lengths of net.",
        place: "Section IV-C, Fig. 6",
        rule: planning::u_shape,
    },
    Claim {
        key: "executions",
        text: "The adaptive controller robustly tracks the planned trajectories and gathers all objects, in five executions with various masses.",
        place: "Section V-B, Fig. 8",
        rule: control::executions,
    },
    Claim {
        key: "adaptation-needed",
        text: "Adaptive control is necessary: payloads are unknown and grow.",
        place: "Sections I, III and VI",
        rule: control::adaptation_needed,
    },
    Claim {
        key: "printed-adaptation",
        text: "The adaptive law of Delta_X and Delta_m handles unknown payloads.",
        place: "Section III-C, eq. 30",
        rule: control::printed_adaptation,
    },
    Claim {
        key: "gains",
        text: "Larger adaptive gains respond faster but may lead to oscillations; saturation of the motors and the gains together bound the payload.",
        place: "Section III-C",
        rule: control::gains,
    },
    Claim {
        key: "published",
        text: "The reference of the experiment is collision-free, and the pair gathers all objects along it.",
        place: "Section V-B, the authors' data",
        rule: planning::published,
    },
    Claim {
        key: "neighbors",
        text: "A search over positions with a bound on the tether fails to account for obstacles and the net's shape; the framework does.",
        place: "Section I-A",
        rule: planning::neighbors,
    },
    Claim {
        key: "setup",
        text: "The experiments are made with the parameters that the paper states.",
        place: "Section IV-A, Table I",
        rule: planning::setup,
    },
];
