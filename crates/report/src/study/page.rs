use super::style::STYLE;
use super::{Block, Finding, Section, Study, Table, Tone, chart, picture};
use crate::map;
use crate::page::table::{close_table, open_table_of};
use crate::page::{STYLE as PAGE, head};
use crate::svg::Writer;

/// One HTML page without any external resource: all findings first, then the sections.
pub fn study_html(study: &Study) -> String {
    let mut w = Writer::default();
    w.raw("<!DOCTYPE html>\n");
    w.open("html", &[("lang", &"en")]);
    head(&mut w, &study.title, &[map::STYLE, PAGE, STYLE]);
    w.open("body", &[("class", &"study")]);
    w.open("header", &[]);
    w.text("h1", &[], &study.title);
    w.text("p", &[("class", &"facts")], &study.facts);
    w.open("div", &[("class", &"badges")]);
    for (tone, class) in [
        (Tone::For, "badge good"),
        (Tone::Partly, "badge"),
        (Tone::Against, "badge bad"),
    ] {
        let count = study.findings.iter().filter(|f| f.tone == tone).count();
        let words = (study.findings.iter().find(|f| f.tone == tone)).map(|f| f.verdict);
        if let Some(words) = words {
            w.text("span", &[("class", &class)], &format!("{count} {words}"));
        }
    }
    w.close();
    w.close();
    w.open("main", &[]);
    w.open("nav", &[("class", &"card"), ("aria-label", &"Contents")]);
    w.open("ol", &[]);
    for section in &study.sections {
        w.open("li", &[]);
        let address = format!("#{}", section.id);
        w.text("a", &[("href", &address)], &section.title);
        w.close();
    }
    w.close();
    w.close();
    w.open("section", &[("id", &"verdicts"), ("class", &"card")]);
    w.text("h2", &[], "The paper's claims");
    findings(&mut w, &study.findings);
    w.close();
    for section in &study.sections {
        w.raw(&section.html);
    }
    w.finish()
}

/// A section as it stands on the page.
pub fn section_html(section: &Section) -> String {
    let mut w = Writer::default();
    w.open("section", &[("id", &section.id), ("class", &"card")]);
    w.text("h2", &[], &section.title);
    for (i, block) in section.blocks.iter().enumerate() {
        match block {
            Block::Text(text) => w.text("p", &[], text),
            Block::Heading(text) => w.text("h3", &[("class", &"part")], text),
            Block::Table(table) => draw_table(&mut w, table),
            Block::Findings(list) => findings(&mut w, list),
            Block::Figures(charts, pictures) => {
                w.open("div", &[("class", &"figures")]);
                for (k, one) in pictures.iter().enumerate() {
                    picture::draw(&mut w, one, &format!("{}-{i}-{k}", section.id));
                }
                for one in charts {
                    chart::draw(&mut w, one);
                }
                w.close();
            }
        }
    }
    w.finish()
}

fn draw_table(w: &mut Writer, table: &Table) {
    if !table.caption.is_empty() {
        w.text("p", &[("class", &"caption")], &table.caption);
    }
    let heads: Vec<(&str, bool)> = (table.heads.iter())
        .map(|(h, n)| (h.as_str(), *n))
        .collect();
    open_table_of(w, &heads);
    for row in &table.rows {
        w.open("tr", &[]);
        for (i, cell) in row.iter().enumerate() {
            let is_number = table.heads.get(i).is_some_and(|head| head.1);
            match (i, is_number) {
                (0, _) => w.text("th", &[("scope", &"row")], cell),
                (_, true) => w.text("td", &[("class", &"number")], cell),
                _ => w.text("td", &[], cell),
            }
        }
        w.close();
    }
    close_table(w);
}

fn findings(w: &mut Writer, list: &[Finding]) {
    w.open("div", &[("class", &"findings")]);
    for finding in list {
        let class = match finding.tone {
            Tone::For => "badge good",
            Tone::Partly => "badge",
            Tone::Against => "badge bad",
        };
        w.open("article", &[("class", &"finding")]);
        w.open("p", &[]);
        w.text("span", &[("class", &class)], finding.verdict);
        w.text("strong", &[], &finding.claim);
        w.text("span", &[("class", &"place")], &finding.place);
        w.close();
        w.text("p", &[], &finding.because);
        w.open("ul", &[("class", &"evidence")]);
        for (name, value) in &finding.evidence {
            w.open("li", &[]);
            w.text("span", &[], name);
            w.text("b", &[], value);
            w.close();
        }
        w.close();
        w.close();
    }
    w.close();
}
