//! The search itself: waves offered from vertex to vertex, nearest first.

mod seen;

use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

use glam::DVec3;

use super::medium::{AROUND, Medium};
use super::refraction::arrival;
use super::wave::Wave;
use crate::mesh::{NONE, TetMesh};
use crate::point::{TetPoint, TetSource};

/// A distance replaces another if it is below it by this share: rounding must not send waves around for ever.
const GAIN: f64 = 1e-9;

/// Waves at the ends of an edge are one if what one of them makes of the other end misses the distance there by less than this
/// share of the edge. Elsewhere they meet, or one is in the shadow of something.
const SMOOTH: f64 = 0.05;

/// Waves that a vertex remembers to have been offered: one offer says all.
const REMEMBERED: usize = 4;

/// What a vertex that gets its distance, a distance that is computed for an offer, and an offer that waits count as work: as many faces
/// are passed in the time.
const SETTLED: usize = 8;
const COMPUTED: usize = 1;
const OFFERED: usize = 1;

/// Work for each tetrahedron, at most, and in all where the mesh is small: where most waves are in the way of something.
const MOST_WORK: usize = 512;
const LEAST_WORK: usize = 4_000_000;

/// An offer: the distance as bits, which order as positive numbers do, vertex, wave.
type Offer = Reverse<(u64, u32, u32)>;

/// A march in work.
pub(crate) struct Search<'a> {
    mesh: &'a TetMesh,
    medium: &'a Medium,
    pub(super) waves: Vec<Wave>,
    pub(super) distances: Vec<f64>,
    /// The wave that each vertex has its distance from; [`NONE`] where it is refracted, or there is none.
    pub(super) wave_of: Vec<u32>,
    offered: Vec<[u32; REMEMBERED]>,
    offers: BinaryHeap<Offer>,
    /// Vertices that got a distance since edges were looked at, see [`Search::relax`].
    settled: Vec<u32>,
    /// Whether waves come straight to vertices that are on the way of long lines, see `seen`.
    shown: HashMap<(u32, u32), bool>,
    /// To how many of these they do not.
    hidden: usize,
    is_uniform: bool,
    /// Done so far, see [`super::March::advance`].
    work: usize,
    /// How much is done at most; then all ends [along edges](Search::end_along_edges).
    pub(super) most_work: usize,
}

impl<'a> Search<'a> {
    pub(super) fn new(mesh: &'a TetMesh, medium: &'a Medium) -> Self {
        let vertices = mesh.vertex_count();
        Self {
            mesh,
            medium,
            waves: Vec::new(),
            distances: vec![f64::INFINITY; vertices],
            wave_of: vec![NONE; vertices],
            offered: vec![[NONE; REMEMBERED]; vertices],
            offers: BinaryHeap::new(),
            settled: Vec::new(),
            shown: HashMap::new(),
            hidden: 0,
            is_uniform: medium.is_uniform(),
            work: 0,
            most_work: (MOST_WORK * mesh.tetrahedron_count()).max(LEAST_WORK),
        }
    }

    /// Starts waves at a source.
    pub(super) fn start(&mut self, source: &TetSource) {
        let (place, initial) = (source.point.position(self.mesh), source.initial_distance);
        match source.point {
            TetPoint::Vertex(vertex) => self.start_at(vertex.0, initial),
            TetPoint::Inside { tetrahedron, .. } => {
                let cost = self.medium.cost(tetrahedron.0);
                let wave = self.add(Wave::from_place(place, initial, cost, None));
                for vertex in self.mesh.tetrahedra()[tetrahedron.index()] {
                    self.offer(wave, vertex);
                }
            }
        }
    }

    /// One wave for each cost around a vertex.
    fn start_at(&mut self, vertex: u32, initial: f64) {
        let around = self.mesh.around().row(vertex);
        let mut costs: Vec<f64> = around.iter().map(|&tetrahedron| self.medium.cost(tetrahedron)).collect();
        costs.retain(|cost| cost.is_finite());
        costs.sort_unstable_by(f64::total_cmp);
        costs.dedup();
        for cost in costs {
            let place = self.mesh.positions()[vertex as usize];
            let wave = self.add(Wave::from_place(place, initial, cost, None));
            self.offer(wave, vertex);
        }
    }

    fn add(&mut self, wave: Wave) -> u32 {
        self.waves.push(wave);
        (self.waves.len() - 1) as u32
    }

    /// As [`super::March::advance`].
    pub(super) fn advance(&mut self, radius: f64, work: usize) -> f64 {
        loop {
            self.spread(radius, work);
            self.relax();
            match self.front() {
                f64::INFINITY => return f64::INFINITY,
                front if front >= radius || self.work >= work => return front.min(radius),
                _ => {}
            }
        }
    }

    /// The least distance offered, infinity where nothing is.
    fn front(&self) -> f64 {
        self.offers.peek().map_or(f64::INFINITY, |&Reverse((distance, ..))| f64::from_bits(distance))
    }

    /// Goes on along edges alone (Dijkstra 1959): one step for each edge, whatever is in the way of lines.
    pub(super) fn end_along_edges(&mut self) {
        self.offers.clear();
        let mesh = self.mesh;
        let known = (0..).zip(&self.distances).filter(|(_, distance)| distance.is_finite());
        let mut queue: BinaryHeap<Reverse<(u64, u32)>> =
            known.map(|(vertex, distance)| Reverse((distance.to_bits(), vertex))).collect();
        while let Some(Reverse((bits, from))) = queue.pop() {
            let distance = f64::from_bits(bits);
            if distance > self.distances[from as usize] {
                continue;
            }
            self.go_along_edges(from, mesh.adjacent().row(from), |search, vertex, through, wave| {
                search.distances[vertex as usize] = through;
                search.wave_of[vertex as usize] = wave;
                queue.push(Reverse((through.to_bits(), vertex)));
            });
        }
    }

    /// Accepts offers below `radius`, nearest first, until there are none or so much work is done.
    fn spread(&mut self, radius: f64, work: usize) {
        while self.front() < radius && self.work < work {
            let Some(Reverse((distance, vertex, wave))) = self.offers.pop() else { break };
            let distance = f64::from_bits(distance);
            if distance < self.distances[vertex as usize] * (1.0 - GAIN) && self.is_seen(wave, vertex) {
                let (distance, wave) = self.straightened(vertex, distance, wave);
                self.settle(vertex, distance, wave);
            }
        }
    }

    /// Offers the ways along edges wherever the distances of an edge's ends differ by more than its length: where all waves offered
    /// to a vertex are in the shadow of something, and where tetrahedra touch in a vertex only.
    fn relax(&mut self) {
        let mesh = self.mesh;
        for from in std::mem::take(&mut self.settled) {
            self.go_along_edges(from, mesh.adjacent().row(from), |search, vertex, _, wave| search.offer(wave, vertex));
        }
    }

    /// Takes each neighbor of a vertex that is nearer along the edge than its distance says, with that and the wave from the vertex.
    fn go_along_edges(&mut self, from: u32, neighbors: &[u32], mut take: impl FnMut(&mut Self, u32, f64, u32)) {
        let (mesh, least) = (self.mesh, self.medium.least_cost());
        let (start, distance) = (mesh.positions()[from as usize], self.distances[from as usize]);
        let mut wave = NONE;
        for &vertex in neighbors {
            let length = start.distance(mesh.positions()[vertex as usize]);
            let known = self.distances[vertex as usize] * (1.0 - GAIN);
            if distance + least * length >= known {
                continue;
            }
            let cost = self.least_cost_at([from, vertex]);
            let through = distance + cost * length;
            if through < known {
                if wave == NONE || self.waves[wave as usize].cost != cost {
                    wave = self.add_from(from, cost);
                }
                take(self, vertex, through, wave);
            }
        }
    }

    /// Offers a wave to a vertex.
    #[inline]
    fn offer(&mut self, wave: u32, vertex: u32) {
        let offered = &mut self.offered[vertex as usize];
        if offered.contains(&wave) {
            return;
        }
        self.work += COMPUTED;
        let distance = self.waves[wave as usize].ray(self.mesh.positions()[vertex as usize]).distance;
        if distance < self.distances[vertex as usize] * (1.0 - GAIN) {
            offered.rotate_right(1);
            offered[0] = wave;
            self.offers.push(Reverse((distance.to_bits(), vertex, wave)));
            self.work += OFFERED;
        }
    }

    /// Gives a vertex its distance and sends waves on.
    fn settle(&mut self, vertex: u32, distance: f64, wave: u32) {
        self.work += SETTLED;
        self.distances[vertex as usize] = distance;
        self.wave_of[vertex as usize] = wave;
        self.settled.push(vertex);
        let mesh = self.mesh;
        if wave != NONE {
            for &other in mesh.adjacent().row(vertex) {
                self.offer(wave, other);
            }
        }
        let concave = self.medium.concave(vertex);
        if !concave.is_empty() {
            self.bend(vertex, concave);
        }
        if !self.is_uniform {
            self.refract(vertex);
        }
    }

    /// Sends waves around the concave edges of a vertex.
    fn bend(&mut self, vertex: u32, others: &[u32]) {
        self.send_from(vertex);
        for &other in others {
            if self.work < self.most_work && self.distances[other as usize].is_finite() {
                self.bend_around([vertex, other]);
            }
        }
    }

    /// Sends waves around an edge whose ends both have distances.
    fn bend_around(&mut self, ends: [u32; 2]) {
        let positions = ends.map(|end| self.mesh.positions()[end as usize]);
        let distances = ends.map(|end| self.distances[end as usize]);
        let waves = ends.map(|end| self.wave_of[end as usize]);
        let cost = self.least_cost_at(ends);
        let initials = waves.map(|wave| if wave == NONE { 0.0 } else { self.waves[wave as usize].initial() });
        let length = positions[0].distance(positions[1]);
        // What the wave at one end makes of the other end.
        let goes_on = |end: usize| match waves[end] {
            NONE => distances[1 - end],
            wave => self.waves[wave as usize].continued(positions[1 - end]),
        };
        let is_one = waves[0] == waves[1]
            || (0..2).any(|end| (goes_on(end) - distances[1 - end]).abs() <= SMOOTH * cost * length);
        if is_one {
            let initial = if initials[0] == initials[1] { initials[0] } else { 0.0 };
            self.send_around(ends, positions, distances, initial, cost, waves);
            return;
        }
        for end in 0..2 {
            let wave = waves[end];
            if wave != NONE && self.is_seen(wave, ends[1 - end]) {
                let values = positions.map(|position| self.waves[wave as usize].ray(position).distance);
                self.send_around(ends, positions, values, initials[end], cost, [wave; 2]);
            }
        }
    }

    fn send_around(
        &mut self,
        ends: [u32; 2],
        positions: [DVec3; 2],
        distances: [f64; 2],
        initial: f64,
        cost: f64,
        parents: [u32; 2],
    ) {
        let Some(wave) = Wave::from_edge(ends, positions, distances, initial, cost) else { return };
        let wave = self.add(wave.after(parents));
        let mesh = self.mesh;
        for end in ends {
            for &target in mesh.adjacent().row(end) {
                if !ends.contains(&target) {
                    self.offer(wave, target);
                }
            }
        }
    }

    /// The wave that a wave goes on from where that comes straight to a vertex, too, and so on: where few vertices see a bend, none
    /// of the neighbors may have told of it.
    fn straightened(&mut self, vertex: u32, mut distance: f64, mut wave: u32) -> (f64, u32) {
        while wave != NONE {
            let place = self.mesh.positions()[vertex as usize];
            let parents = self.waves[wave as usize].parents;
            let shorter = parents.into_iter().filter(|&parent| parent != NONE && parent != wave).find_map(|parent| {
                let through = self.waves[parent as usize].ray(place).distance;
                (through < distance && self.is_seen(parent, vertex)).then_some((through, parent))
            });
            let Some((through, parent)) = shorter else { break };
            (distance, wave) = (through, parent);
        }
        (distance, wave)
    }

    /// The least cost around an edge, or around a vertex that is both of its ends.
    fn least_cost_at(&self, [a, b]: [u32; 2]) -> f64 {
        self.medium.uniform_cost().unwrap_or_else(|| {
            let around = self.mesh.around_edge([a, b]);
            around.map(|tetrahedron| self.medium.cost(tetrahedron)).fold(f64::INFINITY, f64::min)
        })
    }

    /// Sends a wave from a vertex.
    fn send_from(&mut self, vertex: u32) {
        let wave = self.add_from(vertex, self.least_cost_at([vertex; 2]));
        for &other in self.mesh.adjacent().row(vertex) {
            self.offer(wave, other);
        }
    }

    /// A wave that goes on from a vertex.
    fn add_from(&mut self, vertex: u32, cost: f64) -> u32 {
        let (place, distance) = (self.mesh.positions()[vertex as usize], self.distances[vertex as usize]);
        let parents = [self.wave_of[vertex as usize], NONE];
        self.add(Wave::from_place(place, distance, cost, Some(vertex)).after(parents))
    }

    /// Offers distances through the tetrahedra around a vertex.
    fn refract(&mut self, vertex: u32) {
        let mesh = self.mesh;
        let around = mesh.around().row(vertex);
        self.work += around.len() / AROUND;
        for &tetrahedron in around {
            let cost = self.medium.cost(tetrahedron);
            if cost.is_infinite() {
                continue;
            }
            let corners = mesh.tetrahedra()[tetrahedron as usize];
            let points = corners.map(|corner| mesh.positions()[corner as usize]);
            let known = corners.map(|corner| self.distances[corner as usize]);
            for target in (0..4).filter(|&corner| corners[corner] != vertex) {
                let distance = arrival(points, known, target, cost);
                if distance < self.distances[corners[target] as usize] * (1.0 - super::refraction::MARGIN) {
                    self.offers.push(Reverse((distance.to_bits(), corners[target], NONE)));
                }
            }
        }
    }
}
