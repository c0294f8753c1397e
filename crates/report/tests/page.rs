//! The page as an independent HTML parser sees it.

mod sample;

use pairtrawl_model::{Summary, Warning};
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
    // A value that is none is null, not zero.
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
