//! How an index is made: a search from each vertex, as far as its part goes.

use std::num::NonZeroUsize;
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use heatwalk::exact::{ExactGeometry, Wavefront};
use heatwalk::sparse::{Part, Pattern, Separators};
use heatwalk::surface::scale::scale;
use heatwalk::{Element, Progress, Stage, Surface, VertexId};

use crate::error::Result;
use crate::tree::{NONE, Tree};
use crate::{DistanceIndex, file};

/// Vertices up to which a part is not parted further; they have the distances to each other.
const LEAF: usize = 48;

/// Windows that cross before it is looked whether a search has gone far enough: so many for each vertex of its part, and these at least.
const WORK_PER_VERTEX: usize = 4;
const LEAST_WORK: usize = 512;

impl DistanceIndex {
    /// Of a surface, without what would join its components. So many threads search, with the same labels to the last bit.
    ///
    /// # Errors
    /// [`heatwalk::Error::OutOfMemory`]; [`heatwalk::Error::Cancelled`].
    pub fn build(surface: &Arc<Surface>, threads: NonZeroUsize, progress: Progress<'_>) -> Result<Self> {
        let Separators { order, parts } = Separators::of(&pattern(surface)?, LEAF);
        let tree = Tree::of_parts(&parts);
        let geometry = Arc::new(ExactGeometry::on_threads(Arc::clone(surface), threads));
        let mut labels = Vec::new();
        labels
            .try_reserve_exact(tree.label_count())
            .map_err(|_| heatwalk::Error::OutOfMemory { stage: "making labels" })?;
        labels.resize(tree.label_count(), f32::INFINITY);
        let coordinates = surface.positions().iter().flat_map(|position| position.to_array());
        let shrink = scale(coordinates.map(f64::abs).fold(0.0, f64::max));
        let search = Search { geometry: &geometry, order: &order, parts: &parts, tree: &tree, shrink };
        let labels = search.all(labels, threads, progress)?;
        let mut place_of_vertex = vec![NONE; surface.vertex_count()];
        for (place, &vertex) in (0..).zip(&order) {
            place_of_vertex[vertex as usize] = place;
        }
        let inputs = surface.vertices_of_inputs();
        let place_of_input = inputs.iter().map(|vertex| vertex.map_or(NONE, |vertex| place_of_vertex[vertex.index()]));
        // Those that are not parted further separate nothing.
        let is_between = |vertex: VertexId| {
            let part = parts[tree.part_of(place_of_vertex[vertex.index()] as usize)];
            part.start < part.separator
        };
        let longest = order.iter().map(|&vertex| longest_edge(surface, VertexId(vertex), is_between, shrink));
        Ok(Self {
            fingerprint: file::fingerprint(surface),
            place_of_input: place_of_input.collect(),
            longest: longest.collect(),
            tree,
            unit: shrink.recip(),
            labels,
        })
    }
}

/// The graph of vertices and edges.
fn pattern(surface: &Surface) -> Result<Pattern> {
    let (mut start, mut rows) = (vec![0], Vec::new());
    for vertex in surface.vertices() {
        let mut column: Vec<u32> =
            surface.neighbours(vertex).map(|other| other.0).filter(|&other| other > vertex.0).collect();
        column.sort_unstable();
        column.dedup();
        rows.push(vertex.0);
        rows.extend(column);
        start.push(rows.len() as u32);
    }
    Ok(Pattern::new(start, rows).map_err(heatwalk::Error::from)?)
}

/// Of the edges to some vertices, rounded up.
fn longest_edge(surface: &Surface, vertex: VertexId, is_wanted: impl Fn(VertexId) -> bool, shrink: f64) -> f32 {
    let position = surface.position(vertex);
    let others = surface.neighbours(vertex).filter(|&other| is_wanted(other));
    let lengths = others.map(|other| (shrink * (surface.position(other) - position)).length());
    (lengths.fold(0.0, f64::max) as f32).next_up()
}

struct Search<'a> {
    geometry: &'a Arc<ExactGeometry>,
    order: &'a [u32],
    parts: &'a [Part],
    tree: &'a Tree,
    /// What lengths are multiplied by, so that labels are near 1.
    shrink: f64,
}

impl Search<'_> {
    /// Fills in the labels. Searches of the largest parts come first, so that threads end together.
    fn all(&self, labels: Vec<f32>, threads: NonZeroUsize, progress: Progress<'_>) -> Result<Vec<f32>> {
        let labels = Mutex::new(labels);
        let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
        let work = |tell: &mut dyn FnMut(f64) -> ControlFlow<()>| -> Result<()> {
            let mut kept = None;
            let mut row = Vec::new();
            while !is_over.load(Ordering::Relaxed) {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some(place) = (self.order.len() - 1).checked_sub(number) else { break };
                let mut go_on = || match tell(number as f64 / self.order.len() as f64) {
                    ControlFlow::Continue(()) if !is_over.load(Ordering::Relaxed) => Ok(()),
                    _ => Err(heatwalk::Error::Cancelled),
                };
                let found = self.one(place, (&mut kept, &mut row), &mut go_on);
                found.inspect_err(|_| is_over.store(true, Ordering::Relaxed))?;
                let mut labels = labels.lock().unwrap_or_else(PoisonError::into_inner);
                let label = self.tree.label_of(place);
                let below = self.parts[self.tree.part_of(place)].start..;
                for (place, &distance) in below.zip(&row) {
                    labels[self.tree.labels_of(place).start + label] = distance;
                }
            }
            Ok(())
        };
        thread::scope(|scope| {
            let work = &work;
            let others: Vec<_> =
                (1..threads.get()).map(|_| scope.spawn(move || work(&mut |_| ControlFlow::Continue(())))).collect();
            let first = work(&mut |share| progress(Stage::Answering, share));
            // A panic there is one here.
            let others =
                others.into_iter().map(|other| other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
            others.fold(first, |first, other| first.and(other))
        })?;
        Ok(labels.into_inner().unwrap_or_else(PoisonError::into_inner))
    }

    /// Distances from the vertex of a place to all of its part, in the memory of an earlier search.
    fn one(
        &self,
        place: usize,
        (kept, row): (&mut Option<Wavefront>, &mut Vec<f32>),
        go_on: &mut dyn FnMut() -> heatwalk::Result<()>,
    ) -> Result<()> {
        let source = [VertexId(self.order[place])];
        let front = match kept {
            Some(front) => {
                front.restart(&source)?;
                front
            }
            None => kept.insert(Wavefront::new(Arc::clone(self.geometry), &source)?),
        };
        let part = self.parts[self.tree.part_of(place)];
        let vertices = &self.order[part.start..part.end];
        let farthest =
            |front: &Wavefront| vertices.iter().map(|&vertex| front.values()[VertexId(vertex)]).fold(0.0, f64::max);
        let work = LEAST_WORK.max(WORK_PER_VERTEX * vertices.len());
        while !front.is_done() && farthest(front) >= front.radius() {
            go_on()?;
            front.advance(f64::INFINITY, work)?;
        }
        row.clear();
        row.extend(vertices.iter().map(|&vertex| (self.shrink * front.values()[VertexId(vertex)]) as f32));
        Ok(())
    }
}
