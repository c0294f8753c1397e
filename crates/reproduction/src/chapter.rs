//! A part of the reproduction: what is shown, what follows, what was timed.

use crate::lab::{Lab, Stopped};
use crate::verdict::Verdict;
use pairtrawl::report::study::{
    Block, Chart, Picture, RenderedSection, Section, Table, section_html,
};
use serde::{Deserialize, Serialize};

/// A part that can be made.
#[derive(Clone, Copy)]
pub struct Chapter {
    /// A name for links and files.
    pub id: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// Makes it.
    pub make: fn(&Lab) -> Result<Content, Stopped>,
}

/// What a part shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Content {
    /// Texts, tables, charts and pictures.
    pub blocks: Vec<Block>,
    /// What follows from their numbers.
    pub verdicts: Vec<Verdict>,
    /// Times that were measured: the only numbers that differ between runs.
    pub timings: Vec<Timing>,
}

/// A time that was measured.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Timing {
    /// Of what.
    pub name: String,
    /// How long it took, s.
    pub seconds: f64,
}

impl Content {
    /// Adds a paragraph.
    pub fn text(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// Adds a heading.
    pub fn heading(&mut self, text: &str) {
        self.blocks.push(Block::Heading(text.to_owned()));
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) {
        self.blocks.push(Block::Table(table));
    }

    /// Adds charts beside each other.
    pub fn charts(&mut self, charts: Vec<Chart>) {
        self.figures(charts, Vec::new());
    }

    /// Adds charts and pictures beside each other.
    pub fn figures(&mut self, charts: Vec<Chart>, pictures: Vec<Picture>) {
        self.blocks.push(Block::Figures(charts, pictures));
    }

    /// Adds pictures beside each other.
    pub fn pictures(&mut self, pictures: Vec<Picture>) {
        self.figures(Vec::new(), pictures);
    }

    /// Adds a verdict.
    pub fn verdict(&mut self, verdict: Verdict) {
        self.verdicts.push(verdict);
    }
}

/// A part that was made, as it is kept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Made {
    /// A name for links and files.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// Its markup.
    pub html: String,
    /// What follows from its numbers.
    pub verdicts: Vec<Verdict>,
    /// Times that were measured.
    pub timings: Vec<Timing>,
}

impl Made {
    /// A part with its content, rendered.
    pub fn of(id: &str, title: &str, mut content: Content) -> Self {
        if !content.verdicts.is_empty() {
            let findings = content.verdicts.iter().map(Verdict::finding);
            content.blocks.push(Block::Findings(findings.collect()));
        }
        let section = Section {
            id: id.to_owned(),
            title: title.to_owned(),
            blocks: content.blocks,
        };
        Self {
            id: section.id.clone(),
            title: section.title.clone(),
            html: section_html(&section),
            verdicts: content.verdicts,
            timings: content.timings,
        }
    }

    /// As it stands on the page.
    pub fn section(&self) -> RenderedSection {
        RenderedSection {
            id: self.id.clone(),
            title: self.title.clone(),
            html: self.html.clone(),
        }
    }
}
