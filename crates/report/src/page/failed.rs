//! The page of a scene for which there is no plan: what is missing, a picture, everything that was tried.

use super::table::{close_table, open_card, open_table, row};
use crate::map;
use crate::plan_svg::failed_svg;
use crate::svg::Writer;
use crate::words;
use pairtrawl_model::{FailedSummary, numbers};

/// One self-contained HTML page about a scene for which there is no plan: why, what would help, a picture with the places
/// that are to be seen, every start that was tried. It says at its head that it is no plan.
pub fn failed_html(failed: &FailedSummary) -> String {
    let summary = &failed.summary;
    let mut w = Writer::default();
    w.raw("<!DOCTYPE html>\n");
    w.open("html", &[("lang", &"en")]);
    super::head(
        &mut w,
        &format!("{}: no plan", summary.title),
        &super::STYLES,
    );
    w.open("body", &[]);
    w.open("header", &[]);
    w.text("h1", &[], &summary.title);
    w.text("p", &[("class", &"facts")], &words::scene_facts(summary));
    w.open("p", &[("class", &"badges")]);
    let badge = format!("\u{2717} {}", words::no_plan(failed));
    w.text("span", &[("class", &"badge bad")], &badge);
    w.close();
    w.close();
    w.open("main", &[]);
    open_card(&mut w, "failures", "Why there is no plan");
    // What follows the first line stands in the tables below.
    let first = failed.message.lines().next().unwrap_or_default();
    w.text("p", &[], first);
    if let Some(help) = &failed.help {
        w.text("p", &[], &format!("What would help: {help}."));
    }
    w.close();
    w.open("section", &[("class", &"card"), ("id", &"picture")]);
    w.raw(&failed_svg(failed));
    w.close();
    marks(&mut w, failed);
    claims(&mut w, failed);
    tried(&mut w, failed);
    w.finish()
}

fn marks(w: &mut Writer, failed: &FailedSummary) {
    if failed.summary.marks.is_empty() {
        return;
    }
    open_card(w, "marks", "Places to look at");
    open_table(w, &["mark", "where", "what"]);
    for (i, mark) in failed.summary.marks.iter().enumerate() {
        row(
            w,
            &map::mark_name(i),
            &[&numbers::place(mark.place), &mark.text],
        );
    }
    close_table(w);
    w.close();
}

/// The claims of the best attempt that fail.
fn claims(w: &mut Writer, failed: &FailedSummary) {
    let claims = &failed.summary.claims;
    let failing: Vec<_> = claims.iter().filter(|c| !c.claim.holds).collect();
    if failing.is_empty() {
        return;
    }
    open_card(w, "claims", "Claims that the best attempt fails");
    open_table(w, &["claim", "by", "where", "what"]);
    for summary in failing {
        let claim = &summary.claim;
        let place = claim.place.map_or(String::new(), numbers::place);
        row(
            w,
            claim.id.name(),
            &[
                &numbers::quantity(-claim.margin, summary.unit),
                &place,
                &claim.detail,
            ],
        );
    }
    close_table(w);
    w.close();
}

fn tried(w: &mut Writer, failed: &FailedSummary) {
    if failed.tried.is_empty() {
        return;
    }
    open_card(w, "tried", "What was tried");
    open_table(w, &["start", "what was missing"]);
    for (start, missing) in &failed.tried {
        row(w, start, &[missing]);
    }
    close_table(w);
    w.close();
}
