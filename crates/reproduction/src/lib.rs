//! The experiments of Su, Jiang, Zhu and Liu, "Object Gathering with a Tethered Robot Duo", IEEE RA-L 2022, as functions.
//!
//! Each module makes one kind of experiment and offers it as a function that returns numbers; its chapter puts them into
//! tables, charts and pictures, and into the evidence of verdicts. [`CHAPTERS`] lists them, [`make`] makes one,
//! [`study`] joins what was made into a page. A verdict is a function of its evidence alone: [`verdict::judge`].
//!
//! Nothing here reads a file or a clock: the caller brings both ([`Host`]), and keeps finished work so that a run that was
//! interrupted goes on. The same program and the same input give the same numbers, whatever the number of threads, but for
//! [`chapter::Timing`].

pub mod authors;
pub mod chapter;
pub mod claims;
mod drawing;
pub mod drives;
pub mod evidence;
pub mod executions;
pub mod judged;
mod lab;
pub mod laws;
pub mod neighbors;
pub mod net_length;
pub mod pair_search;
pub mod planning;
pub mod published;
pub mod reading;
pub mod scenes;
pub mod selection;
pub mod separation;
pub mod setup;
pub mod solving;
pub mod tracking;
pub mod two_lengths;
pub mod verdict;

pub use chapter::{Chapter, Made};
pub use lab::{Host, Lab, Stopped, Watch};

use pairtrawl::report::study::Study;

/// The parts of the reproduction, in the order of the page.
pub const CHAPTERS: &[Chapter] = &[
    Chapter {
        id: "planning",
        title: "Planning (Figs. 2 and 3, Algorithm 1)",
        make: planning::chapter,
    },
    Chapter {
        id: "net-length",
        title: "The length of the net (Fig. 5)",
        make: net_length::chapter,
    },
    Chapter {
        id: "two-lengths",
        title: "2.32 m and 1.45 m: which reading gives which length",
        make: two_lengths::chapter,
    },
    Chapter {
        id: "separation",
        title: "The cost of the separation (Fig. 6)",
        make: separation::chapter,
    },
    Chapter {
        id: "executions",
        title: "Five executions (Figs. 4, 7 and 8)",
        make: executions::chapter,
    },
    Chapter {
        id: "tracking",
        title: "Adaptive control, fairly",
        make: tracking::chapter,
    },
    Chapter {
        id: "published",
        title: "The authors' published trajectories",
        make: published::chapter,
    },
    Chapter {
        id: "neighbors",
        title: "Neighbors: what other methods give up",
        make: neighbors::chapter,
    },
    Chapter {
        id: "setup",
        title: "Setup (Section IV-A, Table I)",
        make: setup::chapter,
    },
];

/// Makes a part, or takes it from an earlier run.
///
/// # Errors
/// When the host stops it, or an experiment cannot be made.
pub fn make(chapter: &Chapter, lab: &Lab) -> Result<Made, Stopped> {
    let name = format!("chapter-{}", chapter.id);
    lab.remember(&name, || {
        let content = (chapter.make)(lab)?;
        Ok(Made::of(chapter.id, chapter.title, content))
    })
}

/// All parts as one page.
pub fn study(parts: &[Made], quick: bool) -> Study {
    let verdicts = parts.iter().flat_map(|part| &part.verdicts);
    let facts = "Every experiment of Su, Jiang, Zhu and Liu, \u{201c}Object Gathering with a Tethered Robot Duo\u{201d} (IEEE RA-L 2022), made again: figures and tables, ours beside the paper's numbers, and what the numbers say about each claim.";
    let facts = match quick {
        true => format!("{facts} This is the quick version: fewer lengths, seeds and variants."),
        false => facts.to_owned(),
    };
    Study {
        title: "The paper, reproduced".to_owned(),
        facts,
        findings: verdicts.map(verdict::Verdict::finding).collect(),
        sections: parts.iter().map(Made::section).collect(),
    }
}
