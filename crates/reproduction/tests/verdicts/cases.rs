const CASES: &[Case] = &[
    Case {
        claim: "plans",
        numbers: &[
            ("J_baseline_hybrid_A*", 15_006.6),
            ("J_optimized_hybrid_A*", 14_694.7),
            ("plans", 2.0),
            ("certified_plans", 2.0),
            ("objects", 26.0),
            ("objects_gathered_in_rehearsal", 26.0),
        ],
        verdict: "shown",
        planted: &[
            ("certified_plans", 1.0, "not shown"),
            ("objects_gathered_in_rehearsal", 25.0, "not shown"),
            ("J_optimized_hybrid_A*", 15_100.0, "not shown"),
        ],
    },
    Case {
        claim: "alternating",
        numbers: &[
            ("J_joint", 5471.0),
            ("J_alternating", 5470.8),
            ("J_alternating_bounded_start", 5470.8),
        ],
        verdict: "not shown",
        planted: &[("J_alternating", 5400.0, "shown")],
    },
    Case {
        claim: "longer-net",
        numbers: &[
            ("optimum", 1.627),
            ("shortest", 1.5),
            ("longest", 3.0),
            ("J_total_at_shortest", 14_707.6),
            ("J_total_at_optimum", 14_694.7),
            ("J_total_at_longest", 16_857.0),
        ],
        verdict: "shown",
        planted: &[
            ("J_total_at_longest", 14_000.0, "not shown"),
            ("optimum", 3.0, "not shown"),
        ],
    },
    Case {
        claim: "distance-alone",
        numbers: &[
            ("J_dist_at_optimum", 14_360.9),
            ("J_dist_at_2.5_m", 14_013.3),
            ("J_dist_at_3.0_m", 14_087.3),
        ],
        verdict: "shown",
        planted: &[("J_dist_at_3.0_m", 14_400.0, "not shown")],
    },
    Case {
        claim: "executed-costs",
        numbers: &[
            ("lengths", 5.0),
            ("lengths_with_the_same_rank", 5.0),
            ("greatest_difference_of_J_total", 0.95),
        ],
        verdict: "shown",
        planted: &[
            ("lengths_with_the_same_rank", 3.0, "not shown"),
            ("greatest_difference_of_J_total", 9.0, "not shown"),
        ],
    },
    Case {
        claim: "mrac-gathers",
        numbers: &[
            ("drives", 5.0),
            ("drives_that_gather_everything", 5.0),
            ("greatest_error", 0.0153),
        ],
        verdict: "shown",
        planted: &[
            ("drives_that_gather_everything", 4.0, "not shown"),
            ("greatest_error", 0.3, "not shown"),
        ],
    },
    Case {
        claim: "model-based-fails",
        numbers: &[
            ("drives", 5.0),
            ("complete_drives_on_the_floor", 0.0),
            ("objects_when_lost_on_the_floor", 0.0),
            ("collisions_on_the_floor", 5.0),
            ("complete_drives_of_a_net_above_the_floor", 0.0),
            ("objects_when_lost_of_a_net_above_the_floor", 2.0),
            ("collisions_of_a_net_above_the_floor", 5.0),
        ],
        verdict: "shown if",
        planted: &[
            ("objects_when_lost_on_the_floor", 3.0, "shown"),
            ("objects_when_lost_of_a_net_above_the_floor", 0.0, "not shown"),
            ("collisions_of_a_net_above_the_floor", 0.0, "not shown"),
        ],
    },
    Case {
        claim: "setup",
        numbers: &[
            ("parameters_that_the_paper_states", 37.0),
            ("the_same_by_default", 36.0),
        ],
        verdict: "shown if",
        planted: &[
            ("the_same_by_default", 37.0, "shown"),
            ("the_same_by_default", 30.0, "not shown"),
        ],
    },
];
