//! Ground of different difficulty: what a unit of length costs in each face.
//!
//! A cost w makes the metric `g` of the surface `w² g`: all lengths in a face count `w` times, angles stay.

use std::ops::RangeInclusive;
use std::sync::Arc;

use glam::DVec3;
use heatwalk_surface::{Element, FaceData, FaceId, InputVertex, Path, PathPoint, Surface, VertexData};

use crate::error::{Error, Result};

/// Cost of each face of a surface: how much a unit of length counts there.
#[derive(Debug, Clone, PartialEq)]
pub struct Costs {
    /// `#F`, in [`Costs::RANGE`].
    of_face: Arc<FaceData<f64>>,
    /// That of all faces, where they have one.
    constant: Option<f64>,
}

/// Name of a cost in errors.
const NAME: &str = "a cost";

impl Costs {
    /// What a cost may be. Where none shall walk at all, there are [walls](heatwalk_surface::Walls).
    pub const RANGE: RangeInclusive<f64> = 1e-3..=1e3;

    /// Costs of all faces (`#F`).
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a cost outside of [`Costs::RANGE`], with the number of its face.
    ///
    /// # Panics
    /// Where there is not one cost a face.
    pub fn new(surface: &Surface, of_face: FaceData<f64>) -> Result<Self> {
        assert_eq!(of_face.len(), surface.face_count(), "one cost a face");
        if let Some((face, cost)) = of_face.enumerate().find(|(_, cost)| !Self::RANGE.contains(cost)) {
            return Err(Error::BadParameter {
                name: NAME,
                value: format!("{cost} at face {}", surface.triangle_of_face(face).0),
                range: "from 0.001 to 1000; make faces that none may enter walls",
            });
        }
        Ok(Self::of_checked(of_face))
    }

    /// Costs of all vertices (`#V`): that of a face is the mean of its corners'.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn of_vertices(surface: &Surface, of_vertex: &VertexData<f64>) -> Result<Self> {
        let mean = |corners: &[_; 3]| corners.iter().map(|&vertex| of_vertex[vertex]).sum::<f64>() / 3.0;
        Self::new(surface, surface.faces().iter().map(mean).collect())
    }

    /// Costs of the input's vertices, in its order: that of a face is the mean of its corners'.
    ///
    /// # Errors
    /// [`Error::BadParameter`] for a corner of a face whose cost is outside of [`Costs::RANGE`], with the number of its vertex.
    ///
    /// # Panics
    /// Where there is not one cost a vertex of the input.
    pub fn of_input_vertices(surface: &Surface, of_vertex: &[f64]) -> Result<Self> {
        assert_eq!(of_vertex.len(), surface.vertices_of_inputs().len(), "one cost a vertex of the input");
        let used = surface.vertices_of_inputs().enumerate().filter(|(_, vertex)| vertex.is_some());
        let mut bad = used.map(|(input, _)| input).filter(|input| !Self::RANGE.contains(&of_vertex[input.index()]));
        if let Some(InputVertex(first)) = bad.next() {
            let more = match bad.count() {
                0 => String::new(),
                count => format!(", and out of range at {count} more"),
            };
            let value = format!("{} at vertex {first}{more}", of_vertex[first as usize]);
            return Err(Error::BadParameter { name: NAME, value, range: "from 0.001 to 1000" });
        }
        let cost = |vertex: InputVertex| of_vertex[vertex.0 as usize];
        let mean = |face| surface.inputs_of_face(face).map(cost).iter().sum::<f64>() / 3.0;
        Self::new(surface, (0..surface.face_count() as u32).map(FaceId).map(mean).collect())
    }

    /// Costs by how steep a face is: `cost` takes the tangent of its angle with what is level, 0 to infinity. `up` is the
    /// direction against which that is measured, of any length. Costs outside of [`Costs::RANGE`] are cut to it.
    ///
    /// # Errors
    /// As [`Self::new`], where `cost` gives what is not a number.
    pub fn of_slope(surface: &Surface, up: DVec3, cost: impl Fn(f64) -> f64) -> Result<Self> {
        let up = up.normalize();
        let of_face = |face| {
            let rise = surface.face_normal(face).dot(up).abs().min(1.0);
            cut(cost((1.0 - rise * rise).sqrt() / rise))
        };
        Self::new(surface, (0..surface.face_count() as u32).map(FaceId).map(of_face).collect())
    }

    /// Costs by the height of a face's middle: `cost` takes its share of the way from the lowest vertex, 0, to the highest,
    /// 1, along `up`, of any length. Costs outside of [`Costs::RANGE`] are cut to it.
    ///
    /// # Errors
    /// As [`Self::new`], where `cost` gives what is not a number.
    pub fn of_height(surface: &Surface, up: DVec3, cost: impl Fn(f64) -> f64) -> Result<Self> {
        let heights: VertexData<f64> = surface.positions().iter().map(|position| position.dot(up)).collect();
        let [low, high] = [f64::min, f64::max]
            .map(|extreme: fn(f64, f64) -> f64| heights.iter().copied().reduce(extreme).unwrap_or_default());
        let share = |corners: &[_; 3]| {
            let mean = corners.iter().map(|&vertex| heights[vertex]).sum::<f64>() / 3.0;
            if high > low { ((mean - low) / (high - low)).clamp(0.0, 1.0) } else { 0.0 }
        };
        Self::new(surface, surface.faces().iter().map(|corners| cut(cost(share(corners)))).collect())
    }

    fn times(&self, other: &Self) -> Self {
        assert_eq!(self.of_face.len(), other.of_face.len(), "costs of as many faces");
        Self::of_checked(self.of_face.iter().zip(other.of_face.iter()).map(|(one, other)| cut(one * other)).collect())
    }

    /// The products of both, cut to [`Costs::RANGE`], or the costs that there are.
    ///
    /// # Panics
    /// Where they are not of as many faces.
    pub fn both(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        match (one, other) {
            (Some(one), Some(other)) => Some(one.times(&other)),
            (one, other) => one.or(other),
        }
    }

    /// These costs on the surface as walls part it. Nothing leads into walls, so that each of their faces costs as little as the
    /// cheapest of the others: it neither makes costs differ nor stretches what is measured.
    pub(crate) fn beside_walls(&self, parted: &Surface) -> Self {
        let is_open = |face: FaceId| !parted.is_wall(face);
        let open = self.of_face.enumerate().filter(|&(face, _)| is_open(face)).map(|(_, &cost)| cost);
        match open.reduce(f64::min) {
            Some(least) if parted.has_walls() => {
                let cost = |(face, &cost): (FaceId, &f64)| if is_open(face) { cost } else { least };
                Self::of_checked(self.of_face.enumerate().map(cost).collect())
            }
            _ => self.clone(),
        }
    }

    /// Of numbers that are in range.
    fn of_checked(of_face: FaceData<f64>) -> Self {
        let first = of_face[FaceId(0)];
        let constant = of_face.iter().all(|&cost| cost == first).then_some(first);
        Self { of_face: Arc::new(of_face), constant }
    }

    /// Whether these are the same numbers in the same memory.
    pub(crate) fn is_same(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.of_face, &other.of_face)
    }

    /// Of a face.
    #[inline(always)]
    pub fn of(&self, face: FaceId) -> f64 {
        self.of_face[face]
    }

    /// `#F`.
    pub fn of_faces(&self) -> &FaceData<f64> {
        &self.of_face
    }

    /// That of all faces, where they have one.
    pub fn constant(&self) -> Option<f64> {
        self.constant
    }

    /// The geometric mean of all faces' costs.
    pub fn mean(&self) -> f64 {
        let logarithms = || self.of_face.iter().map(|cost| cost.ln()).sum::<f64>();
        self.constant.unwrap_or_else(|| (logarithms() / self.of_face.len() as f64).exp())
    }

    /// The cost of a path on the surface: the sum of the lengths of its segments, each times the cost of the face that it
    /// runs through, or of the cheaper one where it runs along an edge; hops over gaps count as on the cheaper side.
    pub fn of_path(&self, surface: &Surface, path: &Path) -> f64 {
        let segment = |pair: &[PathPoint]| {
            let [from, to] = [pair[0], pair[1]].map(|point| point.location.faces(surface));
            let least = |faces: &mut dyn Iterator<Item = FaceId>| faces.map(|face| self.of(face)).reduce(f64::min);
            let shared = least(&mut from.iter().copied().filter(|&face| pair[1].location.lies_on(surface, face)));
            let cost = shared.or_else(|| least(&mut from.iter().chain(&to).copied())).unwrap_or(1.0);
            cost * (pair[1].position - pair[0].position).length()
        };
        path.points.windows(2).map(segment).sum()
    }
}

fn cut(cost: f64) -> f64 {
    // What is not a number stays so, and is refused.
    if cost.is_nan() { cost } else { cost.clamp(*Costs::RANGE.start(), *Costs::RANGE.end()) }
}

/// What a unit of length costs on foot where the ground rises by `slope` (the tangent of its angle), as a multiple of level
/// ground: the mean of the time uphill and the time downhill by Tobler's hiking function (Tobler, "Three presentations on
/// geographical analysis and modeling", 1993), whose speed is `6 exp(−3.5 |slope + 0.05|)` km/h.
pub fn tobler(slope: f64) -> f64 {
    let pace = |slope: f64| (3.5 * (slope + 0.05).abs()).exp();
    0.5 * (pace(slope) + pace(-slope)) / pace(0.0)
}
