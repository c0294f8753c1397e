//! What numbers make of the claims about control.

use crate::evidence::{Evidence, Outcome, shown_when};
use Outcome::{NotShown, Shown, ShownIf};

pub(super) fn mrac_gathers(e: &Evidence) -> Outcome {
    shown_when(
        e.get("drives") > 0.0
            && e.get("drives_that_gather_everything") == e.get("drives")
            && e.get("greatest_error") < 0.1,
        "every drive gathers every object and stays within 10 cm of its reference",
        "a drive loses an object or strays by 10 cm or more",
    )
}

pub(super) fn model_based_fails(e: &Evidence) -> Outcome {
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

pub(super) fn executions(e: &Evidence) -> Outcome {
    shown_when(
        e.get("executions") > 0.0
            && e.get("executions_that_gather_everything") == e.get("executions")
            && e.get("greatest_error") < 0.1,
        "every execution gathers every object and stays within 10 cm of its reference",
        "an execution loses an object or strays by 10 cm or more",
    )
}

pub(super) fn adaptation_needed(e: &Evidence) -> Outcome {
    let drives = e.get("drives");
    let complete = |key: &str| e.get(key) == drives;
    if drives.is_nan() || !complete("complete_at_1x_adaptive") {
        return NotShown(
            "the adaptive law does not complete its drives at the paper's load".to_owned(),
        );
    }
    if !complete("complete_at_1x_feedback_alone") && !complete("complete_at_1x_integral") {
        return Shown("at the paper's load no other law completes its drives".to_owned());
    }
    let heavy = complete("complete_at_16x_adaptive") && !complete("complete_at_16x_feedback_alone");
    match (heavy, complete("complete_at_16x_integral")) {
        (true, false) => ShownIf("the load is far heavier than the paper's: at its own load velocity feedback alone gathers everything".to_owned()),
        (true, true) => ShownIf("\u{201c}adaptive\u{201d} includes an integrator, and the load is far heavier than the paper's: at its own load velocity feedback alone gathers everything, and at sixteen times it an integral law does as well".to_owned()),
        (false, _) => NotShown("velocity feedback alone gathers everything, with the paper's load and with sixteen times it".to_owned()),
    }
}

pub(super) fn printed_adaptation(e: &Evidence) -> Outcome {
    let (whole, bias, printed, nothing) = (
        e.get("rms_at_16x_whole_law"),
        e.get("rms_at_16x_bias_alone"),
        e.get("rms_at_16x_as_printed"),
        e.get("rms_at_16x_nothing"),
    );
    let complete = e.get("complete_at_16x_as_printed") == e.get("drives");
    let better = printed < nothing;
    if !better {
        return NotShown(
            "the printed law tracks no better than velocity feedback alone".to_owned(),
        );
    }
    if printed <= 1.5 * whole && complete {
        return Shown("it tracks nearly as well as with our bias".to_owned());
    }
    match (complete, bias < printed) {
        (true, true) => ShownIf("errors of several centimeters are good enough: it gathers everything, but what carries the tracking is a bias that the paper does not have, since a dragged net is dry friction".to_owned()),
        _ => NotShown("at sixteen times the load it does not gather everything: what carries the tracking is a bias that the paper does not have, since a dragged net is dry friction".to_owned()),
    }
}

pub(super) fn gains(e: &Evidence) -> Outcome {
    let (slow, usual, fast) = (
        e.get("rms_at_a_tenth_of_the_rates"),
        e.get("rms_at_the_rates"),
        e.get("rms_at_ten_times_the_rates"),
    );
    let faster = usual < slow;
    let oscillates = fast > usual;
    let saturates = e.get("drives_lost_with_0.04_N_m") > 0.0;
    match (faster, oscillates, saturates) {
        (true, true, true) => Shown("errors fall with the rates, rise again at ten times the default, and a low torque limit loses the load".to_owned()),
        (true, false, true) => ShownIf("oscillations are left out: errors still fall at ten times the default rates, and a low torque limit loses the load".to_owned()),
        (true, true, false) => ShownIf("saturation is left out: errors fall with the rates and rise again at ten times the default, but a torque limit of 0.04 N m bears the load".to_owned()),
        _ => NotShown("errors do not fall with the rates, or neither oscillation nor saturation is seen".to_owned()),
    }
}
