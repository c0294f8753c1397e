//! The trajectories that the paper's authors published, read from their files.

use pairtrawl::geometry::Point;
use thiserror::Error;

/// The files, by the names that they have in the authors' repository's copy.
pub const FILES: [&str; 3] = [
    "experiment_traj.csv",
    "simulation_traj.csv",
    "experiment_tracked_right.csv",
];

/// What they published.
#[derive(Clone, Debug, PartialEq)]
pub struct Authors {
    /// Reference of the experiment, (left, right), 45 rows a second.
    pub experiment: [Vec<Point>; 2],
    /// Reference of the simulation, (left, right), 100 rows a second. It is their baseline, not an optimum.
    pub simulation: [Vec<Point>; 2],
    /// Where the right robot drove in the experiment.
    pub tracked_right: Vec<Point>,
}

/// A file that cannot be read as a trajectory.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{file}, line {line}: {why}")]
pub struct AuthorsError {
    /// Its name.
    pub file: &'static str,
    /// Counting from 1.
    pub line: usize,
    /// What is wrong.
    pub why: String,
}

impl Authors {
    /// From the contents of the three [`FILES`], in their order.
    ///
    /// # Errors
    /// Names the first line that does not hold as many finite numbers as it should.
    pub fn parse([experiment, simulation, tracked]: [&str; 3]) -> Result<Self, AuthorsError> {
        Ok(Self {
            experiment: pair(FILES[0], experiment)?,
            simulation: pair(FILES[1], simulation)?,
            tracked_right: rows(FILES[2], tracked, 2)?
                .into_iter()
                .map(|row| Point::new(row[0], row[1]))
                .collect(),
        })
    }
}

fn pair(file: &'static str, text: &str) -> Result<[Vec<Point>; 2], AuthorsError> {
    let rows = rows(file, text, 4)?;
    let column = |k: usize| {
        let points = rows.iter().map(|row| Point::new(row[k], row[k + 1]));
        points.collect()
    };
    Ok([column(0), column(2)])
}

fn rows(file: &'static str, text: &str, wanted: usize) -> Result<Vec<Vec<f64>>, AuthorsError> {
    let mut rows = Vec::new();
    for (i, line) in text.lines().enumerate() {
        if line.trim().is_empty() {
            continue;
        }
        let wrong = |why: String| AuthorsError {
            file,
            line: i + 1,
            why,
        };
        let numbers = line.split(',').map(|cell| cell.trim().parse::<f64>());
        let row: Vec<f64> = numbers
            .collect::<Result<_, _>>()
            .map_err(|error| wrong(format!("{error}, in \"{line}\"")))?;
        if row.len() != wanted || row.iter().any(|value| !value.is_finite()) {
            return Err(wrong(format!(
                "{} numbers, but {wanted} finite ones are needed",
                row.len()
            )));
        }
        rows.push(row);
    }
    match rows.len() {
        0 | 1 => Err(AuthorsError {
            file,
            line: 1,
            why: "fewer than two rows".to_owned(),
        }),
        _ => Ok(rows),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_read_and_wrong_ones_named() {
        let pair = "0,0.5,1,0.5\n0.1,0.5,1.1,0.5\n";
        let authors = Authors::parse([pair, pair, "1,0.5\n1,0.6\n"]).expect("read");
        assert_eq!(authors.experiment[1][1], Point::new(1.1, 0.5));
        let error = Authors::parse([pair, "0,0,0,0\n1,2,3\n", ""]).expect_err("short row");
        assert_eq!((error.file, error.line), (FILES[1], 2));
    }
}
