//! Rows of a matrix of distances.

use std::num::NonZeroUsize;

use heatwalk_sparse::Progress;
use heatwalk_surface::{InputPlace, Soup, Surface, SurfacePoint, VertexId};

use super::{Answer, DistanceOptions, DistanceSolver};
use crate::error::Result;

/// The place of a source of a matrix. None for a vertex that no face uses, which is as far from all as what nothing reaches.
///
/// # Errors
/// As [`InputPlace::on`] for all others.
pub fn row_source(place: InputPlace, soup: &Soup, surface: &Surface) -> Result<Option<SurfacePoint>> {
    match place {
        InputPlace::Vertex(vertex) if surface.vertices_of_inputs().as_slice().get(vertex) == Some(&None) => Ok(None),
        place => Ok(Some(place.on(soup, surface)?)),
    }
}

impl DistanceSolver {
    /// Rows of a matrix: distances of the `targets` from each source by itself. `row` is told its number and its values, in the file's unit,
    /// and nothing else is kept of it than what it makes of these. Values are infinite where nothing is reached, as is a whole row without a
    /// source, and a column without a vertex. So many threads make the rows, with the same values to the last bit.
    ///
    /// # Errors
    /// As [`Self::distance`], and then for all.
    ///
    /// # Panics
    /// As [`Self::distances_from_each`].
    pub fn map_rows<T: Send>(
        &mut self,
        sources: &[Option<SurfacePoint>],
        targets: &[Option<VertexId>],
        (options, threads): (&DistanceOptions, NonZeroUsize),
        row: impl Fn(usize, &[f64]) -> T + Sync,
        progress: Progress<'_>,
    ) -> Result<Vec<T>> {
        let numbered = sources.iter().enumerate().filter_map(|(number, source)| Some((number, (*source)?)));
        let (numbers, points): (Vec<usize>, Vec<SurfacePoint>) = numbered.unzip();
        let values = |answer: &Answer| -> Vec<f64> {
            let value =
                |target: &Option<VertexId>| target.map_or(f64::INFINITY, |vertex| answer.distance.values[vertex]);
            targets.iter().map(value).collect()
        };
        let map = |reached: usize, answer: Answer| row(numbers[reached], &values(&answer));
        let found =
            if points.is_empty() { Vec::new() } else { self.map_from_each(&points, options, threads, map, progress)? };
        let mut found = found.into_iter();
        let empty = vec![f64::INFINITY; if numbers.len() < sources.len() { targets.len() } else { 0 }];
        let own = |(number, source): (usize, &Option<SurfacePoint>)| match source {
            Some(_) => found.next(),
            None => Some(row(number, &empty)),
        };
        Ok(sources.iter().enumerate().filter_map(own).collect())
    }
}
