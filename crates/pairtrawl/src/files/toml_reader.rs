//! A strict reader for TOML: each value knows its full name and its place in the file.

use super::{FileError, Problem};
use pairtrawl_geometry::Point;
use std::f64::consts::TAU;
use std::path::Path;
use toml::de::{DeTable, DeValue};

/// Greatest absolute value of a coordinate, m: beyond it millimeters drown in rounding.
pub(super) const FARTHEST: f64 = 1e6;
/// Greatest value of a number without another bound.
const LARGEST: f64 = 1e15;

/// The file that a value comes from.
#[derive(Clone, Copy)]
pub(super) struct Document<'a> {
    pub path: &'a Path,
    pub text: &'a str,
}

impl Document<'_> {
    pub(super) fn error(&self, offset: usize, problem: impl Into<Problem>) -> FileError {
        let before = self.text.as_bytes().get(..offset).unwrap_or_default();
        let line = 1 + before.iter().filter(|&&b| b == b'\n').count();
        FileError {
            path: self.path.to_owned(),
            line: Some(line),
            problem: problem.into(),
        }
    }
}

/// What a number may be.
#[derive(Clone, Copy)]
pub(super) enum Range {
    /// Finite and above zero.
    Positive,
    /// Finite and zero or above.
    NotNegative,
    /// Above zero and at most this.
    UpTo(f64),
    /// A coordinate: within a thousand kilometers.
    Coordinate,
    /// A length or a speed: above zero and at most as large as a coordinate may be.
    Length,
    /// A heading: within a turn to either side, in rad. Ninety is a number of degrees.
    Heading,
}

impl Range {
    fn contains(self, x: f64) -> bool {
        match self {
            // Beyond this products of parameters drown in rounding.
            Range::Positive => x > 0.0 && x <= LARGEST,
            Range::NotNegative => (0.0..=LARGEST).contains(&x),
            Range::UpTo(most) => x > 0.0 && x <= most,
            Range::Coordinate => x.abs() <= FARTHEST,
            Range::Length => x > 0.0 && x <= FARTHEST,
            Range::Heading => x.abs() <= TAU,
        }
    }

    fn text(self) -> String {
        match self {
            Range::Positive => format!("above zero and at most {LARGEST:e}"),
            Range::NotNegative => format!("at least zero and at most {LARGEST:e}"),
            Range::UpTo(most) => format!("above zero and at most {most}"),
            Range::Coordinate => "a finite coordinate between -1e6 and 1e6 (m)".to_owned(),
            Range::Length => format!("above zero and at most {FARTHEST:e}"),
            Range::Heading => {
                "an angle between -2 pi and 2 pi (rad): degrees? Multiply by pi / 180".to_owned()
            }
        }
    }
}

/// A table of the file.
pub(super) struct Table<'a> {
    document: Document<'a>,
    name: String,
    entries: &'a DeTable<'a>,
    offset: usize,
}

/// A value of the file.
pub(super) struct Value<'a> {
    document: Document<'a>,
    name: String,
    value: &'a DeValue<'a>,
    offset: usize,
}

impl<'a> Table<'a> {
    /// The whole file.
    pub(super) fn root(document: Document<'a>, entries: &'a DeTable<'a>) -> Self {
        Self {
            document,
            name: String::new(),
            entries,
            offset: 0,
        }
    }

    /// Refuses the first key of the file that is not among `known`.
    pub(super) fn expect_keys(&self, known: &[&str]) -> Result<(), FileError> {
        let unknown = self
            .entries
            .keys()
            .filter(|k| !known.contains(&k.get_ref().as_ref()))
            .min_by_key(|k| k.span().start);
        let Some(key) = unknown else { return Ok(()) };
        let remedy = match closest(key.get_ref(), known) {
            Some(meant) => format!("did you mean {}?", self.field(meant)),
            None => format!("known here are {}", known.join(", ")),
        };
        Err(self.document.error(
            key.span().start,
            Problem::UnknownKey {
                key: self.field(key.get_ref()),
                remedy,
            },
        ))
    }

    pub(super) fn get(&self, key: &str) -> Option<Value<'a>> {
        let (_, value) = self.entries.iter().find(|(k, _)| k.get_ref() == key)?;
        Some(Value {
            document: self.document,
            name: self.field(key),
            value: value.get_ref(),
            offset: value.span().start,
        })
    }

    pub(super) fn require(&self, key: &str, remedy: &str) -> Result<Value<'a>, FileError> {
        self.get(key).ok_or_else(|| {
            self.error(Problem::MissingKey {
                field: self.field(key),
                remedy: remedy.to_owned(),
            })
        })
    }

    /// Sets `target` when the key is there.
    pub(super) fn update(
        &self,
        key: &str,
        range: Range,
        target: &mut f64,
    ) -> Result<(), FileError> {
        if let Some(value) = self.get(key) {
            *target = value.number(range)?;
        }
        Ok(())
    }

    /// An optional table; an empty one when it is left out.
    pub(super) fn table(&self, key: &str) -> Result<Option<Table<'a>>, FileError> {
        self.get(key).map(|v| v.table()).transpose()
    }

    /// The elements of an optional array.
    pub(super) fn array(&self, key: &str, most: usize) -> Result<Vec<Value<'a>>, FileError> {
        self.get(key)
            .map_or(Ok(Vec::new()), |v| v.elements(0, most))
    }

    pub(super) fn field(&self, key: &str) -> String {
        if self.name.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.name)
        }
    }

    pub(super) fn error(&self, problem: impl Into<Problem>) -> FileError {
        self.document.error(self.offset, problem)
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }
}

impl<'a> Value<'a> {
    /// The value with its table's name before it.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn error(&self, problem: impl Into<Problem>) -> FileError {
        self.document.error(self.offset, problem)
    }

    /// The value is not what it must be.
    pub(super) fn refuse(&self, bound: impl Into<String>) -> FileError {
        self.error(Problem::Value {
            field: self.name.clone(),
            value: shown(self.value),
            bound: bound.into(),
        })
    }

    pub(super) fn number(&self, range: Range) -> Result<f64, FileError> {
        let number = match self.value {
            DeValue::Float(f) => f.as_str().parse::<f64>().ok(),
            DeValue::Integer(i) => i64::from_str_radix(i.as_str(), i.radix())
                .ok()
                .map(|i| i as f64),
            _ => None,
        };
        number
            .filter(|&x| range.contains(x))
            .ok_or_else(|| self.refuse(format!("a number, {}", range.text())))
    }

    pub(super) fn count(&self, least: usize, most: usize) -> Result<usize, FileError> {
        let number = match self.value {
            DeValue::Integer(i) => usize::from_str_radix(i.as_str(), i.radix()).ok(),
            _ => None,
        };
        number
            .filter(|n| (least..=most).contains(n))
            .ok_or_else(|| self.refuse(format!("a whole number from {least} to {most}")))
    }

    pub(super) fn text(&self) -> Result<&'a str, FileError> {
        match self.value {
            DeValue::String(s) => Ok(s),
            _ => Err(self.refuse("a string")),
        }
    }

    pub(super) fn numbers<const N: usize>(&self, range: Range) -> Result<[f64; N], FileError> {
        let elements = match self.value {
            DeValue::Array(a) if a.len() == N => self.elements(N, N)?,
            _ => return Err(self.refuse(format!("an array of {N} numbers"))),
        };
        let mut numbers = [0.0; N];
        for (number, element) in numbers.iter_mut().zip(&elements) {
            *number = element.number(range)?;
        }
        Ok(numbers)
    }

    pub(super) fn point(&self) -> Result<Point, FileError> {
        self.numbers(Range::Coordinate)
            .map(|[x, y]| Point::new(x, y))
    }

    pub(super) fn elements(&self, least: usize, most: usize) -> Result<Vec<Value<'a>>, FileError> {
        let DeValue::Array(array) = self.value else {
            return Err(self.refuse("an array"));
        };
        if !(least..=most).contains(&array.len()) {
            let value = format!("an array of {}", array.len());
            let bound = format!("an array of {least} to {most}");
            return Err(self.error(Problem::Value {
                field: self.name.clone(),
                value,
                bound,
            }));
        }
        let element = |(i, v): (usize, &'a toml::Spanned<DeValue<'a>>)| Value {
            document: self.document,
            name: format!("{}[{i}]", self.name),
            value: v.get_ref(),
            offset: v.span().start,
        };
        Ok(array.iter().enumerate().map(element).collect())
    }

    pub(super) fn table(&self) -> Result<Table<'a>, FileError> {
        match self.value {
            DeValue::Table(entries) => Ok(Table {
                document: self.document,
                name: self.name.clone(),
                entries,
                offset: self.offset,
            }),
            _ => Err(self.refuse("a table")),
        }
    }
}

/// The known key that was probably meant: the one most similar to this one, if any is similar.
fn closest<'k>(key: &str, known: &[&'k str]) -> Option<&'k str> {
    let key = key.to_lowercase();
    let similarity = |k: &str| strsim::jaro_winkler(&key, k);
    let best = known
        .iter()
        .copied()
        .max_by(|a, b| similarity(a).total_cmp(&similarity(b)))?;
    (similarity(best) > 0.8).then_some(best)
}

/// A value as a short text for messages.
fn shown(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(s) => format!("{:?}", s.chars().take(60).collect::<String>()),
        DeValue::Integer(i) => i.to_string(),
        DeValue::Float(f) => f.as_str().to_owned(),
        DeValue::Boolean(b) => b.to_string(),
        DeValue::Datetime(d) => d.to_string(),
        DeValue::Array(a) => format!("an array of {}", a.len()),
        DeValue::Table(_) => "a table".to_owned(),
    }
}
