//! Figures of smoothly united round cones and ellipsoids (Quílez, "Distance functions" and "Smooth minimum").

use glam::{DMat3, DVec3, DVec4};

use super::implicit;

/// Distance to two balls joined by the cone that touches both; exact.
struct RoundCone {
    start: DVec3,
    /// Unit length.
    axis: DVec3,
    length: f64,
    start_radius: f64,
    end_radius: f64,
    /// Sine and cosine of the angle between the axis and the cone's side.
    slant: (f64, f64),
}

impl RoundCone {
    /// Between balls whose fourth coordinate is the radius, neither inside the other.
    fn new(start: DVec4, end: DVec4) -> Self {
        let (axis, length) = (end - start).truncate().normalize_and_length();
        let sin = (start.w - end.w) / length;
        let slant = (sin, (1.0 - sin * sin).sqrt());
        Self { start: start.truncate(), axis, length, start_radius: start.w, end_radius: end.w, slant }
    }

    fn distance(&self, point: DVec3) -> f64 {
        let relative = point - self.start;
        let along = relative.dot(self.axis);
        let length_squared = relative.length_squared();
        let across_squared = (length_squared - along * along).max(0.0);
        let across = across_squared.sqrt();
        let (sin, cos) = self.slant;
        let foot = along * cos - across * sin;
        if foot < 0.0 {
            length_squared.sqrt() - self.start_radius
        } else if foot > self.length * cos {
            let beyond = along - self.length;
            (across_squared + beyond * beyond).sqrt() - self.end_radius
        } else {
            across * cos + along * sin - self.start_radius
        }
    }
}

/// The smaller of two distances, with the crease rounded over the width `blend`.
pub fn smooth_min(a: f64, b: f64, blend: f64) -> f64 {
    let overlap = (blend - (a - b).abs()).max(0.0) / blend;
    a.min(b) - overlap * overlap * blend / 4.0
}

enum Solid {
    Limb(Vec<RoundCone>),
    /// `local_from_world` turns into the axes of `radii`.
    Ellipsoid {
        radii: DVec3,
        local_from_world: DMat3,
    },
    /// Everything below y = 0.
    Ground,
}

/// A piece of a [`Figure`], with a ball around it, so that points far from it need not ask for more.
pub struct Part {
    solid: Solid,
    centre: DVec3,
    reach: f64,
    on_both_sides: bool,
}

impl Part {
    /// About the distance; exact to first order at the surface, and never less than that to the ball of `reach`.
    fn distance(&self, point: DVec3, to_reach: f64) -> f64 {
        match &self.solid {
            Solid::Limb(cones) => cones.iter().map(|cone| cone.distance(point)).fold(f64::INFINITY, f64::min),
            Solid::Ellipsoid { radii, local_from_world } => {
                let scaled = *local_from_world * (point - self.centre) / *radii;
                let (level, slope) = (scaled.length(), (scaled / *radii).length());
                let distance = if slope == 0.0 { -radii.min_element() } else { level * (level - 1.0) / slope };
                distance.max(to_reach)
            }
            Solid::Ground => point.y,
        }
    }

    /// The same again on the other side of the plane z = 0.
    pub fn on_both_sides(self) -> Self {
        Self { on_both_sides: true, ..self }
    }
}

/// An ellipsoid along the axes.
pub fn ellipsoid(centre: (f64, f64, f64), radii: (f64, f64, f64)) -> Part {
    turned_ellipsoid(centre, radii, DMat3::IDENTITY)
}

/// An ellipsoid whose axes are turned by `world_from_local`.
pub fn turned_ellipsoid(centre: (f64, f64, f64), radii: (f64, f64, f64), world_from_local: DMat3) -> Part {
    let radii = DVec3::from(radii);
    Part {
        solid: Solid::Ellipsoid { radii, local_from_world: world_from_local.transpose() },
        centre: centre.into(),
        reach: radii.max_element(),
        on_both_sides: false,
    }
}

pub fn ball(x: f64, y: f64, z: f64, radius: f64) -> Part {
    ellipsoid((x, y, z), (radius, radius, radius))
}

/// Cones between two balls that are given, so that the curve through them looks smooth.
const CONES_A_SPAN: u32 = 3;

/// A curved limb through at least two balls `(x, y, z, radius)`, straight where there are two.
pub fn limb(balls: &[(f64, f64, f64, f64)]) -> Part {
    let mut path: Vec<DVec4> = balls.iter().map(|&ball| ball.into()).collect();
    if path.len() > 2 {
        path = spline(&path);
    }
    let centre = path.iter().map(|ball| ball.truncate()).sum::<DVec3>() / path.len() as f64;
    let reach = path.iter().map(|ball| ball.truncate().distance(centre) + ball.w).fold(0.0, f64::max);
    let cones = path.windows(2).map(|pair| RoundCone::new(pair[0], pair[1])).collect();
    Part { solid: Solid::Limb(cones), centre, reach, on_both_sides: false }
}

/// Points on the cubic Hermite spline through `knots`, parametrised by the lengths of its chords so that uneven spacing
/// makes no loops.
fn spline(knots: &[DVec4]) -> Vec<DVec4> {
    let slopes: Vec<DVec4> = knots.windows(2).map(|pair| (pair[1] - pair[0]) / chord(pair[0], pair[1])).collect();
    let tangent = |knot: usize| {
        if knot == 0 || knot + 1 == knots.len() {
            return slopes[knot.min(slopes.len() - 1)];
        }
        let (before, after) = (chord(knots[knot - 1], knots[knot]), chord(knots[knot], knots[knot + 1]));
        (slopes[knot - 1] * after + slopes[knot] * before) / (before + after)
    };
    let mut points = vec![knots[0]];
    for span in 0..slopes.len() {
        let (start, end) = (knots[span], knots[span + 1]);
        let length = chord(start, end);
        for step in 1..=CONES_A_SPAN {
            let t = f64::from(step) / f64::from(CONES_A_SPAN);
            let ease = t * t * (3.0 - 2.0 * t);
            let (leave, arrive) = (t * (1.0 - t) * (1.0 - t), t * t * (t - 1.0));
            points.push(start.lerp(end, ease) + length * (leave * tangent(span) + arrive * tangent(span + 1)));
        }
    }
    points
}

fn chord(start: DVec4, end: DVec4) -> f64 {
    start.truncate().distance(end.truncate())
}

/// What lies below y = 0.
pub fn ground() -> Part {
    Part { solid: Solid::Ground, centre: DVec3::ZERO, reach: f64::INFINITY, on_both_sides: false }
}

/// Parts united and carved one after another, from a first one on.
pub struct Figure {
    steps: Vec<Operation>,
}

struct Operation {
    part: Part,
    /// Width over which the crease is rounded.
    blend: f64,
    carves: bool,
}

impl Figure {
    pub fn new(first: Part) -> Self {
        Self { steps: vec![Operation { part: first, blend: f64::MIN_POSITIVE, carves: false }] }
    }

    /// Adds a part, its seam rounded over the width `blend`.
    pub fn unite(&mut self, blend: f64, part: Part) {
        self.steps.push(Operation { part, blend, carves: false });
    }

    /// Takes a part away from all that was united before, the rim rounded over the width `blend`.
    pub fn carve(&mut self, blend: f64, part: Part) {
        self.steps.push(Operation { part, blend, carves: true });
    }

    /// About the distance to the surface, negative inside.
    pub fn distance(&self, point: DVec3) -> f64 {
        let mirrored = DVec3::new(point.x, point.y, point.z.abs());
        let mut distance = f64::INFINITY;
        for Operation { part, blend, carves } in &self.steps {
            let point = if part.on_both_sides { mirrored } else { point };
            let to_reach = point.distance(part.centre) - part.reach;
            let so_far = if *carves { -distance } else { distance };
            // Beyond this, the smooth minimum is `so_far`.
            if to_reach >= so_far + blend {
                continue;
            }
            let united = smooth_min(so_far, part.distance(point, to_reach), *blend);
            distance = if *carves { -united } else { united };
        }
        distance
    }

    /// Vertices and outward triangles; see [`implicit::mesh`].
    pub fn mesh(&self, lower: DVec3, upper: DVec3, spacing: f64) -> (Vec<DVec3>, Vec<[u32; 3]>) {
        implicit::mesh(&|point| self.distance(point), lower, upper, spacing)
    }
}
