//! The near field: exact distances around the sources, where the heat method is off by 15 to 20 % on any mesh.

use std::sync::Arc;

use crate::error::Result;
use crate::exact::Wavefront;
use crate::heat::HeatSolver;
use crate::options::ExactRadius;
use heatwalk_surface::{Source, ToSource, VertexData, VertexId};

/// A radius that work has cut short is rounded down to a power of this in mean edges, so that moving or adding a
/// source mostly leaves it, and with it the responses kept from before.
const RADIUS_STEP: f64 = 1.189_207_115_002_721; // the fourth root of 2

/// Windows that the near field may propagate, times the fourth root of the number of points: beyond some rings it gains
/// little, and the finer the mesh, the less it may take of a solve.
const WINDOWS: f64 = 600.0;

/// Exact distances around the sources: those of a wavefront that are below a radius.
pub(super) struct Near<'a> {
    values: &'a VertexData<f64>,
    reached: &'a [VertexId],
    /// Every distance below it is known; infinite when all are.
    pub(super) radius: f64,
}

impl<'a> Near<'a> {
    /// What a wavefront knows for certain: all where it is done, else what is below a radius.
    pub(super) fn of(front: &'a Wavefront, radius: f64) -> Self {
        let radius = if front.is_done() { f64::INFINITY } else { radius.min(front.radius()) };
        Self { values: front.values(), reached: front.reached(), radius }
    }

    /// The distance of a point, if it is known.
    pub(super) fn at(&self, point: u32) -> Option<f64> {
        Some(self.values[VertexId(point)]).filter(|&value| value < self.radius)
    }

    /// The points whose distance is known, with it.
    pub(super) fn points(&self) -> impl Iterator<Item = (u32, f64)> + '_ {
        self.reached.iter().filter_map(|&vertex| Some((vertex.0, self.at(vertex.0)?)))
    }
}

impl HeatSolver {
    /// The wavefront of exact distances from some sources.
    ///
    /// # Errors
    /// As [`Surface::source`](heatwalk_surface::Surface::source).
    pub fn wavefront<S: ToSource>(&self, sources: &[S]) -> Result<Wavefront> {
        Wavefront::new(Arc::clone(&self.exact), sources)
    }

    pub(super) fn start_wavefront(&self, sources: Vec<Source>) -> Wavefront {
        Wavefront::of_checked(Arc::clone(&self.exact), sources, &[])
    }

    /// What `answer` makes of the near field that the parameters ask for.
    pub(super) fn with_near_field<T>(&self, sources: &[Source], answer: impl FnOnce(&Near<'_>) -> T) -> T {
        let kept = self.front.lock().expect("no holder of the lock panics").take();
        let mut front = match kept {
            Some(mut front) => {
                front.restart_checked(sources.to_vec());
                front
            }
            None => self.start_wavefront(sources.to_vec()),
        };
        let answer = answer(&self.near_field(sources, &mut front));
        *self.front.lock().expect("no holder of the lock panics") = Some(front);
        answer
    }

    fn near_field<'a>(&self, sources: &[Source], front: &'a mut Wavefront) -> Near<'a> {
        let least = sources.iter().map(|source| source.initial_distance()).fold(f64::INFINITY, f64::min);
        match self.parameters.exact_radius {
            ExactRadius::Edges(0.0) => Near { values: front.values(), reached: front.reached(), radius: least },
            ExactRadius::Edges(edges) => {
                let radius = least + edges * self.mean_edge;
                front.advance(radius, usize::MAX);
                Near::of(front, radius)
            }
            ExactRadius::Automatic => {
                let windows = WINDOWS * (self.surface.vertex_count() as f64).powf(0.25);
                front.advance(f64::INFINITY, windows as usize);
                let steps = ((front.radius() - least) / self.mean_edge).log(RADIUS_STEP).floor();
                Near::of(front, least + self.mean_edge * RADIUS_STEP.powf(steps))
            }
        }
    }
}
