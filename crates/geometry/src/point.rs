use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// A point or a vector in the plane, m.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Map frame x, m.
    pub x: f64,
    /// Map frame y, m.
    pub y: f64,
}

impl Point {
    /// The origin, or the zero vector.
    pub const ZERO: Self = Self { x: 0.0, y: 0.0 };

    /// The point (x, y).
    pub const fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The unit vector at an angle from +x, rad.
    pub fn unit(angle: f64) -> Self {
        let (sin, cos) = libm::sincos(angle);
        Self::new(cos, sin)
    }

    /// Scalar product.
    pub fn dot(self, other: Self) -> f64 {
        self.x * other.x + self.y * other.y
    }

    /// z component of the cross product: positive when `other` lies counter-clockwise of `self`.
    pub fn cross(self, other: Self) -> f64 {
        self.x * other.y - self.y * other.x
    }

    /// Euclidean length.
    pub fn norm(self) -> f64 {
        // Not hypot, which is many times slower to be exact near overflow, and may differ between machines.
        self.norm_squared().sqrt()
    }

    /// Squared Euclidean length.
    pub fn norm_squared(self) -> f64 {
        self.dot(self)
    }

    /// Euclidean distance.
    pub fn distance(self, other: Self) -> f64 {
        (self - other).norm()
    }

    /// The vector turned by +90 degrees.
    pub fn perp(self) -> Self {
        Self::new(-self.y, self.x)
    }

    /// The vector's angle from +x in (-pi, pi].
    pub fn angle(self) -> f64 {
        libm::atan2(self.y, self.x)
    }

    /// `self + t (other - self)`.
    pub fn lerp(self, other: Self, t: f64) -> Self {
        self + (other - self) * t
    }

    /// True when both coordinates are finite.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite()
    }
}

impl From<[f64; 2]> for Point {
    fn from([x, y]: [f64; 2]) -> Self {
        Self { x, y }
    }
}

impl From<Point> for [f64; 2] {
    fn from(p: Point) -> Self {
        [p.x, p.y]
    }
}

impl Add for Point {
    type Output = Self;
    fn add(self, o: Self) -> Self {
        Self::new(self.x + o.x, self.y + o.y)
    }
}

impl AddAssign for Point {
    fn add_assign(&mut self, o: Self) {
        *self = *self + o;
    }
}

impl Sub for Point {
    type Output = Self;
    fn sub(self, o: Self) -> Self {
        Self::new(self.x - o.x, self.y - o.y)
    }
}

impl SubAssign for Point {
    fn sub_assign(&mut self, o: Self) {
        *self = *self - o;
    }
}

impl Mul<f64> for Point {
    type Output = Self;
    fn mul(self, k: f64) -> Self {
        Self::new(self.x * k, self.y * k)
    }
}

impl Div<f64> for Point {
    type Output = Self;
    fn div(self, k: f64) -> Self {
        Self::new(self.x / k, self.y / k)
    }
}

impl Neg for Point {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}
