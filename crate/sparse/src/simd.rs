//! Numeric loops compiled for the vector instructions of the machine at hand.

/// Numeric work that gains from wide vector instructions.
pub(crate) trait Work {
    type Output;

    /// Does it. `FUSED` tells whether multiplying and adding is one instruction; see [`multiply_add`]. The function and
    /// all that it calls in its loops are to be `#[inline(always)]`, else they are compiled for the oldest machine.
    fn run<const FUSED: bool>(self) -> Self::Output;
}

/// Does numeric work with the widest vector instructions that are there: on x86-64 as found at run time, elsewhere those
/// that the target has for certain.
pub(crate) fn dispatch<W: Work>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let pulp::Arch::V3(simd) = pulp::Arch::new() {
        return simd.vectorize(
            #[inline(always)]
            || work.run::<true>(),
        );
    }
    work.run::<{ cfg!(target_arch = "aarch64") }>()
}

/// `a · b + c`. Where no instruction does both, calling for it would be many times slower.
#[inline(always)]
pub(crate) fn multiply_add<const FUSED: bool>(a: f64, b: f64, c: f64) -> f64 {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// The array of `entry(0)`, `entry(1)`... That of the standard library may end up as a function of its own, compiled for
/// the oldest machine.
#[inline(always)]
pub(crate) fn array<T: Copy + Default, const N: usize>(mut entry: impl FnMut(usize) -> T) -> [T; N] {
    let mut array = [T::default(); N];
    for (index, place) in array.iter_mut().enumerate() {
        *place = entry(index);
    }
    array
}

/// Two numbers in one vector register. On wasm32 the compiler does not find pairs by itself as it does elsewhere.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair(Register);

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
type Register = core::arch::wasm32::v128;
#[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
type Register = [f64; 2];

impl Default for Pair {
    #[inline(always)]
    fn default() -> Self {
        Self::new([0.0; 2])
    }
}

impl Pair {
    #[inline(always)]
    pub(crate) fn new(numbers: [f64; 2]) -> Self {
        Self(bytemuck::cast(numbers))
    }

    #[inline(always)]
    pub(crate) fn numbers(self) -> [f64; 2] {
        bytemuck::cast(self.0)
    }

    /// `self + a · b`, number by number.
    #[inline(always)]
    pub(crate) fn plus_product<const FUSED: bool>(self, a: Self, b: Self) -> Self {
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        return Self(core::arch::wasm32::f64x2_add(self.0, core::arch::wasm32::f64x2_mul(a.0, b.0)));
        #[cfg(not(all(target_arch = "wasm32", target_feature = "simd128")))]
        Self(array(|i| multiply_add::<FUSED>(a.0[i], b.0[i], self.0[i])))
    }
}

/// Dot product in four running sums, which the compiler may keep in vector registers.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a_blocks, b_blocks) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a_blocks.remainder().iter().zip(b_blocks.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (a, b) in a_blocks.zip(b_blocks) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[2]) + (sums[1] + sums[3]) + rest
}
