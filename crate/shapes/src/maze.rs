//! A maze: a flat road with many corners and the walls that bound it.

use glam::DVec3;
use heatwalk_surface::Soup;
use std::collections::HashMap;

use rand::{Rng, SeedableRng};
use rand_xoshiro::SplitMix64;

const ROAD_WIDTH: f64 = 1.0;
const WALL_WIDTH: f64 = 0.2;
const WALL_HEIGHT: f64 = 0.55;
const SEED: u64 = 20;
/// One in so many inner walls falls, so that places are joined by several ways.
const LOOPS: u64 = 14;

/// Part 0, "road": the plane floor, `quads` quads across its width. Part 1, "walls": blocks along its border.
/// `cells × cells` rooms, every one connected.
pub fn maze(cells: u32, quads: u32) -> Soup {
    let plan = Plan::carve(cells.max(2) as usize);
    let mut soup = Soup::default();
    add_road(&mut soup, &plan, quads.max(1) as usize);
    soup.end_part("road");
    add_walls(&mut soup, &plan);
    soup.end_part("walls");
    soup
}

/// Tiles in rows and columns; odd ones are rooms, even ones the walls and gates between them.
struct Plan {
    size: usize,
    open: Vec<bool>,
}

impl Plan {
    fn is_open(&self, column: usize, row: usize) -> bool {
        self.open[row * self.size + column]
    }

    /// Depth-first search with backtracking over the rooms, then some walls opened for loops.
    fn carve(cells: usize) -> Self {
        let size = 2 * cells + 1;
        let mut plan = Self { size, open: vec![false; size * size] };
        let mut random = SplitMix64::seed_from_u64(SEED);
        let mut stack = vec![(1_usize, 1_usize)];
        plan.open[size + 1] = true;
        while let Some(&(column, row)) = stack.last() {
            let closed: Vec<(usize, usize)> =
                [(column + 2, row), (column.wrapping_sub(2), row), (column, row + 2), (column, row.wrapping_sub(2))]
                    .into_iter()
                    .filter(|&(column, row)| column < size && row < size && !plan.is_open(column, row))
                    .collect();
            if closed.is_empty() {
                stack.pop();
                continue;
            }
            let next = closed[random.next_u64() as usize % closed.len()];
            plan.open[(row + next.1) / 2 * size + (column + next.0) / 2] = true;
            plan.open[next.1 * size + next.0] = true;
            stack.push(next);
        }
        for row in 1..size - 1 {
            for column in 1..size - 1 {
                // Posts, where both are even, stay: an opened one would touch the road at a corner only.
                if (row + column) % 2 == 1 && random.next_u64().is_multiple_of(LOOPS) {
                    plan.open[row * size + column] = true;
                }
            }
        }
        plan
    }

    fn width(tile: usize) -> f64 {
        if tile.is_multiple_of(2) { WALL_WIDTH } else { ROAD_WIDTH }
    }

    /// Where the tile begins; the maze is centred at 0.
    fn start(&self, tile: usize) -> f64 {
        let at = |tile: usize| (tile / 2) as f64 * (ROAD_WIDTH + WALL_WIDTH) + (tile % 2) as f64 * WALL_WIDTH;
        at(tile) - at(self.size) / 2.0
    }
}

fn add_road(soup: &mut Soup, plan: &Plan, quads: usize) {
    // Gates are narrower than rooms, so they get fewer quads of about the same size.
    let gate_quads = ((quads as f64 * WALL_WIDTH / ROAD_WIDTH).round() as usize).max(1);
    let lines: Vec<(usize, f64)> = (0..plan.size)
        .flat_map(|tile| {
            let count = if tile.is_multiple_of(2) { gate_quads } else { quads };
            let (start, width) = (plan.start(tile), Plan::width(tile));
            (0..count).map(move |i| (tile, start + width * i as f64 / count as f64))
        })
        .chain([(plan.size, plan.start(plan.size))])
        .collect();
    let mut vertices = HashMap::new();
    for (row, pair) in lines.windows(2).enumerate() {
        for (column, _) in lines.windows(2).enumerate() {
            if !plan.is_open(lines[column].0, pair[0].0) {
                continue;
            }
            let mut vertex = |column: usize, row: usize| {
                *vertices.entry((column, row)).or_insert_with(|| {
                    soup.positions.push(DVec3::new(lines[column].1, 0.0, lines[row].1));
                    soup.positions.len() as u32 - 1
                })
            };
            let [a, b] = [vertex(column, row), vertex(column, row + 1)];
            let [c, d] = [vertex(column + 1, row + 1), vertex(column + 1, row)];
            let even = (row + column) % 2 == 0;
            soup.triangles.extend(if even { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
        }
    }
}

/// A top for every closed tile and a side wherever it meets the road or the outside; the ground side stays open.
fn add_walls(soup: &mut Soup, plan: &Plan) {
    let closed = |column: usize, row: usize| column < plan.size && row < plan.size && !plan.is_open(column, row);
    let mut vertices = HashMap::new();
    for row in 0..plan.size {
        for column in (0..plan.size).filter(|&column| closed(column, row)) {
            let mut vertex = |column: usize, row: usize, top: bool| {
                *vertices.entry((column, row, top)).or_insert_with(|| {
                    let height = if top { WALL_HEIGHT } else { 0.0 };
                    soup.positions.push(DVec3::new(plan.start(column), height, plan.start(row)));
                    soup.positions.len() as u32 - 1
                })
            };
            // Corners counter-clockwise seen from above, and the tile beyond the side that starts there.
            let corners = [(column, row), (column, row + 1), (column + 1, row + 1), (column + 1, row)];
            let beyond =
                [(column.wrapping_sub(1), row), (column, row + 1), (column + 1, row), (column, row.wrapping_sub(1))];
            let [a, b, c, d] = corners.map(|(column, row)| vertex(column, row, true));
            soup.triangles.extend([[a, b, c], [a, c, d]]);
            for side in 0..4 {
                if closed(beyond[side].0, beyond[side].1) {
                    continue;
                }
                let [(from_column, from_row), (to_column, to_row)] = [corners[side], corners[(side + 1) % 4]];
                let [a, b] = [vertex(from_column, from_row, true), vertex(to_column, to_row, true)];
                let [c, d] = [vertex(to_column, to_row, false), vertex(from_column, from_row, false)];
                soup.triangles.extend([[a, d, c], [a, c, b]]);
            }
        }
    }
}
