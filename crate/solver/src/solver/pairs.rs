//! Distances of pairs of places.

use std::collections::HashMap;
use std::num::NonZeroUsize;
use std::sync::Arc;

use heatwalk_sparse::{Progress, Stage, report};
use heatwalk_surface::{Place, Source, SurfacePoint};

use super::{DistanceSolver, questions};
use crate::error::{Error, Result};
use crate::exact::{ExactGeometry, WORK_BETWEEN_CALLS, Wavefront};

/// A place by its bits, which are the same where the place is.
type Key = [u64; 4];

impl DistanceSolver {
    /// The exact distance of each pair of places, in the file's unit, in their order; infinite where none is reached from the other. A search
    /// begins once at each place that comes first, or second if these are fewer, and ends at the farthest that it is paired with. So many
    /// threads search, with the same results to the last bit.
    ///
    /// # Errors
    /// [`Error::NotExact`] where faces have different costs; [`Error::Surface`] for places of another surface; [`Error::OutOfMemory`];
    /// [`Error::Cancelled`].
    ///
    /// # Panics
    /// As [`Self::distances_from_each`].
    pub fn distances_of_pairs(
        &mut self,
        pairs: &[[SurfacePoint; 2]],
        threads: NonZeroUsize,
        progress: Progress<'_>,
    ) -> Result<Vec<f64>> {
        for place in pairs.iter().flatten() {
            self.surface().require_own(place.surface(), "place")?;
        }
        if self.several_costs().is_some() {
            return Err(Error::NotExact);
        }
        let (geometry, cost) = self.asked();
        let [firsts, seconds] = [0, 1].map(|end| groups(pairs, end));
        let (begin, groups) = if seconds.len() < firsts.len() { (1, seconds) } else { (0, firsts) };
        let answer = |kept: &mut Option<Wavefront>, group: usize, within: Progress<'_>| {
            let group = &groups[group];
            let source = Source::from(pairs[group[0]][begin]);
            let targets: Vec<Place> = group.iter().map(|&pair| pairs[pair][1 - begin].place()).collect();
            let front = search(kept.take(), &geometry, (source, &targets), within)?;
            let distances: Vec<f64> = front.target_values().iter().map(|distance| distance * cost).collect();
            *kept = Some(front);
            Ok(distances)
        };
        let mut distances = vec![f64::INFINITY; pairs.len()];
        let threads = threads.get().min(groups.len());
        if threads == 0 {
            return Ok(distances);
        }
        let mut kept: Vec<Option<Wavefront>> = (0..threads).map(|_| None).collect();
        let found = questions::answers(&mut kept, groups.len(), answer, progress)?;
        for (&pair, distance) in groups.iter().flatten().zip(found.into_iter().flatten()) {
            distances[pair] = distance;
        }
        Ok(distances)
    }
}

/// The numbers of the pairs that have one place at this end, in the order of their first ones.
fn groups(pairs: &[[SurfacePoint; 2]], end: usize) -> Vec<Vec<usize>> {
    let mut number_of: HashMap<Key, usize> = HashMap::new();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (number, pair) in pairs.iter().enumerate() {
        let group = *number_of.entry(key(pair[end].place())).or_insert(groups.len());
        if group == groups.len() {
            groups.push(Vec::new());
        }
        groups[group].push(number);
    }
    groups
}

fn key(place: Place) -> Key {
    match place {
        Place::Vertex(vertex) => [0, u64::from(vertex.0), 0, 0],
        Place::Edge { halfedge, fraction } => [1, u64::from(halfedge.0), fraction.to_bits(), 0],
        // The third weight follows from the others.
        Place::Face { face, weights: [a, b, _] } => [2, u64::from(face.0), a.to_bits(), b.to_bits()],
    }
}

/// A wavefront that has passed all targets, in the memory of another one.
fn search(
    kept: Option<Wavefront>,
    geometry: &Arc<ExactGeometry>,
    (source, targets): (Source, &[Place]),
    progress: Progress<'_>,
) -> Result<Wavefront> {
    let mut front = match kept {
        Some(mut front) => {
            front.restart_to(vec![source], targets);
            front
        }
        None => Wavefront::of_checked(Arc::clone(geometry), vec![source], targets)?,
    };
    while !front.is_done() && front.target_values().iter().any(|&distance| front.radius() <= distance) {
        report(progress, Stage::Searching { radius: front.radius() }, 0.0)?;
        front.advance(f64::INFINITY, WORK_BETWEEN_CALLS)?;
    }
    Ok(front)
}
