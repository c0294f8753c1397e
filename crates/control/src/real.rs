use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, Mul, Neg, Sub};

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// The arithmetic of a controller: `f32` on a microcontroller, `f64` elsewhere.
///
/// Sine and cosine come from `libm`, so that results do not depend on the platform's C library.
pub trait Real:
    sealed::Sealed
    + Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + AddAssign
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// 0.
    const ZERO: Self;
    /// 1.
    const ONE: Self;

    /// The nearest value of this type.
    fn of(value: f64) -> Self;
    /// The value as `f64`.
    fn to_f64(self) -> f64;
    /// Sine and cosine of an angle in rad.
    fn sine_cosine(self) -> (Self, Self);
    /// Magnitude.
    fn abs(self) -> Self;
    /// True unless NaN or infinite.
    fn is_finite(self) -> bool;

    /// The value limited to [-bound, bound]; 0 when it is NaN. Never panics, unlike `clamp`.
    fn limited(self, bound: Self) -> Self {
        if self > bound {
            bound
        } else if self < -bound {
            -bound
        } else if self >= -bound {
            self
        } else {
            Self::ZERO
        }
    }

    /// The magnitude of the value with the sign of another.
    fn with_sign_of(self, other: Self) -> Self {
        if other < Self::ZERO {
            -self.abs()
        } else {
            self.abs()
        }
    }

    /// The greater of two values.
    fn larger(self, other: Self) -> Self {
        if self < other { other } else { self }
    }
}

macro_rules! real {
    ($t:ty, $sincos:path) => {
        impl Real for $t {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;

            fn of(value: f64) -> Self {
                value as $t
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            fn sine_cosine(self) -> (Self, Self) {
                $sincos(self)
            }
            fn abs(self) -> Self {
                <$t>::abs(self)
            }
            fn is_finite(self) -> bool {
                <$t>::is_finite(self)
            }
        }
    };
}

real!(f32, libm::sincosf);
real!(f64, libm::sincos);
