//! The log map by heat.
//!
//! Soliman, Sharp, "The affine heat method" (2025): heat carries where its source is, `z = x u` beside the heat u, and each edge that it
//! flows along moves x by the edge. Every place in a plane then has its own x, whatever the triangles and the time are. Here x is in the
//! plane of the source, into which edges are turned by a diffused frame, as in the paper's adaptive method; edges by the mean of the frames
//! at both ends. Because u does not depend on z, the equations of both are solved one after the other, with the factors of heat.

use std::f64::consts::PI;
use std::sync::Arc;

use glam::{DVec2, DVec3};
use heatwalk_sparse::{Progress, c64};
use heatwalk_surface::{Element, HalfedgeId, Place, ToPoint, VertexData, VertexId, triangle};

use super::vectors::VectorHeat;
use crate::directions::{LogMap, Plane};
use crate::error::Result;
use crate::exact::{ExactGeometry, Heading};

/// Heat that a source puts in: far more than what comes of it where numbers end. A power of two.
const SUPPLY: f64 = f64::from_bits((1023 + 900) << 52);

/// A corner of the triangle that a source is in, or its vertex.
struct Support {
    /// Of the half-edge mesh.
    vertex: usize,
    weight: f64,
    /// Where it is, in the plane of the source.
    place: c64,
    /// The number 1 of the plane of the source, carried to that of the vertex.
    unit: c64,
}

impl VectorHeat {
    /// The log map from a point of the surface, as [`log_map`](crate::log_map), but by heat: smooth across the cut locus and where paths bend,
    /// and nothing is carried across bridges. In a plane it is exact up to rounding. The distances are the lengths of its coordinates.
    ///
    /// Not numbers, with an infinite distance, where no heat arrives: on other components, and more than about a thousand √t away.
    ///
    /// # Errors
    /// [`Error::BadParameter`](crate::Error::BadParameter) for a direction that is zero, not finite or square to the surface, and for a source where the surface has
    /// no tangent plane, as on edges of three faces; those of [`ToPoint::to_point`] and [`Self::new`].
    pub fn log_map(&self, source: impl ToPoint, direction: Option<DVec3>, progress: Progress<'_>) -> Result<LogMap> {
        let place = source.to_point(&self.surface)?.place();
        let geometry = self.geometry.get_or_init(|| ExactGeometry::new(Arc::clone(&self.surface)));
        let plane = Plane::at(geometry, place)?;
        let u = plane.first_axis(direction)?;
        let supports = self.supports(geometry, &plane, place);

        let zero = c64::new(0.0, 0.0);
        let (mut heat, mut units) = (vec![0.0; self.planes.len()], vec![zero; self.planes.len()]);
        for &Support { vertex, weight, unit, .. } in &supports {
            heat[vertex] += SUPPLY * weight;
            units[vertex] += SUPPLY * weight * unit;
        }
        let flow = self.heat(progress)?;
        let heat = flow.solve(&heat)?;
        // Where nothing arrives, there is none.
        let unit = |vector: c64| if vector.norm() > 0.0 { vector / vector.norm() } else { zero };
        let units: Vec<c64> = self.diffusion.solve(&units)?.into_iter().map(unit).collect();
        let moments = self.moments(&heat, &units, &supports);
        let part = |of: fn(&c64) -> f64| flow.solve(&moments.iter().map(of).collect::<Vec<_>>());
        let [x, y] = [part(|moment| moment.re)?, part(|moment| moment.im)?];

        let unit = self.systems.operators().mean_edge();
        let coordinates = |vertex: VertexId| {
            let vertex = vertex.index();
            if heat[vertex] < f64::MIN_POSITIVE {
                return DVec2::NAN;
            }
            let place = c64::new(x[vertex], y[vertex]) / heat[vertex] * u.conj();
            unit * DVec2::new(place.re, place.im)
        };
        let mut coordinates: VertexData<DVec2> = self.surface.vertices().map(coordinates).collect();
        if let Some(vertex) = geometry.settled(place).vertex(&self.surface) {
            coordinates[vertex] = DVec2::ZERO;
        }
        let distance = |place: &DVec2| if place.is_nan() { f64::INFINITY } else { place.length() };
        Ok(LogMap { distances: coordinates.iter().map(distance).collect(), coordinates, axes: plane.axes(u) })
    }

    /// What heat moves: the right side of z, in the plane of the source and units of the mean edge.
    fn moments(&self, heat: &[f64], units: &[c64], supports: &[Support]) -> Vec<c64> {
        let operators = self.systems.operators();
        let scale = 1.0 / operators.mean_edge();
        let mut moments = vec![c64::new(0.0, 0.0); heat.len()];
        for support in supports {
            moments[support.vertex] += SUPPLY * support.weight * scale * support.place;
        }
        for (face, shape) in operators.elements.shapes.iter().enumerate() {
            let cotans = shape.cotans();
            for k in 0..3 {
                let side = HalfedgeId((3 * face + k) as u32);
                let [start, end] = self.frames.triangulation().ends(side).map(|vertex| vertex.index());
                let length = scale * self.frames.triangulation().length(side);
                let at_start = length * self.frames.direction(side);
                let at_end = self.frames.transport(side) * at_start;
                let along = 0.5 * (at_start * units[start].conj() + at_end * units[end].conj());
                let along = 0.5 * cotans[(k + 2) % 3] * along;
                moments[start] -= along * heat[end];
                moments[end] += along * heat[start];
            }
        }
        moments
    }

    /// The vertices that a source is between.
    fn supports(&self, geometry: &ExactGeometry, plane: &Plane, place: Place) -> Vec<Support> {
        let place = geometry.settled(place);
        if let Some(vertex) = place.vertex(&self.surface) {
            let [place, unit] = [0.0, 1.0].map(|part| c64::new(part, 0.0));
            return vec![Support { vertex: vertex.index(), weight: 1.0, place, unit }];
        }
        let side = plane.first_side();
        let face = side.triangle();
        let weights = place.weights_in(&self.surface, face);
        let corners = self.surface.corners(face);
        let x = triangle::unit(corners[1] - corners[0]);
        let axes = [x, self.surface.face_normal(face).cross(x)];
        let flat = |vector: DVec3| c64::new(vector.dot(axes[0]), vector.dot(axes[1]));
        let middle = place.position(&self.surface);
        let support = |k: usize| {
            let along = face.halfedge(k);
            let away = flat(corners[k] - middle);
            let vertex = self.surface.mesh().vertex(along);
            let departure = plane.angle(&Heading { side: side.0, direction: away });
            let back = Heading { side: along.0, direction: -away / flat(corners[(k + 1) % 3] - corners[k]) };
            let arrival = Plane::of_fan(geometry, vertex).angle(&back) + PI;
            Support {
                vertex: vertex.index(),
                weight: weights[k],
                place: c64::from_polar(away.norm(), departure),
                unit: c64::cis(arrival - departure),
            }
        };
        (0..3).filter(|&k| weights[k] > 0.0).map(support).collect()
    }
}
