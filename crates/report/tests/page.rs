//! The page as an independent HTML parser sees it.

mod sample;

use pairtrawl_model::{Rehearsal, SolverReport, Summary, Warning};
use pairtrawl_report::report_html;
use scraper::{Html, Selector};
use serde_json::Value;

fn parse(page: &str) -> Html {
    let document = Html::parse_document(page);
    assert_eq!(document.errors, Vec::<String>::new());
    document
}

fn select(css: &str) -> Selector {
    Selector::parse(css).unwrap()
}

fn count(document: &Html, css: &str) -> usize {
    document.select(&select(css)).count()
}

fn text(document: &Html, css: &str) -> String {
    document
        .select(&select(css))
        .next()
        .unwrap()
        .text()
        .collect()
}

fn text_of_all(document: &Html, css: &str) -> Vec<String> {
    let selector = select(css);
    let all = document.select(&selector);
    all.map(|e| e.text().collect()).collect()
}

fn data(document: &Html) -> Value {
    serde_json::from_str(&text(document, "script#data")).unwrap()
}

/// Numbers as the page's script unpacks them.
fn unpack(list: &Value, unit: f64) -> Vec<f64> {
    let mut sum = 0;
    let list = list.as_array().unwrap().iter();
    list.map(|d| {
        sum += d.as_i64().unwrap();
        sum as f64 * unit
    })
    .collect()
}

fn hostile(mut summary: Summary) -> Summary {
    let text = "</script><b>\"'&\u{0}\u{2028}<!--<script>";
    summary.title = text.to_owned();
    summary.warnings = vec![Warning::Stated(text.to_owned())];
    summary.claims[0].claim.detail = text.to_owned();
    summary.stages[0].name = text.to_owned();
    summary.panels[0].title = text.to_owned();
    summary.panels[0].lines[0].label = text.to_owned();
    summary
}

#[test]
fn the_page_is_well_formed_and_complete() {
    for summary in [
        sample::summary(8),
        sample::with_motion(sample::summary(8), 20, 6),
    ] {
        let document = parse(&report_html(&summary));
        assert_eq!(text(&document, "h1"), "a small hall");
        assert_eq!(count(&document, "#layer-objects .object"), 2);
        assert_eq!(count(&document, "#layer-obstacles .obstacle"), 3);
        assert_eq!(count(&document, "#certificate tbody tr"), 2);
        assert_eq!(count(&document, "#certificate tr.fails"), 1);
        assert_eq!(count(&document, "#certificate button.goto"), 1);
        assert_eq!(count(&document, "#player button"), 5);
        assert_eq!(count(&document, "#player input[type=range][aria-label]"), 1);
        assert!(text(&document, "#certificate").contains("1 of 2 claims fail"));
        assert!(text(&document, "#cost").contains("100.0"));
        // Every button has a name for those who cannot see it.
        for button in document.select(&select("button")) {
            let name = button.value().attr("aria-label").map(str::to_owned);
            assert!(!name.unwrap_or_else(|| button.text().collect()).is_empty());
        }
        // Every check box has a layer to switch.
        for check in document.select(&select("#layers input")) {
            let layer = check.value().attr("data-layer").unwrap();
            assert_eq!(count(&document, &format!("#{layer}")), 1, "{layer}");
        }
    }
}

#[test]
fn motion_adds_what_it_has() {
    let document = parse(&report_html(&sample::with_motion(
        sample::summary(8),
        20,
        6,
    )));
    assert_eq!(count(&document, "#source option"), 3);
    assert_eq!(count(&document, "#trials tbody tr"), 2);
    assert_eq!(count(&document, "#events tbody tr"), 2);
    assert_eq!(count(&document, "#layer-ribbons .ribbon"), 1);
    assert!(text(&document, "#trials").contains("1 of 2 trials"));
    let without = parse(&report_html(&sample::summary(8)));
    assert_eq!(
        count(&without, "#source, #trials, #events, #layer-ribbons"),
        0
    );
}

#[test]
fn failure_comes_first_and_what_is_not_known_is_not_made_up() {
    let mut summary = sample::with_motion(sample::summary(8), 20, 6);
    summary.claims.truncate(1);
    summary.solver = SolverReport::NOT_STATED;
    summary.rehearsal = Rehearsal::Skipped;
    let document = parse(&report_html(&summary));
    let badges: Vec<(String, String)> = document
        .select(&select(".badge"))
        .map(|b| {
            (
                b.value().attr("class").unwrap().to_owned(),
                b.text().collect(),
            )
        })
        .collect();
    assert_eq!(badges[0].0, "badge bad");
    assert_eq!(badges[0].1, "\u{2717} 1 of 2 trials gathered everything");
    assert_eq!(badges[1].1, "\u{2713} plan certified");
    assert_eq!(badges[2].1, "rehearsal not stated");
    let first = document.select(&select("main > section")).next().unwrap();
    assert_eq!(first.value().attr("id"), Some("failures"));
    assert!(text(&document, "#failures li").starts_with("Trial 1 gathered 1 of 2 objects"));
    // Both errors, each by its name.
    let cell = |label: &str| text(&document, &format!("#trials td[data-label='{label}']"));
    assert!(cell("settled error").contains("left 3.00 / 9.00 mm"));
    assert!(cell("settled error").contains("right 4.00 / 8.00 mm"));
    assert!(cell("whole-run error").contains("right 5.00 / 20.0 mm"));
    assert!(text(&document, "#making").contains("not stated"));
    let main = document.select(&select("main")).next().unwrap();
    assert!(!main.text().any(|t| t.contains("NaN")));

    // All is well: nothing to say about failures.
    let execution = summary.execution.as_mut().unwrap();
    execution.trials.truncate(1);
    execution.trials_wanted = 1;
    let document = parse(&report_html(&summary));
    assert_eq!(count(&document, "#failures, .badge.bad"), 0);
    // A trial that was wanted and is not there counts.
    summary.execution.as_mut().unwrap().trials_wanted = 3;
    let document = parse(&report_html(&summary));
    assert!(text(&document, "#failures").contains("2 of 3 trials were not finished"));
}

#[test]
fn robots_are_told_apart_without_color() {
    let document = parse(&report_html(&sample::summary(60)));
    let letters = |layer: &str| text_of_all(&document, &format!("#labels-{layer} .letter"));
    assert_eq!(letters("ends"), ["L", "R", "L", "R"]);
    assert_eq!(letters("paths"), ["L", "R"]);
    assert_eq!(text_of_all(&document, "#labels-objects .index"), ["0", "1"]);
    assert_eq!(text_of_all(&document, "#labels-circles .visit"), ["1"]);
}

#[test]
fn hostile_text_stays_text() {
    let document = parse(&report_html(&hostile(sample::summary(4))));
    assert_eq!(count(&document, "script"), 2);
    assert_eq!(count(&document, "b"), 0);
    assert!(text(&document, "h1").starts_with("</script><b>\"'&"));
    assert!(text(&document, "#warnings li").contains("<!--<script>"));
    let panel = &data(&document)["panels"][0];
    assert_eq!(panel["title"], "</script><b>\"'&\u{0}\u{2028}<!--<script>");
}

#[test]
fn the_page_needs_nothing_else() {
    let page = report_html(&sample::with_motion(sample::summary(8), 20, 6));
    let document = parse(&page);
    for (css, attribute) in [("[src]", "src"), ("[href]", "href"), ("[srcset]", "srcset")] {
        for element in document.select(&select(css)) {
            let value = element.value().attr(attribute).unwrap();
            assert!(value.starts_with("data:"), "{attribute}={value}");
        }
    }
    // The only address is the name of SVG's namespace, which nobody fetches.
    let rest = page.replace("http://www.w3.org/2000/svg", "");
    for sign in [
        "http:",
        "https:",
        "url(",
        "@import",
        "fetch(",
        "import(",
        "XMLHttpRequest",
    ] {
        assert!(!rest.contains(sign), "{sign}");
    }
}

#[test]
fn the_embedded_data_are_the_trajectories() {
    let summary = sample::with_motion(sample::summary(8), 20, 6);
    let data = data(&parse(&report_html(&summary)));
    let plan = &data["motions"][0];
    let near = |a: &[f64], b: &[f64], bound: f64| {
        assert_eq!(a.len(), b.len());
        a.iter()
            .zip(b)
            .for_each(|(a, b)| assert!((a - b).abs() <= bound, "{a} {b}"));
    };
    let t = &summary.trajectory;
    let of = |poses: &[pairtrawl_geometry::Pose], f: fn(&pairtrawl_geometry::Pose) -> f64| {
        poses.iter().map(f).collect::<Vec<f64>>()
    };
    near(
        &unpack(&plan["left"][0], 1e-4),
        &of(&t.left, |p| p.x),
        0.5001e-4,
    );
    near(
        &unpack(&plan["left"][1], 1e-4),
        &of(&t.left, |p| p.y),
        0.5001e-4,
    );
    near(
        &unpack(&plan["right"][1], 1e-4),
        &of(&t.right, |p| p.y),
        0.5001e-4,
    );
    near(
        &unpack(&plan["right"][2], 1e-3),
        &of(&t.right, |p| p.heading),
        0.5001e-3,
    );
    let frames = summary.frames.as_ref().unwrap();
    let rehearsal = &data["motions"][1];
    assert_eq!(rehearsal["name"], "rehearsal");
    let third: Vec<f64> = frames.net.iter().map(|net| net[3].x).collect();
    near(&unpack(&rehearsal["net"][3][0], 1e-4), &third, 0.5001e-4);
    near(&unpack(&rehearsal["t"], 1e-4), &frames.times, 0.5001e-4);
    // A value that is not a number becomes null, not zero.
    assert!(
        data["panels"][1]["lines"][1]["v"]
            .as_array()
            .unwrap()
            .iter()
            .all(Value::is_null)
    );
    let unit = data["panels"][1]["unit"].as_f64().unwrap();
    // Lengths are shown in the unit that suits them.
    assert_eq!(data["panels"][1]["measure"], "mm");
    assert!((data["panels"][1]["lines"][0]["v"][3].as_f64().unwrap() * unit - 30.0).abs() < 1e-9);
}

#[test]
fn a_long_plan_with_its_rehearsal_makes_a_small_page() {
    let page = report_html(&sample::with_motion(sample::summary(1000), 1200, 24));
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
}

#[test]
fn an_empty_plan_makes_a_page_and_a_picture() {
    let mut summary = sample::summary(1);
    summary.trajectory = Default::default();
    summary.baseline = Default::default();
    summary.centerline.clear();
    summary.panels.clear();
    summary.claims.clear();
    summary.outline.objects.clear();
    summary.swept_at.clear();
    summary.duration = f64::NAN;
    let document = parse(&report_html(&summary));
    assert_eq!(count(&document, "#layer-paths"), 0);
    roxmltree::Document::parse(&pairtrawl_report::plan_svg(&summary)).unwrap();
}
