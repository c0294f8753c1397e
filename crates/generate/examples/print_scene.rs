//! Prints a generated scene, or its witness as a plan: `print_scene witness|serpentine DIFFICULTY SEED WAYPOINTS [--witness]`.

use pairtrawl_generate::{Kind, generate, scene_toml, witness_json};
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [kind, difficulty, seed, waypoints, rest @ ..] = arguments.as_slice() else {
        return Err(
            "usage: print_scene witness|serpentine DIFFICULTY SEED WAYPOINTS [--witness]".into(),
        );
    };
    let kind = match kind.as_str() {
        "witness" => Kind::Witness,
        "serpentine" => Kind::Serpentine,
        other => return Err(format!("kind is {other:?}, it must be witness or serpentine").into()),
    };
    let made = generate(kind, difficulty.parse()?, seed.parse()?, waypoints.parse()?)?;
    if rest.iter().any(|a| a == "--witness") {
        println!("{}", witness_json(&made));
    } else {
        print!("{}", scene_toml(&made.scene)?);
    }
    Ok(())
}
