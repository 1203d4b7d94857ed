//! A plane of two media, where distances are known by Snell's law.

use glam::DVec2;
use heatwalk::{Costs, FaceData, FaceId, Soup, Surface};

use super::truth::Random;
use super::{flat, grid_triangles, soup};

/// The unit square in so many edges across, each vertex moved by up to a third of an edge but on the boundary and on the
/// line x = ½, where the ground changes.
pub fn jittered_square(edges: u32, seed: u64) -> Soup {
    let mut random = Random::new(seed);
    let mut shift = || random.between(-1.0, 1.0) / 3.0;
    let mut points = Vec::new();
    for i in 0..=edges {
        for j in 0..=edges {
            let is_fixed = |at: u32| at == 0 || at == edges;
            let dx = if is_fixed(i) || 2 * i == edges { 0.0 } else { shift() };
            let dy = if is_fixed(j) { 0.0 } else { shift() };
            points.push(((f64::from(i) + dx) / f64::from(edges), (f64::from(j) + dy) / f64::from(edges)));
        }
    }
    soup(flat(&points), grid_triangles(0, edges).collect())
}

/// Cost 1 where x < ½, and this beyond.
pub fn two_media(surface: &Surface, cost: f64) -> Costs {
    let of_face = |face: u32| {
        let middle: f64 = surface.corners(FaceId(face)).iter().map(|corner| corner.x / 3.0).sum();
        if middle < 0.5 { 1.0 } else { cost }
    };
    let costs: FaceData<f64> = (0..surface.face_count() as u32).map(of_face).collect();
    Costs::new(surface, costs).expect("costs in range")
}

/// The least cost of a path in the infinite plane of these two media: straight, refracted, or, between two points of the
/// dearer one, along the line at the critical angle.
pub fn least_cost(from: DVec2, to: DVec2, cost: f64) -> f64 {
    let of = |point: DVec2| if point.x < 0.5 { 1.0 } else { cost };
    let by = |y: f64| of(from) * (DVec2::new(0.5, y) - from).length() + of(to) * (DVec2::new(0.5, y) - to).length();
    if (from.x < 0.5) == (to.x < 0.5) {
        let straight = of(from) * (to - from).length();
        let cheaper = cost.min(1.0);
        if of(from) == cheaper {
            return straight;
        }
        let dearer = of(from);
        let (aside, along) = ((from.x - 0.5).abs() + (to.x - 0.5).abs(), (to.y - from.y).abs());
        let sine = cheaper / dearer;
        let cosine = (1.0 - sine * sine).sqrt();
        // What lies between the two points where the critical rays meet the line.
        let on_line = along - aside * sine / cosine;
        if on_line < 0.0 { straight } else { straight.min(dearer * aside / cosine + cheaper * on_line) }
    } else {
        // A convex function.
        let (mut low, mut high) = (from.y.min(to.y), from.y.max(to.y));
        for _ in 0..200 {
            let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
            if by(a) < by(b) { high = b } else { low = a }
        }
        by(0.5 * (low + high))
    }
}
