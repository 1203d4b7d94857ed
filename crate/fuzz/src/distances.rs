//! What is true of every distance on a surface.

use heatwalk::surface::surface::Surface;
use heatwalk::{Path, Place};

/// Share of the largest coordinate or distance that rounding may cost: needles that are a trillionth as wide as long leave a
/// few digits of directions.
pub const ROUNDING: f64 = 1e-6;

/// # Panics
/// Where a distance is negative or no number, or infinite on a component with a source, or finite on one without.
pub fn check_reached(surface: &Surface, sources: &[Place], values: impl Iterator<Item = f64>) {
    let mut is_reached = vec![false; surface.report().components];
    for source in sources {
        is_reached[source.component(surface) as usize] = true;
    }
    for ((vertex, value), &component) in values.enumerate().zip(surface.components()) {
        assert!(value >= 0.0, "{value} at vertex {vertex}");
        assert_eq!(value.is_finite(), is_reached[component as usize], "{value} at vertex {vertex}");
    }
}

/// # Panics
/// Where distances at the ends of an edge differ by more than the edge is long.
pub fn check_edges(surface: &Surface, values: &[f64]) {
    let largest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    for face in surface.mesh().faces() {
        let [p, q, r] = surface.corners(face);
        let [a, b, c] = surface.faces()[face].map(|vertex| values[vertex.0 as usize]);
        for (x, y, length) in [(a, b, p.distance(q)), (b, c, q.distance(r)), (c, a, r.distance(p))] {
            let is_possible = x.is_infinite() && y.is_infinite() || (x - y).abs() <= length + ROUNDING * largest;
            assert!(is_possible, "{x} and {y} at the ends of an edge of length {length}");
        }
    }
}

/// # Panics
/// Where a path has no length of its own, leaves the bounds of the surface, or does not end at a source.
pub fn check_path(surface: &Surface, path: &Path, sources: &[Place]) {
    let size = surface.positions().iter().map(|position| position.abs().max_element()).fold(0.0, f64::max);
    assert!(path.length().is_finite() && path.length() >= 0.0, "length {}", path.length());
    for point in &path.points {
        assert!(point.position.is_finite() && point.position.abs().max_element() <= size * (1.0 + ROUNDING));
    }
    let end = path.points.last().expect("a path has a point").position;
    let misses = sources.iter().map(|source| source.position(surface).distance(end)).fold(f64::INFINITY, f64::min);
    assert!(misses <= ROUNDING * size, "a path ends {misses} beside the sources");
}
