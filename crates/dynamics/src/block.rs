//! Blocks of three by three: what the three velocities of a part (two of a place, one of a turn) have to do with those of another.

/// Three velocities of a part: x, y and turning rate. A hinge has no third; its entries are 0, or 1 on the diagonal.
pub(crate) type Triple = [f64; 3];

/// A block by columns. The fourth entry of a column is not used: four fit the processor's vectors.
pub(crate) type Block = [[f64; 4]; 3];

/// A block of zeros.
pub(crate) const ZERO: Block = [[0.0; 4]; 3];

/// A pivot is not taken for smaller than this. All are positive but for rounding: every term adds a positive semidefinite part to a mass.
const LEAST_PIVOT: f64 = 1e-12;

/// `block += x y^T`.
#[inline]
pub(crate) fn add_product(block: &mut Block, x: &Triple, y: &Triple) {
    let x = [x[0], x[1], x[2], 0.0];
    for (column, factor) in block.iter_mut().zip(y) {
        for (entry, xi) in column.iter_mut().zip(&x) {
            *entry += xi * factor;
        }
    }
}

/// `block -= a b^T`.
#[inline]
pub(crate) fn subtract_product(block: &mut Block, a: &Block, b: &Block) {
    for (c, column) in block.iter_mut().enumerate() {
        for (from, factors) in a.iter().zip(b) {
            for (entry, value) in column.iter_mut().zip(from) {
                *entry -= value * factors[c];
            }
        }
    }
}

/// `out += block x`.
#[inline]
pub(crate) fn multiply_add(block: &Block, x: &Triple, out: &mut Triple) {
    for (column, value) in block.iter().zip(x) {
        for (o, entry) in out.iter_mut().zip(column) {
            *o += entry * value;
        }
    }
}

/// `out -= block x`.
#[inline]
pub(crate) fn multiply_subtract(block: &Block, x: &Triple, out: &mut Triple) {
    for (column, value) in block.iter().zip(x) {
        for (o, entry) in out.iter_mut().zip(column) {
            *o -= entry * value;
        }
    }
}

/// `block^T x`.
#[inline]
pub(crate) fn transposed_times(block: &Block, x: &Triple) -> Triple {
    block.map(|column| column[0] * x[0] + column[1] * x[1] + column[2] * x[2])
}

/// The lower Cholesky factor C of a symmetric positive definite block, with the inverses of its diagonal in their places.
pub(crate) fn cholesky(block: &mut Block) {
    for c in 0..3 {
        let inverse = 1.0 / block[c][c].max(LEAST_PIVOT).sqrt();
        for entry in &mut block[c] {
            *entry *= inverse;
        }
        block[c][c] = inverse;
        for next in c + 1..3 {
            let from = block[c];
            let factor = from[next];
            for (entry, value) in block[next].iter_mut().zip(from).skip(next) {
                *entry -= value * factor;
            }
        }
    }
}

/// `block C^-T` for a factor of [`cholesky`].
#[inline]
pub(crate) fn divide(block: &mut Block, factor: &Block) {
    for c in 0..3 {
        for before in 0..c {
            let (value, from) = (factor[before][c], block[before]);
            for (entry, f) in block[c].iter_mut().zip(&from) {
                *entry -= f * value;
            }
        }
        for entry in &mut block[c] {
            *entry *= factor[c][c];
        }
    }
}

/// `C^-1 x`.
#[inline]
pub(crate) fn solve_lower(factor: &Block, x: &mut Triple) {
    x[0] *= factor[0][0];
    x[1] = (x[1] - factor[0][1] * x[0]) * factor[1][1];
    x[2] = (x[2] - factor[0][2] * x[0] - factor[1][2] * x[1]) * factor[2][2];
}

/// `C^-T x`.
#[inline]
pub(crate) fn solve_upper(factor: &Block, x: &mut Triple) {
    x[2] *= factor[2][2];
    x[1] = (x[1] - factor[1][2] * x[2]) * factor[1][1];
    x[0] = (x[0] - factor[0][1] * x[1] - factor[0][2] * x[2]) * factor[0][0];
}
