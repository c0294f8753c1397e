//! A page about a study: findings, tables, charts and pictures in sections, all of them finished numbers.
//!
//! [`section_html`] renders one section by itself, so that what was computed can be kept and joined later by [`study_html`].

mod chart;
mod curve_labels;
mod page;
mod picture;
mod style;

pub use chart::{Axis, Band, Chart, Curve, Line, Mark, chart_svg};
pub use page::{section_html, study_html};
pub use picture::{Note, Pen, Picture, Track, Wash};

/// A page.
#[derive(Clone, Debug, PartialEq)]
pub struct Study {
    /// Its heading.
    pub title: String,
    /// What it is about, in a sentence or two.
    pub facts: String,
    /// All findings, in the order of the sections.
    pub findings: Vec<Finding>,
    /// Sections as [`section_html`] rendered them, with their identifiers and headings.
    pub sections: Vec<RenderedSection>,
}

/// A section that is rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct RenderedSection {
    /// A name for links.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// Its markup.
    pub html: String,
}

/// A part of the page.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// A name for links.
    pub id: String,
    /// Its heading.
    pub title: String,
    /// What stands in it.
    pub blocks: Vec<Block>,
}

/// What a section is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A paragraph.
    Text(String),
    /// A heading within the section.
    Heading(String),
    /// A table.
    Table(Table),
    /// Pictures of the floor and charts beside each other.
    Figures(Vec<Chart>, Vec<Picture>),
    /// What follows from the numbers of the section.
    Findings(Vec<Finding>),
}

/// A table of text.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// What it shows.
    pub caption: String,
    /// The heads of its columns; true: a column of numbers.
    pub heads: Vec<(String, bool)>,
    /// Its rows, as long as the heads; the first cell names the row.
    pub rows: Vec<Vec<String>>,
}

impl Table {
    /// A table without rows. A head that begins with `#` is one of numbers.
    pub fn new(caption: &str, heads: &[&str]) -> Self {
        let head = |head: &&str| match head.strip_prefix('#') {
            Some(name) => (name.to_owned(), true),
            None => ((*head).to_owned(), false),
        };
        Self {
            caption: caption.to_owned(),
            heads: heads.iter().map(head).collect(),
            rows: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn row<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}

/// What the numbers say about a claim.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The claim.
    pub claim: String,
    /// Where it is made.
    pub place: String,
    /// `shown`, `not shown` or `shown if`.
    pub verdict: &'static str,
    /// How good that is for the claim.
    pub tone: Tone,
    /// The condition, or why.
    pub because: String,
    /// The numbers that it follows from, by name.
    pub evidence: Vec<(String, String)>,
}

/// How a finding stands to its claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// It bears the claim out.
    For,
    /// It does so under a condition.
    Partly,
    /// It does not.
    Against,
}
