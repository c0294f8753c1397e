//! Drives plans in both engines, this project's and rapier, and prints what each says.
//!
//! `cargo run --release -p pairtrawl --features rapier --example two_engines -- SCENE.toml PLAN.json [SCENE.toml PLAN.json ...]`
//!
//! Per plan: verdict, objects gathered, greatest tension, mean drive force of both robots, how far the objects end from where rapier leaves
//! them (median and greatest), and simulated seconds a second.

use pairtrawl::files;
use pairtrawl::model::{Rehearsal, RehearsalRecord};
use pairtrawl::simulation::Options;
use std::error::Error;
use std::path::Path;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (mut agree, mut plans) = (0, 0);
    for pair in arguments.chunks_exact(2) {
        let loaded = files::read_scene(Path::new(&pair[0]))?;
        let file = files::read_plan(Path::new(&pair[1]))?;
        println!("{} ({})", loaded.scene.name, pair[1]);
        let mut records = Vec::new();
        for (name, options) in [
            ("implicit", Options::default()),
            ("quick", Options::quick()),
            ("rapier", Options::rapier()),
        ] {
            let started = Instant::now();
            let rehearsed = pairtrawl::rehearse(&loaded.scene, &loaded.reference, &file, &options)?;
            let seconds = started.elapsed().as_secs_f64();
            print_row(name, &rehearsed.record, seconds);
            records.push(rehearsed.record);
        }
        let off = distances(&records[0], &records[2]);
        if let (Some(median), Some(greatest)) = (off.get(off.len() / 2), off.last()) {
            println!(
                "  objects apart: median {:.1} mm, greatest {:.1} mm",
                1e3 * median,
                1e3 * greatest
            );
        }
        plans += 1;
        agree += usize::from(same(&records[0], &records[2]));
    }
    println!("{agree} of {plans} verdicts agree");
    Ok(())
}

fn same(a: &RehearsalRecord, b: &RehearsalRecord) -> bool {
    let passed = |r: &RehearsalRecord| r.verdict == Rehearsal::Passed;
    passed(a) == passed(b) && a.gathered == b.gathered
}

fn print_row(name: &str, record: &RehearsalRecord, seconds: f64) {
    let verdict = match &record.verdict {
        Rehearsal::Failed { event, time, .. } => format!("{event} at {time:.2} s"),
        other => format!("{other:?}"),
    };
    println!(
        "  {name:9} {:3} of {:3} gathered, tension {:.2} N, drive {:.4} N, off the path {:.1} mm, {:.1} s at {:.0} a second: {verdict}",
        record.gathered.iter().filter(|g| **g).count(),
        record.gathered.len(),
        record.max_tension[0].max(record.max_tension[1]),
        record.mean_drive_force.iter().sum::<f64>(),
        1e3 * record.max_deviation[0].max(record.max_deviation[1]),
        record.duration,
        record.duration / seconds,
    );
}

/// How far apart the objects of two records end, in ascending order, m.
fn distances(a: &RehearsalRecord, b: &RehearsalRecord) -> Vec<f64> {
    let ends = |r: &RehearsalRecord| {
        r.frames
            .last()
            .map(|f| f.objects.clone())
            .unwrap_or_default()
    };
    let mut off: Vec<f64> = (ends(a).iter().zip(ends(b)))
        .map(|(p, q)| p.position().distance(q.position()))
        .collect();
    off.sort_by(f64::total_cmp);
    off
}
