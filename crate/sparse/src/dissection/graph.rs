//! Graphs with weighted vertices, their parts and their contractions.

use crate::pattern::{NONE, Pattern};

/// An undirected graph. Every edge is in the lists of both its ends; none joins a vertex to itself.
#[derive(Debug)]
pub(crate) struct Graph {
    /// `#V + 1`, where the neighbours of each vertex begin.
    start: Vec<u32>,
    neighbours: Vec<u32>,
    /// `#V`, how many unknowns each vertex stands for.
    weight: Vec<u32>,
    total: u32,
}

impl Graph {
    /// The graph of a symmetric matrix.
    pub(crate) fn of_lower_triangle(pattern: &Pattern) -> Self {
        let size = pattern.size();
        let edges = || {
            (0..size).flat_map(|column| {
                let below = pattern.column(column).skip(1);
                below.map(move |entry| (pattern.rows()[entry], column as u32))
            })
        };
        let mut start = vec![0; size + 1];
        for (row, column) in edges() {
            start[row as usize + 1] += 1;
            start[column as usize + 1] += 1;
        }
        for vertex in 0..size {
            start[vertex + 1] += start[vertex];
        }
        let mut free = start.clone();
        let mut neighbours = vec![0; start[size] as usize];
        for (row, column) in edges() {
            for (vertex, other) in [(row, column), (column, row)] {
                let slot = &mut free[vertex as usize];
                neighbours[*slot as usize] = other;
                *slot += 1;
            }
        }
        Self { start, neighbours, weight: vec![1; size], total: size as u32 }
    }

    fn with_capacity(vertices: usize, entries: usize) -> Self {
        let mut start = Vec::with_capacity(vertices + 1);
        start.push(0);
        Self { start, neighbours: Vec::with_capacity(entries), weight: Vec::with_capacity(vertices), total: 0 }
    }

    /// Ends the list of a vertex whose neighbours have been appended.
    fn close(&mut self, weight: u32) {
        self.start.push(self.neighbours.len() as u32);
        self.weight.push(weight);
        self.total += weight;
    }

    /// Number of vertices.
    pub(crate) fn size(&self) -> usize {
        self.weight.len()
    }

    /// The neighbours of a vertex.
    pub(crate) fn neighbours(&self, vertex: u32) -> &[u32] {
        let vertex = vertex as usize;
        &self.neighbours[self.start[vertex] as usize..self.start[vertex + 1] as usize]
    }

    /// How many unknowns a vertex stands for.
    pub(super) fn weight(&self, vertex: u32) -> u32 {
        self.weight[vertex as usize]
    }

    /// How many unknowns all vertices together stand for.
    pub(super) fn total(&self) -> u32 {
        self.total
    }

    /// The graph on some of the vertices, which are numbered as they are listed.
    pub(super) fn part(&self, vertices: &[u32]) -> Self {
        let mut number = vec![NONE; self.size()];
        for (index, &vertex) in vertices.iter().enumerate() {
            number[vertex as usize] = index as u32;
        }
        let entries = vertices.iter().map(|&vertex| self.neighbours(vertex).len()).sum();
        let mut part = Self::with_capacity(vertices.len(), entries);
        for &vertex in vertices {
            let numbers = self.neighbours(vertex).iter().map(|&other| number[other as usize]);
            part.neighbours.extend(numbers.filter(|&number| number != NONE));
            part.close(self.weight(vertex));
        }
        part
    }

    /// The graph whose vertices are clusters, each of a vertex and up to `followers` of its neighbours that together
    /// weigh no more than `heaviest`; and of each vertex its cluster.
    pub(super) fn contract(&self, followers: usize, heaviest: u32) -> (Self, Vec<u32>) {
        let mut cluster_of = vec![NONE; self.size()];
        let mut members: Vec<u32> = Vec::with_capacity(self.size());
        let mut ends = Vec::with_capacity(self.size() / 2);
        for vertex in 0..self.size() as u32 {
            if cluster_of[vertex as usize] != NONE {
                continue;
            }
            let cluster = ends.len() as u32;
            cluster_of[vertex as usize] = cluster;
            members.push(vertex);
            let full = members.len() + followers;
            let mut weight = self.weight(vertex);
            for &other in self.neighbours(vertex) {
                if cluster_of[other as usize] == NONE && weight + self.weight(other) <= heaviest {
                    cluster_of[other as usize] = cluster;
                    members.push(other);
                    weight += self.weight(other);
                    if members.len() == full {
                        break;
                    }
                }
            }
            ends.push(members.len());
        }
        let mut coarse = Self::with_capacity(ends.len(), self.neighbours.len() / 2);
        let mut met_by = vec![NONE; ends.len()];
        let mut begin = 0;
        for (cluster, &end) in ends.iter().enumerate() {
            met_by[cluster] = cluster as u32;
            for &member in &members[begin..end] {
                for &other in self.neighbours(member) {
                    let other = cluster_of[other as usize];
                    if met_by[other as usize] != cluster as u32 {
                        met_by[other as usize] = cluster as u32;
                        coarse.neighbours.push(other);
                    }
                }
            }
            coarse.close(members[begin..end].iter().map(|&member| self.weight(member)).sum());
            begin = end;
        }
        (coarse, cluster_of)
    }
}
