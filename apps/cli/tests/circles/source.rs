//! Reads the modules of a crate from its source files, as far as their imports and paths go.

use std::collections::BTreeMap;
use std::path::Path;

/// Names from the crate's root; the root's own path is empty.
pub type ModulePath = Vec<String>;

/// What one source file says about its surroundings.
#[derive(Default)]
pub struct Module {
    /// Name in this module -> path as it is written, for everything that `use` brings in.
    pub imports: BTreeMap<String, Vec<String>>,
    /// Paths that this module needs.
    pub paths: Vec<Vec<String>>,
}

pub fn child(parent: &[String], name: &str) -> ModulePath {
    [parent, &[name.to_owned()]].concat()
}

/// All source files below `folder` with the modules that they are; tests left out.
pub fn collect(folder: &Path, at: &mut ModulePath, files: &mut Vec<(ModulePath, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        if name == "tests" || name.ends_with("_tests") {
            continue;
        }
        if path.is_dir() {
            at.push(name);
            collect(&path, at, files);
            at.pop();
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let module = if ["lib", "main", "mod"].contains(&name.as_str()) {
                at.clone()
            } else {
                child(at, &name)
            };
            files.push((module, std::fs::read_to_string(&path).unwrap()));
        }
    }
}

/// Reads the imports and paths of one source file.
pub fn module(text: &str) -> Module {
    let words = words(text);
    let mut module = Module::default();
    let mut i = 0;
    while i < words.len() {
        if words[i..].starts_with(&TEST_ONLY.map(str::to_owned)) {
            i = end_of_item(&words, i + TEST_ONLY.len());
        } else if words[i] == "use" && words[i + 1] != "<" {
            let shared = i > 0 && ["pub", ")"].contains(&words[i - 1].as_str());
            let mut found = Vec::new();
            i += 1;
            import(&words, &mut i, Vec::new(), &mut found);
            for (name, path) in found {
                if !shared || ["crate", "super"].contains(&path[0].as_str()) {
                    module.paths.push(path.clone());
                }
                module.imports.insert(name, path);
            }
        } else {
            let mut path = vec![words[i].clone()];
            while words.get(i + 1).is_some_and(|w| w == "::")
                && words.get(i + 2).is_some_and(|w| is_name(w))
            {
                path.push(words[i + 2].clone());
                i += 2;
            }
            i += 1;
            if path.len() > 1 && is_name(&path[0]) {
                module.paths.push(path);
            }
        }
    }
    module
}

const TEST_ONLY: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];

/// Where the item that begins at `i` ends: behind its first `;` or block outside of brackets.
fn end_of_item(words: &[String], mut i: usize) -> usize {
    let mut depth = 0;
    loop {
        match words[i].as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            _ => {}
        }
        i += 1;
        if depth == 0 && ["}", ";"].contains(&words[i - 1].as_str()) {
            return i;
        }
    }
}

/// Reads one tree of `use` behind `before`; `*` imports under the name `*`.
fn import(
    words: &[String],
    i: &mut usize,
    mut before: Vec<String>,
    found: &mut Vec<(String, Vec<String>)>,
) {
    loop {
        match words[*i].as_str() {
            "{" => {
                *i += 1;
                while words[*i] != "}" {
                    import(words, i, before.clone(), found);
                    *i += usize::from(words[*i] == ",");
                }
                *i += 1;
                return;
            }
            "::" => *i += 1,
            "as" => {
                found.push((words[*i + 1].clone(), before));
                *i += 2;
                return;
            }
            "," | ";" | "}" => {
                let last = before.last().unwrap().clone();
                if last == "self" && before.len() > 1 {
                    before.pop();
                }
                found.push((before.last().unwrap().clone(), before));
                return;
            }
            word => {
                if word != "*" {
                    before.push(word.to_owned());
                }
                *i += 1;
            }
        }
    }
}

fn is_name(word: &str) -> bool {
    word.starts_with(|c: char| c.is_alphabetic() || c == '_')
}

/// Names, `::` and single signs of a source text; comments, strings and characters left out.
fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").unwrap() + 2
        } else if rest.starts_with("r\"") || rest.starts_with("r#") {
            let hashes = rest[1..].chars().take_while(|c| *c == '#').count();
            let end = format!("\"{}", "#".repeat(hashes));
            let start = hashes + 2;
            start + rest[start..].find(&end).unwrap() + end.len()
        } else if c == '"' {
            quoted(rest, '"')
        } else if c == '\''
            && (rest[1..].starts_with('\\') || rest[1..].chars().nth(1) == Some('\''))
        {
            quoted(rest, '\'')
        } else {
            let name = rest
                .find(|c: char| !(c.is_alphanumeric() || c == '_'))
                .unwrap_or(rest.len());
            let length = if rest.starts_with("::") {
                2
            } else {
                name.max(c.len_utf8())
            };
            if !c.is_whitespace() {
                words.push(rest[..length].to_owned());
            }
            length
        };
        rest = &rest[length..];
    }
    words
}

fn quoted(text: &str, mark: char) -> usize {
    let mut escaped = false;
    for (i, c) in text.char_indices().skip(1) {
        if c == mark && !escaped {
            return i + 1;
        }
        escaped = c == '\\' && !escaped;
    }
    text.len()
}
