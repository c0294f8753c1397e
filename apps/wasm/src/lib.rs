//! The planner as a WebAssembly module that imports nothing: no files, no clock, no threads, no random numbers.
//!
//! Bytes go in and out one by one, so that neither side shares memory with the other. Push the name of a file and call
//! [`end_name`], push its content and call [`end_file`]; the first file is the scene, the others are those that its map
//! names. [`plan`] plans; [`length`] and [`byte`] then give the plan as in `plan.json`, or what went wrong.
#![allow(
    unsafe_code,
    reason = "an attribute that names an export counts as unsafe; there is no unsafe code here"
)]

use pairtrawl::{PlanOptions, files};
use std::cell::RefCell;
use std::path::Path;

#[derive(Default)]
struct State {
    buffer: Vec<u8>,
    name: String,
    files: Vec<(String, Vec<u8>)>,
    result: Vec<u8>,
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

/// Appends a byte (0 to 255) to what is being handed over.
#[unsafe(no_mangle)]
pub extern "C" fn push(byte: u8) {
    STATE.with_borrow_mut(|state| state.buffer.push(byte));
}

/// What was pushed is the name of the next file, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn end_name() {
    STATE.with_borrow_mut(|state| {
        state.name = String::from_utf8_lossy(&std::mem::take(&mut state.buffer)).into_owned();
    });
}

/// What was pushed is the content of the file.
#[unsafe(no_mangle)]
pub extern "C" fn end_file() {
    STATE.with_borrow_mut(|state| {
        let file = (
            std::mem::take(&mut state.name),
            std::mem::take(&mut state.buffer),
        );
        state.files.push(file);
    });
}

/// Plans with the default options and forgets the files. 1 when there is a plan, 0 when there is a message.
#[unsafe(no_mangle)]
pub extern "C" fn plan() -> u32 {
    STATE.with_borrow_mut(|state| {
        let result = planned(&std::mem::take(&mut state.files));
        let has_plan = result.is_ok();
        state.result = result.unwrap_or_else(|message| message).into_bytes();
        u32::from(has_plan)
    })
}

/// Bytes of the result.
#[unsafe(no_mangle)]
pub extern "C" fn length() -> usize {
    STATE.with_borrow(|state| state.result.len())
}

/// A byte of the result; 0 beyond its end.
#[unsafe(no_mangle)]
pub extern "C" fn byte(index: usize) -> u8 {
    STATE.with_borrow(|state| state.result.get(index).copied().unwrap_or(0))
}

fn planned(given: &[(String, Vec<u8>)]) -> Result<String, String> {
    let Some(((name, scene), others)) = given.split_first() else {
        return Err("no scene was pushed".to_owned());
    };
    let text = std::str::from_utf8(scene).map_err(|e| format!("{name}: {e}"))?;
    let find = |path: &Path| {
        let file = others.iter().find(|(other, _)| Path::new(other) == path);
        file.map(|(_, content)| content.clone())
    };
    let loaded = files::parse_scene_with(text, name, &find).map_err(|e| e.to_string())?;
    let options = PlanOptions::default();
    let planned = pairtrawl::plan(&loaded.scene, &loaded.reference, &options, &mut ())
        .map_err(|e| e.to_string())?;
    files::plan_json(&planned.plan).map_err(|e| e.to_string())
}
