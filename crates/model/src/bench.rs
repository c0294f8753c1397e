/// A folder of scenes and how planning each of them ended.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Bench {
    /// The folder.
    pub folder: String,
    /// What `pairtrawl plan` was told beyond the scene.
    pub arguments: Vec<String>,
    /// Scenes that were planned at once, each by a process of its own.
    pub jobs: usize,
    /// Threads of each process.
    pub threads: usize,
    /// How many scenes the folder holds.
    pub wanted: usize,
    /// True when it was stopped before all scenes were planned.
    pub interrupted: bool,
    /// One for each kind of scene, in the order of their names.
    pub groups: Vec<BenchGroup>,
    /// All scenes together.
    pub total: BenchGroup,
    /// The scenes that were planned, in the order of their names.
    pub scenes: Vec<BenchScene>,
}

/// How planning one scene ended.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BenchScene {
    /// Where it lies in the folder.
    pub name: String,
    /// The scene's own name without the number at its end, which is a seed in generated scenes.
    pub group: String,
    /// Exit code of `pairtrawl plan`; none when the process was ended from outside.
    pub exit_code: Option<i32>,
    /// Why there is no plan.
    pub message: Option<String>,
    /// The claim that fails in the best attempt, where one does.
    pub claim: Option<String>,
    /// How many objects lie in it; none when the scene cannot be read.
    pub objects: Option<usize>,
    /// How many of them the plan gathers.
    pub gathered: usize,
    /// How many it leaves because a proof says that they cannot be gathered.
    pub left_proven: usize,
    /// How many it leaves because the search did not find how to gather them.
    pub left_not_found: usize,
    /// Whether the certificate, made again from the files alone, holds; none without a plan.
    pub valid: Option<bool>,
    /// Iterations of the last optimization.
    pub iterations: Option<usize>,
    /// The paper's J.
    pub cost: Option<f64>,
    /// What the simulated drive said.
    pub rehearsal: Option<String>,
    /// Wall time of the process, s.
    pub seconds: f64,
    /// The greatest resident memory that was seen, looked at a hundred times a second, bytes; none where the system does
    /// not tell.
    pub memory: Option<u64>,
    /// Its page, relative to the results.
    pub page: Option<String>,
    /// A picture, relative to the results.
    pub picture: Option<String>,
}

impl BenchScene {
    /// True when a plan was found.
    pub fn is_planned(&self) -> bool {
        self.exit_code == Some(0)
    }
}

/// Figures of several scenes.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BenchGroup {
    /// What they are.
    pub name: String,
    /// How many they are.
    pub scenes: usize,
    /// Of these, how many have a plan.
    pub planned: usize,
    /// Of these plans, how many have a certificate that does not hold when it is made again.
    pub invalid: usize,
    /// Objects of all scenes that could be read.
    pub objects: usize,
    /// Objects that the plans gather.
    pub gathered: usize,
    /// Objects that the plans leave with a proof.
    pub left_proven: usize,
    /// Objects that the plans leave without one.
    pub left_not_found: usize,
    /// Plans that were rehearsed.
    pub rehearsed: usize,
    /// Of these, how many passed.
    pub passed: usize,
    /// Iterations of the last optimization over the plans: half have no more, nine of ten, all.
    pub iterations: Option<[usize; 3]>,
    /// Wall time over all scenes: half take no longer, nine of ten, all, s.
    pub seconds: Option<[f64; 3]>,
    /// The greatest memory of a scene, bytes.
    pub memory: Option<u64>,
    /// How the scenes without a plan ended, ascending by exit code; none stands for a process that was ended.
    pub failures: Vec<BenchFailures>,
}

/// Scenes without a plan that ended alike.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BenchFailures {
    /// The exit code.
    pub exit_code: Option<i32>,
    /// How many.
    pub scenes: usize,
}

impl BenchGroup {
    /// The figures of some scenes.
    pub fn of(name: &str, scenes: &[&BenchScene]) -> Self {
        let planned: Vec<&BenchScene> = (scenes.iter().copied())
            .filter(|s| s.is_planned())
            .collect();
        let sum = |count: fn(&BenchScene) -> usize| scenes.iter().map(|s| count(s)).sum();
        let rehearsal = |status: fn(&str) -> bool| {
            let verdicts = planned.iter().filter_map(|s| s.rehearsal.as_deref());
            verdicts.filter(|verdict| status(verdict)).count()
        };
        let mut codes: Vec<Option<i32>> = (scenes.iter())
            .filter(|s| !s.is_planned())
            .map(|s| s.exit_code)
            .collect();
        codes.sort_unstable();
        Self {
            name: name.to_owned(),
            scenes: scenes.len(),
            planned: planned.len(),
            invalid: planned.iter().filter(|s| s.valid == Some(false)).count(),
            objects: sum(|s| s.objects.unwrap_or(0)),
            gathered: sum(|s| s.gathered),
            left_proven: sum(|s| s.left_proven),
            left_not_found: sum(|s| s.left_not_found),
            rehearsed: rehearsal(|verdict| verdict != "skipped"),
            passed: rehearsal(|verdict| verdict == "passed"),
            iterations: quantiles(planned.iter().filter_map(|s| s.iterations), usize::cmp),
            seconds: quantiles(scenes.iter().map(|s| s.seconds), f64::total_cmp),
            memory: scenes.iter().filter_map(|s| s.memory).max(),
            failures: (codes.chunk_by(|a, b| a == b))
                .map(|alike| BenchFailures {
                    exit_code: alike[0],
                    scenes: alike.len(),
                })
                .collect(),
        }
    }
}

/// The least values that half, nine of ten and all values do not exceed; none of nothing.
fn quantiles<T: Copy>(
    values: impl Iterator<Item = T>,
    order: fn(&T, &T) -> std::cmp::Ordering,
) -> Option<[T; 3]> {
    let mut values: Vec<T> = values.collect();
    values.sort_by(order);
    let at = |tenths: usize| values.get((values.len() * tenths).div_ceil(10).saturating_sub(1));
    Some([*at(5)?, *at(9)?, *values.last()?])
}

#[cfg(test)]
mod tests {
    use super::quantiles;

    #[test]
    fn quantiles_are_values_that_occur() {
        let of = |values: &[usize]| quantiles(values.iter().copied(), usize::cmp);
        assert_eq!(of(&[]), None);
        assert_eq!(of(&[7]), Some([7, 7, 7]));
        assert_eq!(of(&[4, 1]), Some([1, 4, 4]));
        assert_eq!(of(&[10, 9, 8, 7, 6, 5, 4, 3, 2, 1]), Some([5, 9, 10]));
    }
}
