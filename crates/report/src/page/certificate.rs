//! The claims of a plan's certificate; their places are buttons that take the map there.

use super::table::{close_table, go_to, named, number, open_card, open_table};
use crate::svg::Writer;
use crate::words;
use pairtrawl_model::{ClaimSummary, Summary, numbers};

pub(super) fn card(w: &mut Writer, summary: &Summary) {
    let claims = &summary.claims;
    open_card(w, "certificate", "Certificate of the plan");
    let held = claims.iter().filter(|c| c.claim.holds).count();
    let verdict = match (held, claims.len()) {
        (_, 0) => "No claim was checked.".to_owned(),
        (h, n) if h == n => {
            format!("All {n} claims hold, each proven by exact geometry over every step.")
        }
        (h, n) => format!("{} of {n} claims fail.", n - h),
    };
    w.text("p", &[], &verdict);
    open_table(w, &["claim", "holds", "margin", "tightest at"]);
    // What fails comes first.
    let (holding, failing): (Vec<_>, Vec<_>) = claims.iter().partition(|c| c.claim.holds);
    for c in failing.into_iter().chain(holding) {
        let (class, verdict) = match c.claim.holds {
            true => ("holds", "\u{2713} yes"),
            false => ("fails", "\u{2717} no"),
        };
        w.open("tr", &[("class", &class)]);
        named(w, c.claim.id.name(), c.meaning);
        w.text("td", &[], verdict);
        let margin = numbers::quantity(c.claim.margin, c.unit);
        number(w, &words::typeset(&margin));
        w.open("td", &[]);
        place(w, c);
        w.close();
        w.close();
    }
    close_table(w);
    w.close();
}

fn place(w: &mut Writer, c: &ClaimSummary) {
    let step = c.claim.step.map(|s| format!("step {s}"));
    let time = c.time.map(numbers::duration);
    let place = c.claim.place.filter(|p| p.is_finite());
    let words: Vec<String> = [step, time, place.map(numbers::place)]
        .into_iter()
        .flatten()
        .collect();
    go_to(w, "plan", c.time, place, &words.join(", "));
    if !c.claim.detail.is_empty() {
        w.text("span", &[("class", &"meaning")], &c.claim.detail);
    }
}
