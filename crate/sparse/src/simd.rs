//! SIMD dispatch: numeric loops compiled for the vector instructions of the machine at hand.

/// Numeric work that gains from wide vector instructions.
pub(crate) trait Work {
    type Output;

    /// Does it. `FUSED` tells whether multiplying and adding is one instruction. The function and
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
