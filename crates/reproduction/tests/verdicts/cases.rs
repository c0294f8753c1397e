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
    Case {
        claim: "length-simulation",
        numbers: &[
            ("paper", 2.32),
            ("as_printed", 1.63),
            ("with_what_the_authors'_data_show", 2.22),
        ],
        verdict: "shown if",
        planted: &[
            ("as_printed", 2.3, "shown"),
            ("with_what_the_authors'_data_show", 2.0, "not shown"),
        ],
    },
    Case {
        claim: "length-experiment",
        numbers: &[
            ("paper", 1.45),
            ("as_printed", 1.39),
            ("with_what_the_authors'_data_show", 1.77),
            ("paper_with_the_arms", 1.726),
        ],
        verdict: "shown",
        planted: &[("as_printed", 1.2, "shown if")],
    },
    Case {
        claim: "length-estimate",
        numbers: &[
            ("at_steps_of_0.05_m", 1.63),
            ("at_steps_of_0.2_m", 2.07),
            ("per_meter_at_steps_of_0.05_m", 1.63),
            ("per_meter_at_steps_of_0.2_m", 1.51),
        ],
        verdict: "shown if",
        planted: &[
            ("at_steps_of_0.2_m", 1.65, "shown"),
            ("per_meter_at_steps_of_0.2_m", 2.0, "not shown"),
        ],
    },
    Case {
        claim: "no-rule",
        numbers: &[
            ("least_J_dist_of_the_U-shape_above_that_of_no_rule", 37.9),
            ("longest_net_that_no_rule_needs", 2.07),
            ("longest_optimum_of_the_U-shape", 1.45),
        ],
        verdict: "shown",
        planted: &[
            ("longest_net_that_no_rule_needs", 1.5, "not shown"),
            ("least_J_dist_of_the_U-shape_above_that_of_no_rule", -3.0, "not shown"),
        ],
    },
    Case {
        claim: "rigid",
        numbers: &[
            ("lengths_in_three_scenes", 27.0),
            ("lengths_without_a_solution", 6.0),
            ("greatest_detour_at_the_longest_net", 12.1),
        ],
        verdict: "shown",
        planted: &[
            ("lengths_without_a_solution", 0.0, "shown if"),
            ("greatest_detour_at_the_longest_net", 0.2, "shown if"),
        ],
    },
    Case {
        claim: "u-shape",
        numbers: &[
            ("lengths_in_three_scenes", 27.0),
            ("lengths_with_a_solution_of_the_U-shape", 27.0),
            ("lengths_with_a_solution_of_a_fixed_separation", 21.0),
        ],
        verdict: "shown",
        planted: &[
            ("lengths_with_a_solution_of_the_U-shape", 25.0, "shown if"),
            ("lengths_with_a_solution_of_the_U-shape", 15.0, "not shown"),
        ],
    },
    Case {
        claim: "executions",
        numbers: &[
            ("executions", 5.0),
            ("executions_that_gather_everything", 5.0),
            ("greatest_error", 0.0138),
        ],
        verdict: "shown",
        planted: &[
            ("executions_that_gather_everything", 4.0, "not shown"),
            ("greatest_error", 0.2, "not shown"),
        ],
    },
    Case {
        claim: "adaptation-needed",
        numbers: &[
            ("drives", 3.0),
            ("complete_at_1x_adaptive", 3.0),
            ("complete_at_16x_adaptive", 3.0),
            ("complete_at_1x_feedback_alone", 3.0),
            ("complete_at_16x_feedback_alone", 0.0),
            ("complete_at_1x_integral", 0.0),
            ("complete_at_16x_integral", 3.0),
        ],
        verdict: "shown if",
        planted: &[
            ("complete_at_1x_feedback_alone", 2.0, "shown"),
            ("complete_at_16x_feedback_alone", 3.0, "not shown"),
            ("complete_at_1x_adaptive", 2.0, "not shown"),
        ],
    },
    Case {
        claim: "printed-adaptation",
        numbers: &[
            ("drives", 3.0),
            ("complete_at_16x_as_printed", 3.0),
            ("rms_at_16x_whole_law", 0.0113),
            ("rms_at_16x_bias_alone", 0.0146),
            ("rms_at_16x_as_printed", 0.068),
            ("rms_at_16x_nothing", 2.38),
        ],
        verdict: "shown if",
        planted: &[
            ("rms_at_16x_as_printed", 0.012, "shown"),
            ("complete_at_16x_as_printed", 1.0, "not shown"),
        ],
    },
    Case {
        claim: "gains",
        numbers: &[
            ("rms_at_a_tenth_of_the_rates", 0.36),
            ("rms_at_the_rates", 0.065),
            ("rms_at_ten_times_the_rates", 0.057),
            ("drives_lost_with_0.04_N_m", 2.0),
        ],
        verdict: "shown if",
        planted: &[
            ("rms_at_ten_times_the_rates", 0.08, "shown"),
            ("rms_at_a_tenth_of_the_rates", 0.01, "not shown"),
        ],
    },
    Case {
        claim: "published",
        numbers: &[
            ("objects", 8.0),
            ("gathered_theirs", 8.0),
            ("no_collision_theirs", 1.0),
        ],
        verdict: "shown",
        planted: &[
            ("gathered_theirs", 7.0, "not shown"),
            ("no_collision_theirs", 0.0, "shown if"),
        ],
    },
    Case {
        claim: "neighbors",
        numbers: &[
            ("objects_in_three_scenes", 21.0),
            ("gathered_by_ours", 21.0),
            ("failing_claims_of_ours", 0.0),
            ("gathered_by_the_search", 21.0),
            ("failing_claims_of_the_search", 1.0),
        ],
        verdict: "shown if",
        planted: &[
            ("gathered_by_the_search", 20.0, "shown"),
            ("failing_claims_of_the_search", 0.0, "not shown"),
            ("failing_claims_of_ours", 1.0, "not shown"),
        ],
    },
];
