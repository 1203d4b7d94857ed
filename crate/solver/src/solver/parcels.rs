//! Distances between parcels of a surface.

use std::num::NonZeroUsize;

use heatwalk_sparse::Progress;
use heatwalk_surface::{Place, VertexId};

use super::{Answer, DistanceOptions, DistanceSolver};
use crate::error::Result;

/// Which distance two sets of vertices have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ParcelDistance {
    /// The mean over all pairs of a vertex of the one and a vertex of the other; of a set and itself, each vertex is paired with itself, too.
    #[default]
    Mean,
    /// The least over these pairs.
    Minimum,
}

impl DistanceSolver {
    /// The distance of each of P `parcels` from each, `P × P` row by row, in the file's unit. Infinite between parcels of which a pair is not connected,
    /// for the mean, or no pair, for the least; and of a parcel without a vertex. Vertices inside of walls do not count. A mean takes an answer from each vertex of all parcels, made
    /// by so many threads, with the same values to the last bit; the least takes one from each parcel.
    ///
    /// # Errors
    /// As [`Self::distance`].
    pub fn parcel_distances(
        &mut self,
        parcels: &[Vec<VertexId>],
        distance: ParcelDistance,
        (options, threads): (&DistanceOptions, NonZeroUsize),
        progress: Progress<'_>,
    ) -> Result<Vec<f64>> {
        let is_open = |vertex: &VertexId| !self.surface.is_in_wall(Place::Vertex(*vertex));
        let open = |parcel: &Vec<VertexId>| parcel.iter().copied().filter(is_open).collect();
        let parcels: Vec<Vec<VertexId>> = parcels.iter().map(open).collect();
        let total: usize = parcels.iter().map(Vec::len).sum();
        let mut distances = Vec::with_capacity(parcels.len() * parcels.len());
        let mut before = 0;
        for parcel in &parcels {
            if parcel.is_empty() {
                distances.extend(parcels.iter().map(|_| f64::INFINITY));
                continue;
            }
            let mut told =
                |stage, share: f64| progress(stage, (before as f64 + share * parcel.len() as f64) / total as f64);
            match distance {
                ParcelDistance::Mean => {
                    let means =
                        |_: usize, answer: Answer| parcels.iter().map(|to| mean(&answer, to)).collect::<Vec<_>>();
                    let rows = self.map_from_each(parcel, options, threads, means, &mut told)?;
                    let column = |to: usize| rows.iter().map(|row| row[to]).sum::<f64>() / rows.len() as f64;
                    distances.extend((0..parcels.len()).map(column));
                }
                ParcelDistance::Minimum => {
                    let answer = self.distance(parcel, options, &mut told)?;
                    distances.extend(parcels.iter().map(|to| least(&answer, to)));
                }
            }
            before += parcel.len();
        }
        Ok(distances)
    }
}

fn mean(answer: &Answer, vertices: &[VertexId]) -> f64 {
    if vertices.is_empty() {
        return f64::INFINITY;
    }
    vertices.iter().map(|&vertex| answer.distance.values[vertex]).sum::<f64>() / vertices.len() as f64
}

fn least(answer: &Answer, vertices: &[VertexId]) -> f64 {
    vertices.iter().map(|&vertex| answer.distance.values[vertex]).fold(f64::INFINITY, f64::min)
}
