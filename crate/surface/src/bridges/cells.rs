//! Cells of a grid in space, and lists that cells share.

use glam::DVec3;

/// The cell that holds a point, in units of its size.
#[inline]
pub fn cell_of(point: DVec3) -> [i64; 3] {
    // As `floor`, which is a call where the processor may be an old one.
    point.to_array().map(|along| {
        let whole = along as i64;
        whole - i64::from(whole as f64 > along)
    })
}

/// The number of a cell's list among so many, a power of two (Teschner and others, "Optimized spatial hashing for collision
/// detection of deformable objects", 2003).
#[inline]
pub fn list_of([x, y, z]: [i64; 3], lists: usize) -> usize {
    let hash = x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
    hash as usize & (lists - 1)
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::*;

    #[test]
    fn cells_reach_from_their_lower_side_to_the_next() {
        assert_eq!(cell_of(DVec3::new(0.0, 1.0, 1.999)), [0, 1, 1]);
        assert_eq!(cell_of(DVec3::new(-0.001, -1.0, -1.001)), [-1, -1, -2]);
    }
}
