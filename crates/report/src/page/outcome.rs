//! What became of a plan: its verdicts, what went wrong, the events and trials of its drives.

use super::table::{close_table, go_to, open_card, open_table};
use crate::svg::Writer;
use crate::words;
use pairtrawl_model::{
    Event, ExecutionSummary, Frames, Rehearsal, Summary, TrackingStatistics, TrialSummary, numbers,
};

/// The verdicts, the one on what was driven before the one on what was planned.
pub(super) fn badges(w: &mut Writer, summary: &Summary) {
    w.open("p", &[("class", &"badges")]);
    let mut badge = |class: &str, text: &str| {
        w.text("span", &[("class", &format_args!("badge {class}"))], text);
    };
    if let Some(execution) = &summary.execution {
        let complete = complete(execution);
        let words = format!(
            "{complete} of {} trials gathered everything",
            execution.trials_wanted
        );
        match complete == execution.trials_wanted {
            true => badge("good", &format!("\u{2713} {words}")),
            false => badge("bad", &format!("\u{2717} {words}")),
        }
    }
    match is_certified(summary) {
        true => badge("good", "\u{2713} plan certified"),
        false => badge("bad", "\u{2717} plan not certified"),
    }
    match summary.rehearsal {
        Rehearsal::Passed => badge("good", "\u{2713} rehearsal passed"),
        Rehearsal::Failed { .. } => badge("bad", "\u{2717} rehearsal failed"),
        Rehearsal::Skipped => badge("plain", words::no_rehearsal(summary)),
    }
    w.close();
}

/// What went wrong, when something did: trials first, then the rehearsal, then the certificate.
pub(super) fn failures(w: &mut Writer, summary: &Summary) {
    let rehearsal = match &summary.rehearsal {
        Rehearsal::Failed { event, time, place } => Some((event, *time, *place)),
        _ => None,
    };
    let execution = summary.execution.as_ref();
    let bad_run = execution.is_some_and(|e| complete(e) < e.trials_wanted);
    if !bad_run && rehearsal.is_none() && is_certified(summary) {
        return;
    }
    open_card(w, "failures", "What went wrong");
    w.open("ul", &[]);
    if let Some(execution) = execution {
        let objects = summary.gathers();
        for (i, trial) in execution
            .trials
            .iter()
            .enumerate()
            .filter(|(_, t)| !t.complete)
        {
            w.open("li", &[]);
            failed_trial(w, i, trial, objects, i == execution.shown);
            w.close();
        }
        let missing = execution
            .trials_wanted
            .saturating_sub(execution.trials.len());
        if missing > 0 {
            let words = format!(
                "{missing} of {} trials were not finished.",
                execution.trials_wanted
            );
            w.text("li", &[], &words);
        }
    }
    if let Some((event, time, place)) = rehearsal {
        w.open("li", &[]);
        w.text("span", &[], &format!("The rehearsal failed: {event}"));
        let label = format!("at {}, {}", numbers::duration(time), numbers::place(place));
        let time = summary.frames.as_ref().map(|_| time);
        go_to(w, "rehearsal", time, Some(place), &label);
        w.close();
    }
    for c in summary.claims.iter().filter(|c| !c.claim.holds) {
        let margin = numbers::quantity(-c.claim.margin, c.unit);
        let id = c.claim.id;
        let words = if c.claim.margin.is_finite() {
            format!("The claim {id} of the plan fails by {margin}.")
        } else {
            format!("The claim {id} of the plan fails: {}.", c.claim.detail)
        };
        w.text("li", &[], &words);
    }
    if summary.claims.is_empty() {
        w.text("li", &[], "No claim of the plan was checked.");
    }
    w.close();
    w.close();
}

fn failed_trial(w: &mut Writer, index: usize, trial: &TrialSummary, objects: usize, shown: bool) {
    let words = format!(
        "Trial {index} gathered {} of {objects} objects",
        trial.gathered
    );
    match &trial.event {
        None => w.text("span", &[], &format!("{words}.")),
        Some(event) => {
            w.text("span", &[], &format!("{words}: {}", event.text));
            let label = format!("at {}", numbers::duration(event.time));
            let time = shown.then_some(event.time);
            go_to(w, "run", time, Some(event.place), &label);
        }
    }
}

/// What happened in the rehearsal and in the trial that is shown, when something did.
pub(super) fn events(w: &mut Writer, summary: &Summary) {
    let run = summary.execution.as_ref().and_then(|e| e.frames.as_ref());
    let of =
        |frames: Option<&Frames>| -> Vec<Event> { frames.map_or(Vec::new(), |f| f.events.clone()) };
    let events = [("rehearsal", of(summary.frames.as_ref())), ("run", of(run))];
    if events.iter().all(|(_, e)| e.is_empty()) {
        return;
    }
    open_card(w, "events", "Events");
    open_table(w, &["in", "when", "what"]);
    for (source, e) in events
        .iter()
        .flat_map(|(s, list)| list.iter().map(move |e| (s, e)))
    {
        w.open("tr", &[]);
        w.text("th", &[("scope", &"row")], source);
        w.open("td", &[]);
        go_to(
            w,
            source,
            Some(e.time),
            Some(e.place),
            &numbers::duration(e.time),
        );
        w.close();
        w.text("td", &[], &e.text);
        w.close();
    }
    close_table(w);
    w.close();
}

/// The columns of trials.
const GATHERED: &str = "gathered";
const SETTLED: &str = "settled error";
const WHOLE_RUN: &str = "whole-run error";
const DRIVEN: &str = "J driven";
const EVENT: &str = "first event";

/// The trials of an execution.
pub(super) fn trials(w: &mut Writer, summary: &Summary) {
    let Some(execution) = &summary.execution else {
        return;
    };
    open_card(w, "trials", "Trials");
    let objects = summary.gathers();
    let words = format!(
        "{} of {} trials with the {} controller gathered all {objects} objects. Errors are distances from the reference, \
         root mean square / greatest, over the whole run and settled: without its first second.",
        complete(execution),
        execution.trials_wanted,
        execution.controller,
    );
    w.text("p", &[], &words);
    let columns = ["trial", GATHERED, SETTLED, WHOLE_RUN, DRIVEN, EVENT];
    open_table(w, &columns);
    for (i, t) in execution.trials.iter().enumerate() {
        w.open("tr", &[("class", &if t.complete { "" } else { "fails" })]);
        w.open("th", &[("scope", &"row")]);
        let shown = if i == execution.shown { " (shown)" } else { "" };
        w.text("span", &[], &format!("{i}{shown}"));
        w.text(
            "span",
            &[("class", &"meaning")],
            &format!("seed {}", t.seed),
        );
        w.close();
        let gathered = format!("{} of {objects}", t.gathered);
        w.text("td", &[("data-label", &GATHERED)], &gathered);
        errors(w, SETTLED, &t.tracking, |s| [s.settled_rms, s.settled_max]);
        errors(w, WHOLE_RUN, &t.tracking, |s| [s.rms, s.max]);
        let cost = words::cost(t.cost.total());
        w.text("td", &[("data-label", &DRIVEN)], &cost);
        let event = t.event.as_ref().map_or("none".to_owned(), |e| {
            format!("{}: {}", numbers::duration(e.time), e.text)
        });
        w.text("td", &[("data-label", &EVENT)], &event);
        w.close();
    }
    close_table(w);
    w.close();
}

/// One line a robot.
fn errors(
    w: &mut Writer,
    label: &str,
    tracking: &[TrackingStatistics; 2],
    of: fn(&TrackingStatistics) -> [f64; 2],
) {
    w.open("td", &[("data-label", &label)]);
    for (robot, statistics) in ["left", "right"].into_iter().zip(tracking) {
        let words = format!("{robot} {}", numbers::lengths(&of(statistics)));
        w.text("span", &[("class", &"line")], &words);
    }
    w.close();
}

fn complete(execution: &ExecutionSummary) -> usize {
    execution.trials.iter().filter(|t| t.complete).count()
}

fn is_certified(summary: &Summary) -> bool {
    !summary.claims.is_empty() && summary.claims.iter().all(|c| c.claim.holds)
}
