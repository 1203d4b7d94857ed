//! Distance from curves beside that from a point, in time, and against distance from points along the curve.
//!
//! `cargo run --release -p heatwalk --example curves -- MESH...`

use std::collections::HashSet;
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::slice::from_ref;
use std::sync::Arc;
use std::time::Instant;

use heatwalk::exact::{ExactGeometry, Wavefront, exact_distance};
use heatwalk::{
    Curve, Element, FaceId, HalfedgeId, Place, Sign, Source, Surface, VertexData, VertexId, curve_distance, go_on,
    signed_curve_distance,
};
use heatwalk_model::io;

/// Runs of each that are timed, in turn.
const RUNS: usize = 9;

/// Places that each curve goes through.
const PLACES: usize = 6;

/// Points along the curve.
const POINTS: f64 = 10_000.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!(
        "| mesh | lines | point, ms | curve / point | above points | below, by spacing² / 8 d, median / 95 % | \
         sign right, closed | a fifth missing | the same by the nearest point |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    std::env::args().skip(1).try_for_each(|path| measure(Path::new(&path)))
}

fn measure(path: &Path) -> Result<(), Box<dyn Error>> {
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new(""));
    let soup = io::read(&name, &fs::read(path)?, &|uri| fs::read(folder.join(uri)).ok())?.soup;
    let surface = Arc::new(Surface::build(&soup)?);
    let geometry = Arc::new(ExactGeometry::new(Arc::clone(&surface)));
    let main = surface.component(surface.faces()[FaceId(0)][0]);
    let faces: Vec<FaceId> =
        surface.faces().ids().filter(|&face| surface.component(surface.faces()[face][0]) == main).collect();
    let place = |k: usize| Place::Face { face: faces[k * 7919 * 31 % faces.len()], weights: [0.5, 0.2, 0.3] };
    let places: Vec<Place> = (1..=PLACES).map(place).collect();
    let curve = Curve::through(&geometry, &places, true, &mut go_on)?;

    let [mut point, mut ratios] = [Vec::new(), Vec::new()];
    for _ in 0..RUNS {
        let timed = |run: &dyn Fn() -> heatwalk::Result<()>| -> heatwalk::Result<f64> {
            let start = Instant::now();
            run()?;
            Ok(1e3 * start.elapsed().as_secs_f64())
        };
        let of_point = timed(&|| {
            let mut front = Wavefront::new(Arc::clone(&geometry), &[places[0]])?;
            while !front.advance(f64::INFINITY, 20_000)? {}
            drop(black_box(front.into_values()));
            Ok(())
        })?;
        let curves = [curve.clone()];
        let of_curve = timed(&|| curve_distance(&geometry, &curves, &mut go_on).map(|all| drop(black_box(all))))?;
        point.push(of_point);
        ratios.push(of_curve / of_point);
    }

    let spacing = curve.length(&surface)? / POINTS;
    let of_points = exact_distance(&surface, &points(&surface, &curve, spacing)?, &mut go_on)?;
    let found = curve_distance(&geometry, from_ref(&curve), &mut go_on)?;
    let (mut above, mut below) = (0.0_f64, Vec::new());
    for vertex in surface.vertices().filter(|&vertex| found[vertex].is_finite()) {
        let excess = of_points[vertex] - found[vertex];
        above = above.max(-excess / of_points[vertex]);
        below.push(8.0 * excess * found[vertex] / (spacing * spacing));
    }
    let [point, ratio, most] = [median(point), median(ratios), share(&mut below, 0.95)];
    let (lines, below) = (curve.lines().len(), median(below));
    let signs = signs(&surface, &geometry)?.unwrap_or("– | – | –".to_owned());
    println!("| {name} | {lines} | {point:.1} | {ratio:.2} | {above:.1e} | {below:.2} / {most:.2} | {signs} |");
    Ok(())
}

/// In per cent of the vertices beyond a mean edge: where the sign of distance from the longest isoline around a vertex is right, and that
/// from four fifths of it. None where no isoline is closed.
fn signs(surface: &Surface, geometry: &Arc<ExactGeometry>) -> heatwalk::Result<Option<String>> {
    let from = exact_distance_of(geometry, VertexId(0))?;
    let level = 0.45 * from.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
    let mut loops = isolines(surface, &from, level);
    loops.sort_by_key(Vec::len);
    let Some(places) = loops.pop() else { return Ok(None) };
    let whole = Curve::new(surface, &places, true)?;
    let broken = Curve::new(surface, &places[..places.len() * 4 / 5], false)?;
    // What the isoline parts, by a way along edges that do not cross it.
    let truth = signed_curve_distance(geometry, from_ref(&whole), Sign::Nearest, &mut go_on)?.values;
    let inside = parts(surface, &from, level, &places);
    let right = |curve: &Curve, sign: Sign| -> heatwalk::Result<f64> {
        let found = signed_curve_distance(geometry, from_ref(curve), sign, &mut go_on)?.values;
        let far =
            surface.vertices().filter(|&vertex| truth[vertex].is_finite() && truth[vertex].abs() > surface.mean_edge());
        let (all, right) = far.fold((0, 0), |(all, right), vertex| {
            (all + 1, right + u32::from((found[vertex] < 0.0) == inside[vertex.index()]))
        });
        Ok(100.0 * f64::from(right) / f64::from(all))
    };
    let [closed, heat, nearest] =
        [right(&whole, Sign::Auto)?, right(&broken, Sign::Auto)?, right(&broken, Sign::Nearest)?];
    Ok(Some(format!("{closed:.2} | {heat:.2} | {nearest:.2}")))
}

fn exact_distance_of(geometry: &Arc<ExactGeometry>, vertex: VertexId) -> heatwalk::Result<VertexData<f64>> {
    exact_distance(geometry.surface(), &[vertex], &mut go_on)
}

/// The closed curves where linear values are at a level, which is none of them, with larger ones on the right.
fn isolines(surface: &Surface, values: &VertexData<f64>, level: f64) -> Vec<Vec<Place>> {
    let mesh = surface.mesh();
    let at = |halfedge: HalfedgeId| surface.ends(halfedge).map(|vertex| values[vertex]);
    // Entered where what is on the left of the way is nearer.
    let enters = |halfedge: HalfedgeId| at(halfedge)[0] < level && at(halfedge)[1] > level;
    let mut is_seen = vec![false; mesh.halfedge_count()];
    let mut loops = Vec::new();
    for start in surface.faces().ids().flat_map(|face| [0, 1, 2].map(|k| face.halfedge(k))).filter(|&side| enters(side))
    {
        let (mut places, mut halfedge) = (Vec::new(), start);
        while !std::mem::replace(&mut is_seen[halfedge.index()], true) {
            let [a, b] = at(halfedge);
            places.push(Place::Edge { halfedge, fraction: (level - a) / (b - a) });
            let out = [mesh.next(halfedge), mesh.next(mesh.next(halfedge))];
            let Some(out) = out.into_iter().find(|&out| at(out)[0] > level && at(out)[1] < level) else { break };
            halfedge = mesh.twin(out);
            if mesh.is_boundary(mesh.face(halfedge)) {
                break;
            }
        }
        if halfedge == start && places.len() > 2 {
            loops.push(places);
        }
    }
    loops
}

/// Whether each vertex is on the nearer side of one isoline, by ways along edges that do not cross that.
fn parts(surface: &Surface, values: &VertexData<f64>, level: f64, places: &[Place]) -> Vec<bool> {
    let crossed: HashSet<[u32; 2]> = places
        .iter()
        .filter_map(|place| match *place {
            Place::Edge { halfedge, .. } => {
                let [a, b] = surface.ends(halfedge).map(|vertex| vertex.0);
                Some([a.min(b), a.max(b)])
            }
            _ => None,
        })
        .collect();
    let mut is_inside = vec![false; surface.vertex_count()];
    let nearer = places.iter().flat_map(|place| place.support(surface)).map(|(vertex, _)| vertex);
    let mut open: Vec<VertexId> = nearer.filter(|&vertex| values[vertex] < level).collect();
    while let Some(vertex) = open.pop() {
        if std::mem::replace(&mut is_inside[vertex.index()], true) {
            continue;
        }
        for (face, _) in surface.corners_of_vertex(vertex) {
            let others = surface.faces()[face].into_iter().filter(|&other| other != vertex);
            open.extend(others.filter(|other| !crossed.contains(&[vertex.0.min(other.0), vertex.0.max(other.0)])));
        }
    }
    is_inside
}

fn points(surface: &Surface, curve: &Curve, spacing: f64) -> heatwalk::Result<Vec<Source>> {
    let mut sources = Vec::new();
    for line in curve.lines() {
        let parts = (line.length(surface) / spacing).ceil().max(1.0);
        for part in 0..=parts as u32 {
            sources.push(surface.source(line.at(surface, f64::from(part) / parts), 0.0)?);
        }
    }
    Ok(sources)
}

fn median(mut values: Vec<f64>) -> f64 {
    share(&mut values, 0.5)
}

/// The value that this share of all is not above.
fn share(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part) as usize]
}
