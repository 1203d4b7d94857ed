//! Numbers of some 32 digits: sums of two floats, the second below half a unit of the first's last place (Dekker, "A
//! floating-point technique for extending the available precision", 1971).

use std::ops::{Add, Div, Mul, Neg, Sub};

use glam::DVec3;

#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    pub const ZERO: Self = Self::new(0.0);
    pub const INFINITY: Self = Self::new(f64::INFINITY);

    pub const fn new(value: f64) -> Self {
        Self { high: value, low: 0.0 }
    }

    /// The same number where the first float is much the larger.
    fn renormalized(high: f64, low: f64) -> Self {
        let sum = high + low;
        Self { high: sum, low: low - (sum - high) }
    }

    pub fn to_f64(self) -> f64 {
        self.high
    }

    pub fn is_finite(self) -> bool {
        self.high.is_finite()
    }

    pub fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    pub fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    pub fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    pub fn sqrt(self) -> Self {
        if self <= Self::ZERO {
            return Self::ZERO;
        }
        // One step of Newton doubles the digits.
        let root = Self::new(self.high.sqrt());
        root + (self - root * root) / (root + root)
    }
}

impl Neg for DoubleDouble {
    type Output = Self;

    fn neg(self) -> Self {
        Self { high: -self.high, low: -self.low }
    }
}

impl Add for DoubleDouble {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let sum = self.high + other.high;
        if !sum.is_finite() {
            return Self::new(sum);
        }
        let (high, high_error) = two_sum(self.high, other.high);
        let (low, low_error) = two_sum(self.low, other.low);
        let sum = Self::renormalized(high, high_error + low);
        Self::renormalized(sum.high, sum.low + low_error)
    }
}

impl Sub for DoubleDouble {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for DoubleDouble {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let error = self.high.mul_add(other.high, -product);
        Self::renormalized(product, error + (self.high * other.low + self.low * other.high))
    }
}

impl Div for DoubleDouble {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let first = Self::new(self.high / other.high);
        let rest = self - first * other;
        let second = Self::new(rest.high / other.high);
        let rest = rest - second * other;
        first + second + Self::new(rest.high / other.high)
    }
}

fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let part = sum - a;
    (sum, (a - (sum - part)) + (b - part))
}

/// A vector of so many coordinates.
pub type Vector<const N: usize> = [DoubleDouble; N];

pub fn difference(a: DVec3, b: DVec3) -> Vector<3> {
    let [a, b] = [a, b].map(|point| point.to_array().map(DoubleDouble::new));
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub fn dot<const N: usize>(a: Vector<N>, b: Vector<N>) -> DoubleDouble {
    a.into_iter().zip(b).fold(DoubleDouble::ZERO, |sum, (a, b)| sum + a * b)
}

pub fn length<const N: usize>(a: Vector<N>) -> DoubleDouble {
    dot(a, a).sqrt()
}

/// Twice the area between two vectors of space, positive.
pub fn area(a: Vector<3>, b: Vector<3>) -> DoubleDouble {
    length([(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i] * b[j] - a[j] * b[i]))
}

/// Twice the area between two vectors of the plane, positive where the second is counter-clockwise of the first.
pub fn cross(a: Vector<2>, b: Vector<2>) -> DoubleDouble {
    a[0] * b[1] - a[1] * b[0]
}

/// `a + s b + t c`.
pub fn combination(a: Vector<2>, (s, b): (DoubleDouble, Vector<2>), (t, c): (DoubleDouble, Vector<2>)) -> Vector<2> {
    [0, 1].map(|k| a[k] + s * b[k] + t * c[k])
}
