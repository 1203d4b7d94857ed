//! Heat and propagation on thin triangles: sheets of slivers, folded along lines, graded, with T-junctions; their bounds hold by
//! construction, whatever the shapes.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::sync::Arc;

use crate::common::searches::geometry;
use crate::common::truth::Random;
use crate::common::{soup, surface};
use glam::{DVec2, DVec3};
use heatwalk::propagation::Propagation;
use heatwalk::{
    DistanceOptions, DistanceSolver, Element, ExactRadius, ExactSearch, InputVertex, Method, Place, PropagationOptions,
    Soup, Surface, VertexId, Windows, go_on,
};

/// What rounding may take from a length, as a share of the extent.
const ROUNDING: f64 = 1e-12;

/// A rectangle of `steps[0] × steps[1]`, cut along the lines between the steps, each cell halved along either diagonal, and bent
/// along those of one direction. Each vertex also has its place in the plane before bending.
struct Sheet {
    soup: Soup,
    plane: Vec<DVec2>,
}

impl Sheet {
    fn new(steps: [&[f64]; 2], random: &mut Random, bend: f64) -> Self {
        let places = |steps: &[f64]| {
            let sums = steps.iter().scan(0.0, |sum, step| {
                *sum += step;
                Some(*sum)
            });
            std::iter::once(0.0).chain(sums).collect::<Vec<f64>>()
        };
        let [across, along] = steps.map(places);
        let mut profile = vec![DVec2::ZERO];
        let mut angle: f64 = 0.0;
        for step in steps[0] {
            profile.push(profile[profile.len() - 1] + step * DVec2::new(angle.cos(), angle.sin()));
            angle += bend;
        }
        let (mut positions, mut plane, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
        for (&x, at) in across.iter().zip(&profile) {
            positions.extend(along.iter().map(|&y| DVec3::new(at.x, y, at.y)));
            plane.extend(along.iter().map(|&y| DVec2::new(x, y)));
        }
        let row = along.len() as u32;
        for i in 0..steps[0].len() as u32 {
            for j in 0..steps[1].len() as u32 {
                let a = i * row + j;
                let [b, c, d] = [a + row, a + row + 1, a + 1];
                triangles.extend(if random.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [b, c, d]] });
            }
        }
        Self { soup: soup(positions, triangles), plane }
    }

    /// Steps of any size between 1 and a power of ten below it.
    fn steps(count: usize, decades: f64, random: &mut Random) -> Vec<f64> {
        (0..count).map(|_| 10_f64.powf(-decades * random.share())).collect()
    }
}

/// Sheets of slivers, flat and rolled up.
fn sheets() -> Vec<Sheet> {
    let mut random = Random::new(7);
    let mut sheets = Vec::new();
    for decades in [2.0, 5.0, 8.0] {
        for bend in [0.0, 0.1] {
            for [across, along] in [[24, 3], [12, 12], [40, 30]] {
                let across = Sheet::steps(across, decades, &mut random);
                let decades = if random.chance(0.5) { 0.0 } else { decades };
                let along = Sheet::steps(along, decades, &mut random);
                sheets.push(Sheet::new([&across, &along], &mut random, bend));
            }
        }
    }
    sheets
}

fn along_edges(surface: &Surface, from: VertexId) -> Vec<f64> {
    let mut values = vec![f64::INFINITY; surface.vertex_count()];
    values[from.0 as usize] = 0.0;
    loop {
        let before = values.clone();
        for vertex in surface.vertices() {
            for other in surface.neighbours(vertex) {
                let through = values[vertex.0 as usize] + surface.position(vertex).distance(surface.position(other));
                let value = &mut values[other.0 as usize];
                *value = value.min(through);
            }
        }
        if values == before {
            return values;
        }
    }
}

fn solved(surface: &Arc<Surface>, from: VertexId, options: &DistanceOptions) -> Vec<f64> {
    let answer = DistanceSolver::new(Arc::clone(surface)).distance(&[from], options, &mut go_on);
    answer.expect("an answer").distance.values.into_vec()
}

/// By heat alone, without exact distances around the source.
fn heat() -> DistanceOptions {
    let mut options = DistanceOptions::by(Method::Heat);
    options.heat.exact_radius = ExactRadius::Edges(0.0);
    options
}

/// By so many windows alone, without exact distances around the source.
fn propagated(surface: &Arc<Surface>, from: VertexId, windows: u16) -> Vec<f64> {
    let windows = Windows::AtMost(windows.try_into().expect("a window"));
    let options = PropagationOptions { windows, exact: ExactSearch::AtMost(0), ..PropagationOptions::default() };
    let source = [(Place::Vertex(from), 0.0)];
    let mut propagation = Propagation::new(geometry(surface), &source, options).expect("a source");
    assert!(propagation.advance(f64::INFINITY, usize::MAX).expect("room for windows"));
    propagation.values().as_slice().to_vec()
}

#[test]
fn heat_is_between_the_straight_line_and_the_way_along_edges() {
    let mut random = Random::new(3);
    for sheet in sheets() {
        let surface = Arc::new(surface(&sheet.soup));
        for _ in 0..2 {
            let from = VertexId::from_index(random.below(surface.vertex_count()));
            let values = solved(&surface, from, &heat());
            let along = along_edges(&surface, from);
            let extent = along.iter().copied().fold(0.0, f64::max);
            for (vertex, (value, along)) in surface.vertices().zip(values.iter().zip(along)) {
                let straight = surface.position(vertex).distance(surface.position(from));
                assert!(*value <= along + ROUNDING * extent, "{value} above {along} along edges");
                assert!(*value >= straight - ROUNDING * extent, "{value} below {straight} in a straight line");
            }
        }
    }
}

#[test]
fn propagation_is_near_on_thin_triangles_and_nearer_with_more_windows() {
    let mut random = Random::new(3);
    let mut means = [0.0; 2];
    for sheet in sheets() {
        let surface = Arc::new(surface(&sheet.soup));
        let from = VertexId::from_index(random.below(surface.vertex_count()));
        // A bent rectangle is one of the plane to whoever walks on it.
        let place = |vertex: VertexId| sheet.plane[surface.inputs_of_vertex(vertex)[0].0 as usize];
        let exact: Vec<f64> = surface.vertices().map(|vertex| place(vertex).distance(place(from))).collect();
        let extent = exact.iter().copied().fold(0.0, f64::max);
        for ((windows, most), mean) in [(2, 0.02), (8, 0.003)].into_iter().zip(&mut means) {
            let values = propagated(&surface, from, windows);
            let errors: Vec<f64> = values.iter().zip(&exact).map(|(value, exact)| (value - exact) / extent).collect();
            let is_bad = |error: &&f64| !(-ROUNDING..most).contains(*error);
            assert_eq!(errors.iter().find(is_bad), None, "with {windows} windows");
            *mean += errors.iter().sum::<f64>() / errors.len() as f64;
        }
        assert_eq!(
            propagated(&surface, from, 1),
            propagated(&surface, from, 2),
            "two windows at least where triangles are thin"
        );
    }
    assert!(means.windows(2).all(|pair| pair[1] < 0.5 * pair[0]), "{means:?}");
}

/// A triangle above a line, `count` below it, and triangles without area between them, all from one end of the line. The first and the
/// last vertex are straight above each other, this far apart.
fn t_junctions(count: u32) -> (Soup, f64) {
    let size = f64::from(count);
    let mut positions = vec![DVec3::new(0.5 * size, size, 0.0)];
    positions.extend((0..=count).map(|x| DVec3::new(f64::from(x), 0.0, 0.0)));
    positions.push(DVec3::new(0.5 * size, -0.1 * size, 0.0));
    let (first, last, below) = (1, count + 1, count + 2);
    let mut triangles = vec![[first, last, 0]];
    triangles.extend((first..last - 1).map(|at| [last, at, at + 1]));
    triangles.extend((first..last).map(|at| [at + 1, at, below]));
    (soup(positions, triangles), 1.1 * size)
}

#[test]
fn t_junctions_closed_by_triangles_without_area_are_no_slits() {
    for count in [2, 7, 40, 400] {
        let (soup, straight) = t_junctions(count);
        let surface = Arc::new(surface(&soup));
        let [from, to] = [0, soup.positions.len() as u32 - 1]
            .map(|input| surface.vertex_of_input(InputVertex(input)).expect("a vertex in use"));
        let far = |values: Vec<f64>| values[to.0 as usize] / straight;
        assert!((far(solved(&surface, from, &exact())) - 1.0).abs() < 1e-9);
        assert!((far(propagated(&surface, from, 1)) - 1.0).abs() < 1e-9);
        // Heat crosses few triangles here; around the slit it would be 1.6 times as far.
        assert!(far(solved(&surface, from, &heat())) < 1.05, "{}", far(solved(&surface, from, &heat())));
    }
}

#[test]
fn any_size_gives_the_same_answer() {
    let sheet = &sheets()[10];
    let from = VertexId(7);
    let at_scale = |scale: f64, options: &DistanceOptions| {
        let mut soup = sheet.soup.clone();
        soup.positions.iter_mut().for_each(|position| *position *= scale);
        solved(&Arc::new(surface(&soup)), from, options)
    };
    let methods = [heat(), DistanceOptions::by(Method::Heat), DistanceOptions::by(Method::Propagation), exact()];
    for options in methods {
        let values = at_scale(1.0, &options);
        let extent = values.iter().copied().fold(0.0, f64::max);
        // A power of two rounds nothing; the largest leaves room for the sheet's own size below the most that is allowed.
        for scale in [2_f64.powi(-400), 2_f64.powi(-60), 2_f64.powi(490)] {
            for (value, scaled) in values.iter().zip(at_scale(scale, &options)) {
                assert!(
                    (value - scaled / scale).abs() <= ROUNDING * extent,
                    "{value} and {} at {scale:e}",
                    scaled / scale
                );
            }
        }
    }
}

fn exact() -> DistanceOptions {
    DistanceOptions::by(Method::Exact)
}

#[test]
fn heat_of_many_sources_is_below_none_in_a_straight_line() {
    let surface = Arc::new(surface(&sheets()[4].soup));
    let mut random = Random::new(11);
    let mut sources = Vec::new();
    for _ in 0..20 {
        let vertex = Place::Vertex(VertexId::from_index(random.below(surface.vertex_count())));
        sources.push((vertex, 0.01 * random.below(100) as f64));
    }
    let answer = DistanceSolver::new(Arc::clone(&surface)).distance(&sources, &heat(), &mut go_on);
    let values = answer.expect("an answer").distance.values;
    for vertex in surface.vertices() {
        let from =
            |&(place, initial): &(Place, f64)| initial + place.position(&surface).distance(surface.position(vertex));
        let straight = sources.iter().map(from).fold(f64::INFINITY, f64::min);
        assert!(values[vertex] >= straight - ROUNDING, "{} below {straight}", values[vertex]);
    }
}
