use crate::arguments::ReproduceArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{Done, Report, to_json};
use crate::reproduce::{Bench, unfinished};
use crate::results::{Results, in_folder};
use pairtrawl::files::sha256_hex;
use pairtrawl_reproduction::authors::{Authors, FILES as AUTHORS_FILES};
use pairtrawl_reproduction::verdict::Verdict;
use pairtrawl_reproduction::{CHAPTERS, Chapter, Lab, Made, Stopped, study};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// The files of a reproduction, its numbers first.
const FILES: &[&str] = &["reproduction.json", "reproduction.html"];
/// Greatest size of a file of the authors', bytes.
const MOST_BYTES: u64 = 16_000_000;

/// What the experiments say about the paper's claims.
#[derive(Clone, Serialize, JsonSchema)]
pub struct ReproductionReport {
    /// True when fewer lengths, seeds and variants were computed.
    quick: bool,
    /// The parts that were made, in the order of the page.
    parts: Vec<String>,
    /// What the numbers say about each claim.
    verdicts: Vec<VerdictObject>,
    /// Times that were measured: the only numbers that differ between runs.
    timings: Vec<TimingObject>,
}

/// What numbers say about a claim.
#[derive(Clone, Serialize, JsonSchema)]
struct VerdictObject {
    /// A name of the claim for programs.
    key: String,
    /// The claim.
    claim: String,
    /// Where the paper makes it.
    place: String,
    /// The verdict.
    #[schemars(extend("enum" = ["shown", "not shown", "shown if"]))]
    verdict: &'static str,
    /// The condition of `shown if`; why otherwise.
    because: String,
    /// The numbers that the verdict follows from, and follows from alone, in SI units; null: there is none.
    evidence: BTreeMap<String, Option<f64>>,
}

/// A time that was measured.
#[derive(Clone, Serialize, JsonSchema)]
struct TimingObject {
    /// Of what.
    name: String,
    /// How long it took, s.
    seconds: f64,
}

/// `pairtrawl reproduce`: every experiment of the paper, with a verdict on each of its claims.
pub fn reproduce(arguments: &ReproduceArguments) -> Result<Done, Failure> {
    let chosen = chosen(&arguments.only)?;
    let authors = (arguments.authors_data.as_deref()).map(read_authors);
    let authors = authors.transpose()?;
    in_folder(&arguments.output, FILES, |results| {
        let known = authors.as_ref().map(|(_, text)| text.as_str());
        let bench = Bench::new(&arguments.output, &chosen, arguments.quick, known)?;
        let lab = Lab {
            quick: arguments.quick,
            host: &bench,
            authors: authors.as_ref().map(|(authors, _)| authors),
        };
        let made = interrupt::gracefully(|| bench.all(&lab, &chosen));
        bench.finish();
        match made {
            Ok(parts) => write(&parts, arguments, results),
            Err(Stopped::Interrupted) => Err(Failure::new(Exit::Interrupted, "interrupted")
                .with_help("what is finished is kept: the same command goes on from there")),
            Err(failed) => Err(Failure::new(Exit::NoPlan, failed.to_string())),
        }
    })
}

/// The parts to be made; all of them when none is named.
fn chosen(only: &[String]) -> Result<Vec<&'static Chapter>, Failure> {
    if let Some(unknown) = only
        .iter()
        .find(|name| !CHAPTERS.iter().any(|c| c.id == **name))
    {
        let names: Vec<&str> = CHAPTERS.iter().map(|c| c.id).collect();
        return Err(Failure::new(
            Exit::Usage,
            format!(
                "--only names {unknown}, which is no part; the parts are {}",
                names.join(", ")
            ),
        ));
    }
    let wanted = |chapter: &&Chapter| only.is_empty() || only.iter().any(|name| name == chapter.id);
    Ok(CHAPTERS.iter().filter(wanted).collect())
}

/// The authors' trajectories, and a name of their contents.
fn read_authors(folder: &Path) -> Result<(Authors, String), Failure> {
    let mut texts = Vec::new();
    for name in AUTHORS_FILES {
        let path = folder.join(name);
        let bytes = pairtrawl::files::read_bounded(&path, MOST_BYTES)?;
        let text = String::from_utf8(bytes)
            .map_err(|_| Failure::new(Exit::BadInput, format!("{} is not text", path.display())))?;
        texts.push(text);
    }
    let [first, second, third] = &texts[..] else {
        return Err(Failure::new(
            Exit::Internal,
            "three files of the authors' are read",
        ));
    };
    let authors = Authors::parse([first, second, third]).map_err(|error| {
        let message = format!("{}: {error}", folder.display());
        Failure::new(Exit::BadInput, message)
    })?;
    Ok((authors, sha256_hex(&[texts.join("\n").as_bytes()])))
}

fn write(
    parts: &[Made],
    arguments: &ReproduceArguments,
    results: &Results<'_>,
) -> Result<Done, Failure> {
    let about = report(parts, arguments.quick);
    let page = pairtrawl::report::study::study_html(&study(parts, arguments.quick));
    let json = format!("{}\n", to_json(&about)?);
    let files = results.write(&[("reproduction.html", page), ("reproduction.json", json)])?;
    unfinished::remove(&arguments.output);
    let text = text(&about);
    Report::new("reproduce", Exit::Done, about).done(Exit::Done, text, &[], &files)
}

fn report(parts: &[Made], quick: bool) -> ReproductionReport {
    let object = |verdict: &Verdict| {
        let finding = verdict.finding();
        VerdictObject {
            key: verdict.key.clone(),
            claim: finding.claim,
            place: finding.place,
            verdict: finding.verdict,
            because: finding.because,
            evidence: (verdict.evidence.numbers().iter())
                .map(|n| (n.name.clone(), n.value))
                .collect(),
        }
    };
    ReproductionReport {
        quick,
        parts: parts.iter().map(|part| part.id.clone()).collect(),
        verdicts: parts.iter().flat_map(|p| &p.verdicts).map(object).collect(),
        timings: (parts.iter().flat_map(|p| &p.timings))
            .map(|t| TimingObject {
                name: t.name.clone(),
                seconds: t.seconds,
            })
            .collect(),
    }
}

fn text(about: &ReproductionReport) -> String {
    let mut text = String::from("the paper, reproduced\n");
    for v in &about.verdicts {
        let _ = writeln!(text, "  {:<10} {}", v.verdict, v.claim);
        let _ = writeln!(text, "             {}", v.because);
    }
    for t in &about.timings {
        let _ = writeln!(
            text,
            "  {}: {}",
            t.name,
            pairtrawl::model::numbers::duration(t.seconds)
        );
    }
    text
}
