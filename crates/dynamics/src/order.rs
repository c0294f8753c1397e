//! In which order the unknowns are eliminated: reverse Cuthill-McKee over what touches what, so that the envelope stays narrow.

/// The places of the unknowns of the parts (robots, hinges, objects) in the system of a step.
#[derive(Clone, Debug, Default)]
pub(crate) struct Order {
    neighbors: Vec<Vec<usize>>,
    sizes: Vec<usize>,
    /// First unknown of each part; `usize::MAX` where it takes no part.
    offsets: Vec<usize>,
    sequence: Vec<usize>,
    visited: Vec<bool>,
    first: Vec<usize>,
}

impl Order {
    /// For `sizes.len()` parts with so many unknowns each, none of them tied to another.
    pub(crate) fn begin(&mut self, sizes: impl Iterator<Item = usize>) {
        self.sizes.clear();
        self.sizes.extend(sizes);
        self.neighbors.resize_with(self.sizes.len(), Vec::new);
        self.neighbors.iter_mut().for_each(Vec::clear);
    }

    /// Two parts depend on each other.
    pub(crate) fn tie(&mut self, a: usize, b: usize) {
        if a != b && !self.neighbors[a].contains(&b) {
            self.neighbors[a].push(b);
            self.neighbors[b].push(a);
        }
    }

    /// Finds the order, beginning with the tree that hangs on part 0.
    pub(crate) fn finish(&mut self) {
        let count = self.sizes.len();
        self.visited.clear();
        self.visited.resize(count, false);
        self.sequence.clear();
        for seed in 0..count {
            if self.visited[seed] || self.sizes[seed] == 0 {
                continue;
            }
            self.visited[seed] = true;
            let mut next = self.sequence.len();
            self.sequence.push(seed);
            while next < self.sequence.len() {
                let part = self.sequence[next];
                next += 1;
                let begin = self.sequence.len();
                for &other in &self.neighbors[part] {
                    if !self.visited[other] {
                        self.visited[other] = true;
                        self.sequence.push(other);
                    }
                }
                let neighbors = &self.neighbors;
                self.sequence[begin..].sort_unstable_by_key(|&p| (neighbors[p].len(), p));
            }
        }
        self.sequence.reverse();
        self.offsets.clear();
        self.offsets.resize(count, usize::MAX);
        let mut total = 0;
        for &part in &self.sequence {
            self.offsets[part] = total;
            total += self.sizes[part];
        }
        self.first.clear();
        self.first.resize(total, 0);
        for &part in &self.sequence {
            let offset = self.offsets[part];
            let least = self.neighbors[part]
                .iter()
                .map(|&other| self.offsets[other])
                .fold(offset, usize::min);
            self.first[offset..offset + self.sizes[part]].fill(least);
        }
    }

    /// Where the unknowns of a part begin.
    pub(crate) fn offset(&self, part: usize) -> usize {
        self.offsets[part]
    }

    /// First column of every row of the system.
    pub(crate) fn first_columns(&self) -> &[usize] {
        &self.first
    }
}
