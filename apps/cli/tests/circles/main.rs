//! No crate of the workspace has modules that need each other in a circle.
//!
//! A module needs another where it imports from it or names a path into it. What a module passes on with `use` counts for the
//! module that defines it. Each path is looked at where both ends part: there it joins two siblings, or a child and its parent.
//! Declaring or re-exporting a child is no need of it. Code under `#[cfg(test)]` is left out.

mod source;

use source::{Module, ModulePath, child, collect, module};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

struct Crate(BTreeMap<ModulePath, Module>);

impl Crate {
    fn read(sources: &Path) -> Self {
        let mut files = Vec::new();
        collect(sources, &mut Vec::new(), &mut files);
        Self::of(files)
    }

    fn of(files: Vec<(ModulePath, String)>) -> Self {
        Self(
            files
                .iter()
                .map(|(path, text)| (path.clone(), module(text)))
                .collect(),
        )
    }

    /// The module that defines what `path` means in the module `at`; none when it lies outside of the crate.
    fn target(&self, at: &[String], path: &[String], depth: usize) -> Option<ModulePath> {
        let (first, rest) = path.split_first()?;
        assert!(depth < 20, "the imports of {at:?} do not end: {path:?}");
        match first.as_str() {
            "crate" => return self.inside(&[], rest, depth),
            "self" => return self.inside(at, rest, depth),
            "super" => return self.inside(&at[..at.len().checked_sub(1)?], rest, depth),
            _ => {}
        }
        let known =
            self.0.contains_key(&child(at, first)) || self.0[at].imports.contains_key(first);
        known.then(|| self.inside(at, path, depth))?
    }

    /// The module that defines `path`, which begins in the module `at`.
    fn inside(&self, at: &[String], path: &[String], depth: usize) -> Option<ModulePath> {
        let Some((first, rest)) = path.split_first() else {
            return Some(at.to_vec());
        };
        if first == "super" {
            return self.inside(&at[..at.len().checked_sub(1)?], rest, depth);
        }
        if self.0.contains_key(&child(at, first)) {
            return self.inside(&child(at, first), rest, depth);
        }
        match self.0[at].imports.get(first) {
            // An import of its own name from outside, `use libm; libm::sin`.
            Some(import) if import[..] == path[..1] => None,
            Some(import) => self.target(at, &[import, rest].concat(), depth + 1),
            None => Some(at.to_vec()),
        }
    }

    /// One line for each group of modules below one parent that all need each other.
    fn circles(&self) -> Vec<String> {
        // Parent -> pairs of nodes, each with a path that joins them; a node is a child with all below it, or "self", the
        // parent's own file.
        let mut needs: BTreeMap<ModulePath, BTreeMap<(String, String), String>> = BTreeMap::new();
        for (at, module) in &self.0 {
            for path in &module.paths {
                let Some(to) = self.target(at, path, 0).filter(|to| to != at) else {
                    continue;
                };
                let common = at.iter().zip(&to).take_while(|(a, b)| a == b).count();
                let node = |path: &[String]| path.get(common).map_or("self".into(), String::clone);
                let pairs = needs.entry(at[..common].to_vec()).or_default();
                let example = format!(
                    "{} has {}",
                    child(&["crate".into()], &at.join("::")).join("::"),
                    path.join("::")
                );
                pairs.entry((node(at), node(&to))).or_insert(example);
            }
        }
        needs
            .iter()
            .flat_map(|(parent, pairs)| groups(parent, pairs))
            .collect()
    }
}

fn groups(parent: &[String], pairs: &BTreeMap<(String, String), String>) -> BTreeSet<String> {
    let mut reach: BTreeSet<_> = pairs.keys().cloned().collect();
    loop {
        let longer = reach.iter().flat_map(|(a, b)| {
            let onward = pairs.keys().filter(move |(from, _)| from == b);
            onward.map(move |(_, to)| (a.clone(), to.clone()))
        });
        let next: BTreeSet<_> = reach.iter().cloned().chain(longer).collect();
        if next.len() == reach.len() {
            break;
        }
        reach = next;
    }
    let mutual = |a: &String, b: &String| {
        [(a, b), (b, a)]
            .iter()
            .all(|(a, b)| reach.contains(&((*a).clone(), (*b).clone())))
    };
    let group = |node: &String| {
        let inside = pairs
            .iter()
            .filter(|((a, b), _)| mutual(node, a) && mutual(node, b));
        let needs: Vec<_> = inside
            .map(|((a, b), example)| format!("{a} -> {b} ({example})"))
            .collect();
        format!("{}: {}", child(parent, "*").join("::"), needs.join(", "))
    };
    let circling = pairs.keys().filter(|(a, b)| mutual(a, b));
    circling.map(|(a, _)| group(a)).collect()
}

#[test]
fn no_modules_need_each_other_in_a_circle() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut crates = 0;
    let mut found = Vec::new();
    for folder in ["crates", "apps"] {
        for entry in std::fs::read_dir(root.join(folder)).unwrap() {
            let sources = entry.unwrap().path().join("src");
            let krate = Crate::read(&sources);
            crates += 1;
            found.extend(
                krate
                    .circles()
                    .iter()
                    .map(|c| format!("{} {c}", sources.display())),
            );
        }
    }
    assert!(crates >= 15, "only {crates} crates found");
    assert!(
        found.is_empty(),
        "modules need each other in a circle:\n{}",
        found.join("\n")
    );
}

fn circles_of(files: &[(&str, &str)]) -> Vec<String> {
    let path = |name: &str| {
        name.split("::")
            .filter(|part| !part.is_empty())
            .map(str::to_owned)
            .collect()
    };
    Crate::of(
        files
            .iter()
            .map(|(name, text)| (path(name), (*text).to_owned()))
            .collect(),
    )
    .circles()
}

#[test]
fn a_circle_through_a_re_export_is_found() {
    let files = [
        (
            "",
            "mod a; mod b; pub use a::{self as first, Left as Renamed}; pub use b::Right;",
        ),
        ("a", "use crate::Right; pub struct Left;"),
        ("b", "fn f(left: crate::first::Left) {} pub struct Right;"),
    ];
    let found = circles_of(&files);
    assert_eq!(
        found,
        ["*: a -> b (crate::a has crate::Right), b -> a (crate::b has crate::first::Left)"]
    );
}

#[test]
fn a_child_that_imports_from_a_parent_that_uses_it_is_found() {
    let parent = "mod c; pub const LIMIT: f64 = 1.0; fn f() { c::g() }";
    let files = [
        ("", "mod p;"),
        ("p", parent),
        ("p::c", "use super::LIMIT;"),
        ("q", "use crate::p::LIMIT;"),
    ];
    let found = circles_of(&files);
    assert_eq!(
        found,
        ["p::*: c -> self (crate::p::c has super::LIMIT), self -> c (crate::p has c::g)"]
    );
}

#[test]
fn tests_comments_strings_and_other_crates_make_no_circle() {
    let a = r##"
        // use crate::b::X;
        const A: &str = "crate::b::X"; const B: &str = r#"" crate::b::X"#; const C: char = '"'; /* crate::b::X */
        use libm;
        fn f<'a>() { libm::sin(1.0); b::other() }
        #[cfg(test)]
        mod tests { use crate::b::X; fn g() { if true { crate::b::h() } } }
        #[cfg(test)] use crate::b::Y;
    "##;
    assert!(circles_of(&[("", "mod a; mod b;"), ("a", a), ("b", "use crate::a::A;")]).is_empty());
}
