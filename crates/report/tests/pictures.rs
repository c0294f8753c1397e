//! Pictures as an independent XML parser sees them, and tables.

mod sample;

use pairtrawl_geometry::Point;
use pairtrawl_model::{Cost, LengthCurve, LengthPoint, LengthRefusal};
use pairtrawl_report::{length_csv, length_svg, plan_svg, series_csv};
use roxmltree::{Document, Node};

fn of_class<'a>(document: &'a Document, class: &str) -> Vec<Node<'a, 'a>> {
    document
        .descendants()
        .filter(|n| n.attribute("class").is_some_and(|c| c == class))
        .collect()
}

/// Where a path begins and ends, in the picture's coordinates.
fn ends(path: &Node) -> (Point, Point) {
    let d = path.attribute("d").unwrap();
    let numbers: Vec<f64> = d
        .split(|c: char| c.is_ascii_alphabetic() || c == ' ')
        .filter(|t| !t.is_empty())
        .map(|t| t.parse().unwrap())
        .collect();
    let n = numbers.len();
    (
        Point::new(numbers[0], numbers[1]),
        Point::new(numbers[n - 2], numbers[n - 1]),
    )
}

/// Everything after the style sheet.
fn body(svg: &str) -> &str {
    svg.split_once("</style>\n").unwrap().1
}

#[test]
fn robots_and_obstacles_are_where_the_axes_say() {
    let summary = sample::summary(20);
    let svg = plan_svg(&summary);
    let document = Document::parse(&svg).unwrap();
    // Meters back from two tick labels of each axis.
    let ticks: Vec<(f64, f64, f64)> = document
        .descendants()
        .filter(|n| n.has_tag_name("text") && n.attribute("text-anchor").is_some())
        .filter_map(|n| {
            let at = |k| n.attribute(k).and_then(|v: &str| v.parse().ok());
            Some((n.text()?.parse().ok()?, at("x")?, at("y")?))
        })
        .collect();
    let lowest = ticks.iter().map(|t| t.2).fold(0.0, f64::max);
    type Tick = (f64, f64, f64);
    let (x_ticks, y_ticks): (Vec<Tick>, Vec<Tick>) = ticks.into_iter().partition(|t| t.2 == lowest);
    let linear = |a: (f64, f64), b: (f64, f64), v: f64| a.1 + (v - a.0) / (b.0 - a.0) * (b.1 - a.1);
    // Labels of the vertical axis stand 4 px below their tick.
    let place = |p: Point| {
        let (a, b) = (x_ticks[0], x_ticks[x_ticks.len() - 1]);
        let (c, d) = (y_ticks[0], y_ticks[y_ticks.len() - 1]);
        Point::new(
            linear((a.0, a.1), (b.0, b.1), p.x),
            linear((c.0, c.2 - 4.0), (d.0, d.2 - 4.0), p.y),
        )
    };
    let t = &summary.trajectory;
    for (class, poses) in [("left path", &t.left), ("right path", &t.right)] {
        let (start, end) = ends(&of_class(&document, class)[0]);
        assert!(
            start.distance(place(poses[0].position())) < 0.3,
            "{class} {start:?}"
        );
        assert!(
            end.distance(place(poses[t.len() - 1].position())) < 0.3,
            "{class} {end:?}"
        );
    }
    let corner = ends(&of_class(&document, "obstacle")[0]).0;
    assert!(corner.distance(place(Point::new(0.0, 2.6))) < 0.3);
    let left_start = of_class(&document, "robot left start")[0];
    let body = left_start
        .children()
        .find(|n| n.attribute("class") == Some("body"))
        .unwrap();
    let cy: f64 = body.attribute("cy").unwrap().parse().unwrap();
    assert!((cy - place(t.left[0].position()).y).abs() < 0.3);
}

#[test]
fn the_picture_of_a_small_plan() {
    let mut summary = sample::summary(2);
    summary.baseline = Default::default();
    summary.outline.obstacles.truncate(1);
    let svg = plan_svg(&summary);
    let start = svg.find("<g clip-path").unwrap();
    let end = svg.find("<path class=\"scale\"").unwrap();
    insta::assert_snapshot!(svg[start..end].trim(), @r##"
    <g clip-path="url(#map)"><g class="obstacles"><path class="obstacle" d="M127.65 211.47L232.43 211.47L232.43 127.65L127.65 127.65Z"/>
    <path class="border" d="M127.65 756.35L567.74 756.35L567.74 127.65L127.65 127.65Z"/>
    </g>
    <g class="sweep"><path class="sweep" d="M337.22 546.78L347.69 546.78L347.69 337.22L337.22 337.22ZM347.69 546.78L358.17 546.78L358.17 337.22L347.69 337.22Z"/>
    </g>
    <g class="circles"><circle class="circle" cx="400.09" cy="452.48" r="62.87"/>
    </g>
    <g class="centerline"><path class="centerline" d="M337.22 442L358.17 442"/>
    </g>
    <g class="paths"><path class="left path" d="M337.22 337.22L347.69 337.22L358.17 337.22"/>
    <path class="right path" d="M337.22 546.78L347.69 546.78L358.17 546.78"/>
    </g>
    <g class="ends"><g class="robot left start"><circle class="body" cx="337.22" cy="337.22" r="50.3"/>
    <path class="nose" d="M364.88 337.22L387.51 337.22"/>
    <circle class="hitch" cx="293.83" cy="337.22" r="6.04"/>
    </g>
    <g class="robot right start"><circle class="body" cx="337.22" cy="546.78" r="50.3"/>
    <path class="nose" d="M364.88 546.78L387.51 546.78"/>
    <circle class="hitch" cx="293.83" cy="546.78" r="6.04"/>
    </g>
    <g class="robot left end"><circle class="body" cx="358.17" cy="337.22" r="50.3"/>
    <path class="nose" d="M385.84 337.22L408.47 337.22"/>
    <circle class="hitch" cx="314.79" cy="337.22" r="6.04"/>
    </g>
    <g class="robot right end"><circle class="body" cx="358.17" cy="546.78" r="50.3"/>
    <path class="nose" d="M385.84 546.78L408.47 546.78"/>
    <circle class="hitch" cx="314.79" cy="546.78" r="6.04"/>
    </g>
    </g>
    <g class="objects"><circle class="object" cx="379.13" cy="442" r="8.38"/>
    <path class="object" d="M414.76 467.15L427.33 467.15L427.33 458.77L414.76 458.77Z"/>
    </g>
    <text class="letter" x="337.22" y="341.22">L</text>
    <text class="letter" x="337.22" y="550.78">R</text>
    <text class="letter" x="358.17" y="341.22">L</text>
    <text class="letter" x="358.17" y="550.78">R</text>
    <text class="visit" x="450.54" y="404.02">1</text>
    <text class="index" x="379.13" y="429.62">0</text>
    <text class="index" x="433.33" y="466.96">1</text>
    </g>
    "##);
}

#[test]
fn machines_of_any_size_have_the_same_picture_in_other_units() {
    let texts = |factor: f64| -> Vec<String> {
        let svg = plan_svg(&sample::scaled(sample::summary(20), factor));
        let document = Document::parse(&svg).unwrap();
        let texts = document.descendants().filter(|n| n.has_tag_name("text"));
        texts.filter_map(|n| n.text().map(str::to_owned)).collect()
    };
    for (factor, axis, bar, net) in [
        (0.02, "x (mm)", "10 mm", "net 30.0 mm"),
        (1.0, "x (m)", "500 mm", "net 1.500 m"),
        (1e3, "x (km)", "500 m", "net 1.500 km"),
        (1e4, "x (km)", "5 km", "net 15.000 km"),
    ] {
        let texts = texts(factor);
        assert!(texts.iter().any(|t| t == axis), "{factor}: {texts:?}");
        assert!(texts.iter().any(|t| t == bar), "{factor}: {texts:?}");
        assert!(
            texts.iter().any(|t| t.starts_with(net)),
            "{factor}: {texts:?}"
        );
    }
    // What is drawn where is the same to a tenth of a pixel.
    let path = |factor: f64| {
        let svg = plan_svg(&sample::scaled(sample::summary(20), factor));
        let document = Document::parse(&svg).unwrap();
        ends(&of_class(&document, "right path")[0])
    };
    let (start, end) = path(1.0);
    for factor in [0.02, 1e3, 1e4] {
        let (s, e) = path(factor);
        assert!(s.distance(start) < 0.1 && e.distance(end) < 0.1, "{factor}");
    }
}

#[test]
fn a_map_is_what_its_free_rings_leave() {
    let mut summary = sample::summary(2);
    summary.outline.obstacles.clear();
    summary.outline.free_rings = Some(vec![vec![
        Point::new(0.5, 0.5),
        Point::new(1.5, 0.5),
        Point::new(1.5, 2.5),
        Point::new(0.5, 2.5),
    ]]);
    let svg = plan_svg(&summary);
    let document = Document::parse(&svg).unwrap();
    let obstacle = of_class(&document, "obstacle")[0];
    assert_eq!(obstacle.attribute("fill-rule"), Some("evenodd"));
    // The area's border and one ring.
    assert_eq!(obstacle.attribute("d").unwrap().matches('Z').count(), 2);
}

#[test]
fn hostile_names_stay_text() {
    for name in [
        "</text><script>alert(1)</script>",
        "a \u{0}\u{8}\u{ffff} b",
        "]]>&amp;\"'",
    ] {
        let mut summary = sample::summary(2);
        summary.title = name.to_owned();
        let svg = plan_svg(&summary);
        let document = Document::parse(&svg).unwrap();
        assert!(!document.descendants().any(|n| n.has_tag_name("script")));
        let curve = LengthCurve {
            title: name.to_owned(),
            ..curve()
        };
        Document::parse(&length_svg(&curve)).unwrap();
    }
}

#[test]
fn long_names_and_long_halls_fit() {
    let mut summary = sample::summary(2);
    summary.title = "x".repeat(500);
    for size in [
        Point::new(200.0, 2.0),
        Point::new(2.0, 200.0),
        Point::new(0.3, 0.3),
    ] {
        summary.outline.area.max = size;
        let svg = plan_svg(&summary);
        let document = Document::parse(&svg).unwrap();
        let width: f64 = document
            .root_element()
            .attribute("width")
            .unwrap()
            .parse()
            .unwrap();
        let height: f64 = document
            .root_element()
            .attribute("height")
            .unwrap()
            .parse()
            .unwrap();
        assert!(width <= 1100.0 && height <= 1100.0, "{width} x {height}");
        let head = of_class(&document, "head")[0].text().unwrap();
        assert!(head.ends_with('\u{2026}') && (head.len() as f64) * 8.0 < width);
        for text in document.descendants().filter(|n| n.has_tag_name("text")) {
            if let Some(x) = text.attribute("x") {
                assert!((0.0..width).contains(&x.parse().unwrap()));
            }
        }
    }
}

#[test]
fn pictures_need_nothing_else() {
    for svg in [plan_svg(&sample::summary(3)), length_svg(&curve())] {
        let rest = svg.replace("http://www.w3.org/2000/svg", "");
        assert!(!rest.contains("http") && !rest.contains("href") && !rest.contains("@import"));
    }
}

#[test]
fn curves_as_a_table() {
    let mut panels = sample::summary(3).panels;
    // Another clock: a row of its own where the instants differ.
    let mut other = panels[0].clone();
    other.key = "tension".to_owned();
    other.unit = "N".to_owned();
    other.times = vec![0.0, 0.3];
    other.lines[0].label = "left, mean".to_owned();
    other.lines[0].values = vec![0.5, 0.123_456_789];
    panels.push(other);
    insta::assert_snapshot!(series_csv(&panels), @r##"
    t,separation_robots_m,step_length_left_m,step_length_right_m,tension_left__mean_N
    0,1,0,,0.5
    0.25,1,0.01,,
    0.3,,,,0.123456789
    0.5,1,0.02,,
    0.75,1,,,
    "##);
}

fn curve() -> LengthCurve {
    let cost = |expansion: f64| Cost {
        smoothness: 2.0,
        distance: 4000.0,
        obstacle: 0.0,
        expansion,
    };
    LengthCurve {
        title: "hall".to_owned(),
        points: vec![
            LengthPoint {
                net_length: 0.8,
                outcome: Err(LengthRefusal::NotFound(
                    "the net is shorter than \"the start\"".to_owned(),
                )),
            },
            LengthPoint {
                net_length: 1.0,
                outcome: Ok(cost(264.0)),
            },
            LengthPoint {
                net_length: 1.5,
                outcome: Ok(cost(330.0)),
            },
            LengthPoint {
                net_length: 2.0,
                outcome: Ok(cost(905.0)),
            },
        ],
        minimum: Some((1.18, cost(231.0))),
        interrupted: false,
    }
}

#[test]
fn net_lengths_as_a_table() {
    insta::assert_snapshot!(length_csv(&curve()), @r##"
    net_length,total,smoothness,distance,obstacle,expansion,reason
    0.8,,,,,,"the net is shorter than ""the start"""
    1,4266,2,4000,0,264,
    1.5,4332,2,4000,0,330,
    2,4907,2,4000,0,905,
    "##);
}

#[test]
fn the_curve_over_the_net_length_marks_its_minimum() {
    let svg = length_svg(&curve());
    let document = Document::parse(&svg).unwrap();
    assert_eq!(of_class(&document, "missing").len(), 2); // One in the plot, one in the legend.
    let points = of_class(&document, "point total");
    assert_eq!(points.len(), 3);
    let at = |n: &Node, k: &str| -> f64 { n.attribute(k).unwrap().parse().unwrap() };
    let minimum = document
        .descendants()
        .find(|n| n.has_tag_name("circle") && n.attribute("class") == Some("minimum"))
        .unwrap();
    // Between the first two lengths, below all points of the total.
    assert!(at(&points[0], "cx") < at(&minimum, "cx") && at(&minimum, "cx") < at(&points[1], "cx"));
    assert!(points.iter().all(|p| at(p, "cy") < at(&minimum, "cy")));
    assert!(body(&svg).contains("least J 4\u{202f}233.0 at 1.180 m"));
    // Nothing solved, nothing at all.
    for points in [Vec::new(), curve().points[..1].to_vec()] {
        let empty = LengthCurve {
            points,
            minimum: None,
            ..curve()
        };
        Document::parse(&length_svg(&empty)).unwrap();
    }
}
