//! Shortest paths inside of a mesh.
//!
//! A march's path goes back along its waves, straight from bend to bend. Any other descends the distance from tetrahedron to
//! tetrahedron. It is then pulled taut where costs do not change.

mod descent;

use glam::DVec3;

use crate::corner::Corner;
use crate::distance::VolumeDistance;
use crate::error::{Error, Result};
use crate::march::{March, Medium, Origins, Waves, pull};
use crate::mesh::{MeshId, Start, TetMesh};
use crate::point::{TetPoint, TetSource};
use descent::Descent;

/// Bends of a path, at most: more than there are concave edges on any way.
const MOST_BENDS: usize = 1 << 20;

/// A piecewise straight curve inside of a mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct VolumePath {
    mesh: MeshId,
    /// From the start to the source, both included; where they are one, one point.
    pub points: Vec<DVec3>,
    /// In the file's unit.
    pub length: f64,
    /// Length by the costs that it goes through; the length itself where all are 1.
    pub cost: f64,
    /// What each unit of length costs between each point and the next.
    pub costs: Vec<f64>,
}

impl VolumePath {
    fn along(mesh: &TetMesh, corners: &[Corner]) -> Self {
        let legs = || corners.windows(2).map(|ends| (ends[0].place.distance(ends[1].place), ends[0].cost));
        Self {
            mesh: mesh.id(),
            length: 0.0 + legs().map(|(length, _)| length).sum::<f64>(),
            cost: 0.0 + legs().map(|(length, cost)| length * cost).sum::<f64>(),
            costs: legs().map(|(_, cost)| cost).collect(),
            // Adding 0 makes −0 to 0.
            points: corners.iter().map(|corner| corner.place + DVec3::ZERO).collect(),
        }
    }

    /// The mesh that it is in.
    pub fn mesh(&self) -> MeshId {
        self.mesh
    }
}

/// The path from a place that was checked.
pub(crate) fn find(mesh: &TetMesh, medium: &Medium, distance: &VolumeDistance, from: TetPoint) -> Result<VolumePath> {
    if from.support(mesh).any(|(vertex, _)| distance.values[vertex.0 as usize].is_infinite()) {
        return Err(Error::Unreachable);
    }
    if let Some(corners) = distance.origins.as_ref().and_then(|origins| origins.path(mesh, medium, from)) {
        return Ok(VolumePath::along(mesh, &corners));
    }
    let mut corners = vec![from.corner(mesh)];
    // Where distance is refracted there is no wave to go back along, but there is one again in the medium of the source.
    let waves = distance.origins.as_ref().and_then(Origins::waves);
    while !waves.is_some_and(|waves| go_back(mesh, medium, waves, &mut corners)) {
        match descent::go_down(mesh, medium, distance, &mut corners) {
            Descent::Arrived => break,
            Descent::Continues => {}
            Descent::Stuck => {
                // Distance by heat may have a lowest place that is no source.
                let sources: Vec<TetSource> = distance.sources.iter().map(|&source| source.into()).collect();
                let origins = March::new(mesh, medium, &sources).within(f64::INFINITY).origins;
                if let Some(path) = origins.path(mesh, medium, from) {
                    corners = path;
                } else if let Some(waves) = origins.waves() {
                    go_back(mesh, medium, waves, &mut corners);
                }
                break;
            }
        }
    }
    // Waves know of a source where it is, not what it is in.
    if let Some(last) = corners.last_mut()
        && let Some(source) = distance.sources.iter().find(|source| source.position(mesh) == last.place)
    {
        last.start = source.corner(mesh).start;
    }
    pull(mesh, medium, &mut corners);
    Ok(VolumePath::along(mesh, &corners))
}

/// Goes back along the waves of a march. Returns whether it arrived.
fn go_back(mesh: &TetMesh, medium: &Medium, waves: &Waves, corners: &mut Vec<Corner>) -> bool {
    for _ in 0..MOST_BENDS {
        let Some(&Corner { place, start, .. }) = corners.last() else { return false };
        let near: Vec<u32> = match start {
            Start::Vertex(vertex) => vec![vertex],
            Start::Edge(ends) => ends.to_vec(),
            Start::Inside(tetrahedron) => mesh.tetrahedra()[tetrahedron as usize].to_vec(),
        };
        let Some(leg) = waves.leg(mesh, medium, place, start, near.into_iter()) else { return false };
        corners.last_mut().expect("there is a last").cost = leg.cost;
        // The path ends where there is none.
        let start = leg.start.unwrap_or(start);
        if leg.to != place {
            corners.push(Corner { place: leg.to, start, cost: leg.cost });
        } else if let Some(last) = corners.last_mut() {
            last.start = start;
        }
        if leg.start.is_none() {
            return true;
        }
    }
    false
}
