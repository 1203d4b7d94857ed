//! A mesh for `npm run bench`: welded, clean and perhaps subdivided, as binary PLY, so that the same numbers name the
//! same vertices to all programs. Prints what it is, as JSON.
//!
//! `cargo run --release -p heatwalk --example bench_mesh -- MESH|preset:SHAPE|icosphere:K|hemisphere:K OUT.ply [SUBDIVISIONS]`
//!
//! An icosphere has 20 · 4ᴷ triangles, a hemisphere 4 K²; a subdivision cuts each triangle into four.

use std::collections::HashMap;
use std::error::Error;
use std::fs;
use std::path::Path;

use heatwalk::{Element, FaceId, Soup, Surface, VertexId};
use heatwalk_model::io;
use heatwalk_shapes as shapes;
use serde_json::json;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [input, output, subdivisions @ ..] = arguments.as_slice() else {
        return Err("give a mesh and a file to write".into());
    };
    let surface = Surface::build(&read(input)?)?;
    let mut mesh = in_input_order(input, &surface);
    for _ in 0..subdivisions.first().map_or(Ok(0), |count| count.parse())? {
        mesh = subdivided(mesh);
    }
    fs::write(output, io::write::distance_ply(&mesh, &vec![0.0; mesh.positions.len()]))?;
    println!(
        "{}",
        json!({
            "vertices": mesh.positions.len(),
            "triangles": mesh.triangles.len(),
            "components": surface.report().components,
            "boundary_loops": surface.report().boundary_loops,
            "oriented_manifold": surface.is_oriented_manifold(),
        })
    );
    Ok(())
}

/// The surface as a soup, in the order of its file: what a surface gains by another one is no gain of the file's.
fn in_input_order(name: &str, surface: &Surface) -> Soup {
    let mut vertices: Vec<VertexId> = surface.vertices().collect();
    vertices.sort_unstable_by_key(|&vertex| surface.inputs_of_vertex(vertex)[0]);
    let mut number = vec![0; vertices.len()];
    vertices.iter().zip(0..).for_each(|(vertex, new)| number[vertex.index()] = new);
    let corners = |face: FaceId| surface.faces()[face].map(|vertex| number[vertex.index()]);
    let positions = vertices.iter().map(|&vertex| surface.position(vertex)).collect();
    Soup::single(name, positions, surface.faces_in_input_order().map(corners).collect())
}

fn read(input: &str) -> Result<Soup, Box<dyn Error>> {
    Ok(match input.split_once(':') {
        Some(("icosphere", level)) => shapes::icosphere(level.parse()?),
        Some(("preset", name)) => shapes::by_name(name)?.soup.select(&[0])?,
        // Part 1 is the stand.
        Some(("hemisphere", frequency)) => shapes::hemisphere(frequency.parse()?).select(&[0])?,
        _ => io::read(input, &fs::read(input)?, &|uri| fs::read(Path::new(input).with_file_name(uri)).ok())?.soup,
    })
}

/// Each triangle cut into four at the middles of its edges.
fn subdivided(mesh: Soup) -> Soup {
    let mut positions = mesh.positions;
    let mut middles = HashMap::new();
    let mut triangles = Vec::with_capacity(4 * mesh.triangles.len());
    for [a, b, c] in mesh.triangles {
        let [ab, bc, ca] = [[a, b], [b, c], [c, a]].map(|[p, q]| {
            *middles.entry([p.min(q), p.max(q)]).or_insert_with(|| {
                positions.push(0.5 * (positions[p as usize] + positions[q as usize]));
                positions.len() as u32 - 1
            })
        });
        triangles.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
    }
    Soup::single("subdivided", positions, triangles)
}
