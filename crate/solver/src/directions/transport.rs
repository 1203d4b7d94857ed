//! Parallel transport along shortest paths.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::DVec3;
use heatwalk_sparse::{Progress, c64};
use heatwalk_surface::{Element, Place, Source, ToPoint, VertexData, VertexId};

use super::plane::Plane;
use super::searched;
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, Leg, Root, Wavefront};

/// Carries vectors at points of the surface to all vertices (`#V`), each along an exact shortest path from the nearest of the points; the
/// first of those that are equally near. A vector is that in space whose part along the surface is meant, and arrives as long as that part
/// is, in the plane of the [normal](heatwalk_surface::Surface::vertex_normal) of the vertex.
///
/// Angles at a vertex are scaled to sum to 2π, but not at a boundary. Not numbers are the vectors where no point reaches, and those beyond
/// bridges and at vertices around which triangles are not one ring or fan of one orientation, with what lies behind these.
///
/// # Errors
/// [`Error::NoSource`]; [`Error::BadParameter`] for a vector that is zero, not finite or square to the surface, and for a point
/// where the surface has no tangent plane; [`Error::NotExact`] where faces have different costs; those of [`ToPoint::to_point`];
/// [`Error::OutOfMemory`]; [`Error::Cancelled`].
pub fn transport<P: ToPoint>(
    geometry: &Arc<ExactGeometry>,
    vectors: &[(P, DVec3)],
    progress: Progress<'_>,
) -> Result<VertexData<DVec3>> {
    if vectors.is_empty() {
        return Err(Error::NoSource);
    }
    let surface = geometry.surface();
    let mut starts = Vec::new();
    let mut sources = Vec::new();
    for &(point, vector) in vectors {
        let point = point.to_point(surface)?;
        let plane = Plane::at(geometry, point.place())?;
        let number = plane.number("the vector", vector)?;
        starts.push((plane, number));
        sources.push(Source::from(point));
    }
    let front = searched(geometry, &sources, progress)?;
    let mut carried = Carried { front: &front, starts, numbers: vec![None; surface.vertex_count()] };
    let mut vectors = vec![DVec3::NAN; surface.vertex_count()];
    front.for_each_leg(f64::INFINITY, |stop, leg| {
        // Portals have no plane.
        if stop < vectors.len()
            && let Some(vector) = carried.along(VertexId::from_index(stop), leg)
        {
            vectors[stop] = vector;
        }
    })?;
    Ok(vectors.into())
}

/// What has been carried so far.
struct Carried<'a> {
    front: &'a Wavefront,
    /// The planes of the sources, and the vectors there.
    starts: Vec<(Plane, c64)>,
    /// `#V`, the vectors in the planes of the vertices.
    numbers: Vec<Option<c64>>,
}

impl Carried<'_> {
    /// Carries a vector along a leg to a vertex. In space it is this.
    fn along(&mut self, vertex: VertexId, leg: &Leg) -> Option<DVec3> {
        let geometry = self.front.geometry();
        let plane = Plane::at_vertex(geometry, vertex)?;
        let number = match leg.root {
            Root::End(_) | Root::Side(_) => return None,
            Root::Source(source) => {
                let (start, number) = &self.starts[source];
                if geometry.settled(self.front.sources()[source].place()) == Place::Vertex(vertex) {
                    *number
                } else {
                    carried(start, *number, leg, &plane)
                }
            }
            Root::Vertex(bend) => {
                let number = self.numbers[bend.index()]?;
                carried(&Plane::at_vertex(geometry, bend)?, number, leg, &plane)
            }
        };
        self.numbers[vertex.index()] = Some(number);
        Some(plane.vector(number))
    }
}

/// A vector in one plane, carried along a leg to another plane: its angle with the leg stays the same.
fn carried(from: &Plane, number: c64, leg: &Leg, to: &Plane) -> c64 {
    let (departure, arrival) = (from.angle(&leg.departure), to.angle(&leg.arrival) + PI);
    let aside = number * c64::cis(-departure);
    c64::cis(arrival) * if leg.is_mirrored { aside.conj() } else { aside }
}
