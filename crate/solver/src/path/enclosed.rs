//! Area on both sides of a closed curve on the surface.
//!
//! The winding number is constant between pieces of the curve, and one larger on their left than on their right. Within a face it is
//! counted along the inside of its border, where the segments in that face begin and end; neighbors agree on it along their common edge.
//! So vertices and edges that the curve goes through or along need no special case: a segment counts for the one face that its path
//! names. Area times winding number is an integral over borders and segments, by Green's theorem.

use heatwalk_base::csr::NONE;
use heatwalk_surface::surface::Surface;
use heatwalk_surface::{FaceData, FaceId, Path, SNAP};

use crate::error::{Error, Result};

/// Weights at a place on a face sum to 1 up to rounding; where they miss it by more than this, the place is on another face.
const WEIGHT_ROUNDING: f64 = 1e-9;

/// Shares of an area beyond which a sum of rounded triangles is not it.
const AREA_ROUNDING: f64 = 1e-9;

/// What a closed curve encloses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Enclosed {
    /// The areas to the left and to the right of the curve, seen with the normal upward, in the file's unit squared.
    Sides([f64; 2]),
    /// It does not part its component in two, as around the tube of a torus.
    Whole,
    /// It crosses itself, so that there are more than two sides.
    Crossed,
    /// It crosses a portal, or its component has no orientation or edges with more than two faces: there are no sides.
    Sideless,
}

/// A segment of the curve within a face, from and to barycentric weights.
type Chord = [[f64; 3]; 2];

/// Where the winding number changes along the inside of a face's border: from 0 at its first corner to 3, one an edge.
#[derive(Debug, Clone, Copy)]
struct Change {
    at: f64,
    change: i32,
}

/// Puts a step where it belongs among others in order. There are few of them in a face.
fn insert(steps: &mut Vec<Change>, step: Change) {
    steps.insert(steps.partition_point(|other| other.at <= step.at), step);
}

/// What of the curve lies in a face.
#[derive(Debug, Default)]
struct Crossed {
    chords: Vec<Chord>,
    /// In order of their places.
    steps: Vec<Change>,
}

impl Crossed {
    /// The winding number at a place of the border, less that before the first corner.
    fn winding(&self, at: f64) -> i32 {
        self.steps.iter().take_while(|step| step.at < at).map(|step| step.change).sum()
    }

    /// The winding numbers along the border, less that before the first corner.
    fn border_windings(&self) -> impl Iterator<Item = i32> + '_ {
        let ends = self.steps.iter().skip(1).map(|step| step.at).chain([3.0]);
        let wide = self.steps.iter().zip(ends).filter(|(step, end)| end - step.at > SNAP);
        std::iter::once(0).chain(wide.map(|(step, _)| self.winding(step.at.next_up())))
    }

    /// A place of an edge that is away from all steps of this face and, as `others`, of its neighbor: the middle of the widest gap.
    fn gap(&self, k: usize, others: impl Iterator<Item = f64>) -> f64 {
        let own = self.steps.iter().map(|step| step.at - k as f64);
        let mut places = vec![Change { at: 0.0, change: 0 }, Change { at: 1.0, change: 0 }];
        for at in own.chain(others).filter(|place| (0.0..=1.0).contains(place)) {
            insert(&mut places, Change { at, change: 0 });
        }
        let widest = places.windows(2).max_by(|a, b| (a[1].at - a[0].at).total_cmp(&(b[1].at - b[0].at)));
        widest.map_or(0.5, |gap| f64::midpoint(gap[0].at, gap[1].at))
    }

    /// The integral of the winding number over the face, with so much at its first corner, in areas of the face.
    fn integral(&self, base: i32) -> f64 {
        let mut sum: f64 = self.chords.iter().map(|&[a, b]| cross(a, b)).sum();
        let (mut winding, mut from) = (base, 0.0);
        let mut steps = self.steps.clone();
        for at in [1.0, 2.0, 3.0] {
            insert(&mut steps, Change { at, change: 0 });
        }
        for step in steps {
            sum += f64::from(winding) * cross(on_border(from), on_border(step.at));
            (winding, from) = (winding + step.change, step.at);
        }
        sum
    }

    /// Whether two segments cross between their ends.
    fn crosses_itself(&self) -> bool {
        let side = |[a, b]: Chord, c: [f64; 3]| cross(a, b) + cross(b, c) + cross(c, a);
        let parts = |chord: Chord, [a, b]: Chord| {
            let [a, b] = [side(chord, a), side(chord, b)];
            a.abs().min(b.abs()) > SNAP && (a < 0.0) != (b < 0.0)
        };
        let mut later = self.chords.iter();
        self.chords.iter().any(|&one| {
            later.next();
            later.clone().any(|&other| parts(one, other) && parts(other, one))
        })
    }
}

/// The area of the triangle of a face's first corner and two places, in areas of the face; negative where it is clockwise.
fn cross(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[1] * b[2] - a[2] * b[1]
}

/// The weights at a place of the border.
fn on_border(at: f64) -> [f64; 3] {
    let k = (at.floor() as usize).min(2);
    let mut weights = [0.0; 3];
    (weights[k], weights[(k + 1) % 3]) = (1.0 - (at - k as f64), at - k as f64);
    weights
}

/// The place of the border with these weights; none inside.
fn border_place(weights: [f64; 3]) -> Option<f64> {
    let k = weights.iter().position(|&weight| weight == 0.0)?;
    let [i, j] = [(k + 1) % 3, (k + 2) % 3];
    let at = i as f64 + weights[j] / (weights[i] + weights[j]);
    Some(if at >= 3.0 { 0.0 } else { at })
}

/// The areas on both sides of the closed curve that paths of this surface form, each from the end of the one before.
///
/// # Errors
/// [`Error::Surface`] with `ForeignSurface` for a path on another surface; [`Error::BadParameter`] for an open curve.
pub fn enclosed(surface: &Surface, paths: &[Path]) -> Result<Enclosed> {
    for path in paths {
        surface.require_own(path.surface(), "path")?;
    }
    let Some(curve) = Curve::new(surface, paths) else { return Ok(Enclosed::Sideless) };
    if curve.crossed.iter().any(|(_, face)| face.steps.iter().map(|step| step.change).sum::<i32>() != 0) {
        let range = "closed: each path begins where the one before ends";
        return Err(Error::BadParameter { name: "curve", value: "open".to_owned(), range });
    }
    if curve.crossed.iter().any(|(_, face)| face.crosses_itself()) {
        return Ok(Enclosed::Crossed);
    }
    Ok(match curve.windings(surface) {
        Ok(windings) => curve.areas(surface, &windings),
        Err(why) => why,
    })
}

/// The faces that a curve goes through.
struct Curve {
    crossed: Vec<(FaceId, Crossed)>,
    /// `#F`, which of `crossed` each face is; [`NONE`] for the others.
    number: FaceData<u32>,
}

impl Curve {
    /// None where it leaps from one face to another.
    fn new(surface: &Surface, paths: &[Path]) -> Option<Self> {
        let mut curve = Self { crossed: Vec::new(), number: vec![NONE; surface.face_count()].into() };
        for ends in paths.iter().flat_map(|path| path.points.windows(2)) {
            let face = ends[0].face;
            let chord = [&ends[0], &ends[1]].map(|end| end.location.snapped(surface).weights_in(surface, face));
            if chord.iter().any(|weights| (weights.iter().sum::<f64>() - 1.0).abs() > WEIGHT_ROUNDING) {
                return None;
            }
            if curve.number[face] == NONE {
                curve.number[face] = curve.crossed.len() as u32;
                curve.crossed.push((face, Crossed::default()));
            }
            let (_, crossed) = &mut curve.crossed[curve.number[face] as usize];
            for (weights, change) in chord.into_iter().zip([-1, 1]) {
                if let Some(at) = border_place(weights) {
                    insert(&mut crossed.steps, Change { at, change });
                }
            }
            crossed.chords.push(chord);
        }
        Some(curve)
    }

    fn in_face(&self, face: FaceId) -> Option<&Crossed> {
        self.crossed.get(self.number[face] as usize).map(|(_, crossed)| crossed)
    }

    /// `#F`, the winding number at the first corner of each face that can be reached from the curve.
    fn windings(&self, surface: &Surface) -> std::result::Result<FaceData<Option<i32>>, Enclosed> {
        let plain = Crossed::default();
        let edges = surface.edges();
        let mut windings: FaceData<Option<i32>> = vec![None; surface.face_count()].into();
        let mut open: Vec<(FaceId, i32)> = self.crossed.first().map(|&(face, _)| (face, 0)).into_iter().collect();
        for &(face, base) in &open {
            windings[face] = Some(base);
        }
        while let Some((face, base)) = open.pop() {
            let here = self.in_face(face).unwrap_or(&plain);
            for k in 0..3 {
                let halfedge = face.halfedge(k);
                if edges.is_single(halfedge) {
                    continue;
                }
                let mate = edges.mate(halfedge).ok_or(Enclosed::Sideless)?;
                let (other, j) = (mate.triangle(), mate.corner());
                // Both run the same way along the edge: they face opposite sides.
                if surface.ends(halfedge)[0] == surface.ends(mate)[0] {
                    return Err(Enclosed::Sideless);
                }
                let there = self.in_face(other).unwrap_or(&plain);
                let at = here.gap(k, there.steps.iter().map(|step| 1.0 - (step.at - j as f64)));
                let beyond = base + here.winding(k as f64 + at) - there.winding(j as f64 + 1.0 - at);
                match windings[other] {
                    None => {
                        windings[other] = Some(beyond);
                        open.push((other, beyond));
                    }
                    Some(known) if known != beyond => return Err(Enclosed::Whole),
                    Some(_) => {}
                }
            }
        }
        Ok(windings)
    }

    fn areas(&self, surface: &Surface, windings: &FaceData<Option<i32>>) -> Enclosed {
        let (mut total, mut integral) = (0.0, 0.0);
        let (mut least, mut most) = (i32::MAX, i32::MIN);
        let reached = (0..).map(FaceId).zip(windings.iter()).filter_map(|(face, winding)| Some((face, (*winding)?)));
        for (face, base) in reached {
            let area = surface.face_area(face);
            total += area;
            match self.in_face(face) {
                None => {
                    integral += area * f64::from(base);
                    (least, most) = (least.min(base), most.max(base));
                }
                Some(inside) => {
                    integral += area * inside.integral(base);
                    for winding in inside.border_windings() {
                        (least, most) = (least.min(base + winding), most.max(base + winding));
                    }
                }
            }
        }
        if most - least > 1 {
            return Enclosed::Crossed;
        }
        let above = integral - f64::from(least) * total;
        // Where no border is crossed, the curve is in one face, and what is left of it is inside or all else.
        let left = if most == least && above < 0.0 { total + above } else { above };
        let slack = AREA_ROUNDING * total;
        if !(-slack..=total + slack).contains(&left) {
            return Enclosed::Crossed;
        }
        let left = left.clamp(0.0, total);
        Enclosed::Sides([left, total - left])
    }
}
