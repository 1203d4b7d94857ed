//! The numbers of a matrix.

use std::fmt::Debug;
use std::hash::Hash;
use std::iter::Sum;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::simd::array;

/// A number of a Hermitian matrix: [`f64`], whose matrices are symmetric, or [`c64`](crate::c64). A type of one's own is
/// solved too: it says `type Pair = [Self; 2]` and leaves vector instructions to the compiler. Its functions are to be
/// `#[inline(always)]`.
pub trait Scalar:
    Copy
    + Default
    + Debug
    + PartialEq
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Sum
{
    /// Two numbers in a vector register.
    type Pair: Pair<Self>;

    /// What tells it from every other number, to look it up.
    type Bits: Copy + Debug + Eq + Hash + Send + Sync;

    /// What multigrid turns a value by before two rows share it; `()` where they share it as it is.
    type Turn: Turn<Self>;

    /// What adding leaves unchanged.
    const ZERO: Self;

    /// The complex conjugate.
    fn conj(self) -> Self;

    /// The real part.
    fn real(self) -> f64;

    /// Of a real number.
    fn from_real(number: f64) -> Self;

    /// What tells it from every other number.
    fn bits(self) -> Self::Bits;

    /// The absolute value, or nearly so, where its square would overflow too.
    fn magnitude(self) -> f64;

    /// The square of the absolute value.
    fn abs2(self) -> f64;

    /// The product with a real number.
    fn scale(self, factor: f64) -> Self;

    /// The quotient by a real number.
    fn divide(self, divisor: f64) -> Self;

    /// `a · b + c`. `FUSED` tells whether the machine has one instruction for both; where it has not, calling for it would
    /// be many times slower.
    fn multiply_add<const FUSED: bool>(a: Self, b: Self, c: Self) -> Self;

    /// How strongly an entry of a matrix draws the values of its row and its column, turned, to each other; where it is not
    /// above 0, not at all.
    fn coupling(self) -> f64;

    /// From the value of its column to that of its row, of an entry with a coupling.
    fn turn(self) -> Self::Turn;
}

/// Multiplication by a number of absolute value 1.
pub trait Turn<T>: Copy + Debug + Send + Sync {
    /// By 1.
    const NONE: Self;

    /// Both.
    fn and(self, other: Self) -> Self;

    /// The number turned.
    fn apply(self, number: T) -> T;

    /// The number turned back.
    fn revert(self, number: T) -> T;
}

impl<T> Turn<T> for () {
    const NONE: Self = ();

    #[inline(always)]
    fn and(self, (): ()) -> Self {}

    #[inline(always)]
    fn apply(self, number: T) -> T {
        number
    }

    #[inline(always)]
    fn revert(self, number: T) -> T {
        number
    }
}

/// Two numbers that are worked on side by side.
pub trait Pair<T>: Copy + Default {
    /// The pair of two numbers.
    fn new(numbers: [T; 2]) -> Self;

    /// The two numbers.
    fn numbers(self) -> [T; 2];

    /// The complex conjugates.
    fn conj(self) -> Self;

    /// `self + a · b`, number by number.
    fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self;
}

impl<T: Scalar> Pair<T> for [T; 2] {
    #[inline(always)]
    fn new(numbers: [T; 2]) -> Self {
        numbers
    }

    #[inline(always)]
    fn numbers(self) -> [T; 2] {
        self
    }

    #[inline(always)]
    fn conj(self) -> Self {
        array(|i| self[i].conj())
    }

    #[inline(always)]
    fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self {
        array(|i| T::multiply_add::<FUSED>(a[i], b[i], self[i]))
    }
}

/// How an entry of a factor is kept: as the number itself, or rounded.
pub trait Entry<T: Scalar>: Copy + Default + Debug + Send + Sync + 'static {
    /// The number.
    fn number(self) -> T;

    /// Two numbers.
    fn pair(entries: [Self; 2]) -> T::Pair;
}

impl<T: Scalar> Entry<T> for T {
    #[inline(always)]
    fn number(self) -> T {
        self
    }

    #[inline(always)]
    fn pair(entries: [Self; 2]) -> T::Pair {
        T::Pair::new(entries)
    }
}

/// `aᴴ b` in four running sums, which the compiler may keep in vector registers.
pub(crate) fn dot<T: Scalar>(a: &[T], b: &[T]) -> T {
    let (a_blocks, b_blocks) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: T = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(&a, &b)| a.conj() * b).sum();
    let mut sums = [T::ZERO; 4];
    for (a, b) in a_blocks.zip(b_blocks) {
        for lane in 0..4 {
            sums[lane] += a[lane].conj() * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}
