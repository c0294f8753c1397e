//! How long should the net be? The cost of the best plan over the length of the net.
//!
//! `cargo run --example net_length -- [SCENE]`

use pairtrawl::model::numbers;
use pairtrawl::{LengthRange, PlanOptions, files, length_curve};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1);
    let path = path.unwrap_or_else(|| "scenes/witness-9/scene.toml".to_owned());
    let loaded = files::read_scene(Path::new(&path))?;
    let range = LengthRange {
        points: 7,
        ..LengthRange::default_for(&loaded.scene)
    };
    let curve = length_curve(&loaded.scene, &PlanOptions::default(), &range, &mut ())?;
    for point in &curve.points {
        let net = numbers::length(point.net_length);
        match &point.outcome {
            Ok(cost) => println!("{net:>8}  J {}", numbers::cost(cost.total())),
            Err(refusal) => println!("{net:>8}  {refusal}"),
        }
    }
    if let (Some((best, cost)), Some((from, to))) = (curve.minimum, curve.flat_range(0.01)) {
        println!(
            "best with {}: J {}; at most 1 % more from {} to {}",
            numbers::length(best),
            numbers::cost(cost.total()),
            numbers::length(from),
            numbers::length(to),
        );
    }
    Ok(())
}
