//! Distance by a few windows an edge: never below the exact one, near to it, the same however it is asked for.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common;

use std::f64::consts::TAU;
use std::num::NonZeroU16;
use std::ops::ControlFlow;
use std::sync::Arc;

use crate::common::exact_distances::{self, Field};
use crate::common::searches::{self, Case, at, exact, geometry, mixed_sources};
use crate::common::truth::Random;
use crate::common::{soup, square, surface};
use glam::DVec3;
use heatwalk::exact::ExactGeometry;
use heatwalk::propagation::{Propagation, propagated_distance};
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Element, Error, ExactSearch, FaceId, HalfedgeId, InputVertex, Place, PropagationOptions, RelativeError, VertexId,
    Windows, descend, go_on, straighten,
};
use heatwalk_shapes as shapes;

/// What rounding may take from the length of a path.
const ROUNDING: f64 = 1e-9;

const COUNTS: [u16; 4] = [1, 2, 4, 8];

fn options(windows: u16) -> PropagationOptions {
    let windows = Windows::AtMost(NonZeroU16::new(windows).expect("a window"));
    PropagationOptions { windows, ..PropagationOptions::default() }
}

fn start(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)], windows: u16) -> Propagation {
    Propagation::new(Arc::clone(geometry), sources, options(windows)).expect("valid sources")
}

fn propagated(geometry: &Arc<ExactGeometry>, sources: &[(Place, f64)], windows: u16) -> Propagation {
    searches::grown(start(geometry, sources, windows))
}

#[test]
fn no_value_is_below_the_exact_one_and_all_that_is_reached_has_one() {
    for Case { geometry, sources, exact, .. } in searches::cases_of_all_kinds() {
        for windows in COUNTS {
            let propagation = propagated(&geometry, &sources, windows);
            for (&value, &least) in propagation.values().iter().zip(exact.values()) {
                assert!(value >= least * (1.0 - ROUNDING), "{value} for {least}");
                assert_eq!(value.is_finite(), least.is_finite());
            }
        }
    }
}

#[test]
fn more_windows_are_nearer_to_the_exact_distance() {
    for (soup, coarsest) in [(shapes::torus(2.0, 0.7, 120, 60), 0.3), (shapes::horse(0.05), 0.6)] {
        let surface = Arc::new(surface(&soup));
        let geometry = geometry(&surface);
        let exact = exact(&geometry, &at(5));
        let errors = COUNTS.map(|windows| {
            let propagation = propagated(&geometry, &at(5), windows);
            100.0 * RelativeError::between(propagation.values(), exact.values()).mean
        });
        assert!(errors[0] < coarsest, "{errors:?}");
        assert!(errors.windows(2).all(|pair| pair[1] < pair[0]), "{errors:?}");
    }
}

#[test]
fn the_error_is_a_fraction_of_that_of_the_robust_heat_method() {
    let mut ratios = Vec::new();
    for known in exact_distances::kept() {
        let surface = Arc::new(surface(&known.soup));
        let geometry = geometry(&surface);
        for Field { source, exact, robust } in &known.fields {
            let source = surface.vertex_of_input(InputVertex::from_index(*source)).expect("a used vertex");
            let propagation = propagated(&geometry, &at(source.0), 2);
            let pairs = surface.vertices_of_inputs().iter().zip(exact);
            let (values, exact): (Vec<f64>, Vec<f64>) =
                pairs.filter_map(|(vertex, &exact)| Some((propagation.values()[(*vertex)?], exact))).unzip();
            let error = RelativeError::between(&values, &exact);
            ratios.push([100.0 * error.mean / robust[0], 100.0 * error.max / robust[1]]);
        }
    }
    for ratio in [0, 1].map(|kind| ratios.iter().map(move |ratios| ratios[kind])) {
        let (sum, most) =
            ratio.fold((0.0, 0.0_f64), |(sum, most), ratio| (sum + ratio.max(1e-9).ln(), most.max(ratio)));
        let mean = (sum / ratios.len() as f64).exp();
        assert!(mean < 0.12 && most < 0.5, "{mean} {most} {ratios:?}");
    }
}

#[test]
fn on_a_plane_it_is_straight() {
    let surface = Arc::new(surface(&square(60)));
    let geometry = geometry(&surface);
    let face = FaceId::from_index(surface.face_count() / 2);
    let source = Place::Face { face, weights: [0.2, 0.3, 0.5] };
    let from = source.position(&surface);
    let propagation = propagated(&geometry, &[(source, 0.0)], 2);
    let straight: Vec<f64> = surface.positions().iter().map(|position| position.distance(from)).collect();
    let error = RelativeError::between(propagation.values(), &straight);
    // Two windows of an edge do not see all that is straight ahead: a path may bend at a window's end.
    assert!(error.mean < 1e-3 && error.max < 1e-2, "{error:?}");
}

#[test]
fn slices_and_a_used_solver_change_nothing() {
    searches::slices_and_use_change_nothing(|geometry, sources| start(geometry, sources, 2));
}

#[test]
fn values_below_a_radius_are_final_when_it_is_reached() {
    let surface = Arc::new(surface(&shapes::icosphere(5)));
    let geometry = geometry(&surface);
    let whole = propagated(&geometry, &at(0), 1);
    let mut part = start(&geometry, &at(0), 1);
    assert!(part.advance(1.5, usize::MAX).expect("room for windows") && part.radius() >= 1.5);
    for (&value, &last) in part.values().iter().zip(whole.values()) {
        assert!(value >= last && (last >= 1.5 || value == last), "{value} {last}");
    }
    assert!(part.values().iter().any(|value| value.is_infinite()), "it went all the way");
}

#[test]
fn the_nearest_source_is_told() {
    let is_near = |value, least| value >= least * (1.0 - ROUNDING) && value <= 1.01 * least + ROUNDING;
    searches::nearest_sources_are_told(|geometry, sources| start(geometry, sources, 4), is_near);
    let two = soup(
        vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z, DVec3::Z + DVec3::X, DVec3::Z + DVec3::Y],
        vec![[0, 1, 2], [3, 4, 5]],
    );
    let surface = Arc::new(surface(&two));
    let one_side = propagated(&geometry(&surface), &at(0), 1);
    assert_eq!(one_side.nearest_sources().as_slice(), [Some(0), Some(0), Some(0), None, None, None]);
}

#[test]
fn the_size_of_a_mesh_does_not_matter() {
    searches::size_does_not_matter(|geometry, sources| start(geometry, sources, 2));
}

#[test]
fn all_windows_are_exact_and_factors_are_for_nothing() {
    let surface = Arc::new(surface(&shapes::torus(2.0, 0.7, 60, 30)));
    let geometry = geometry(&surface);
    let sources = mixed_sources(&surface, &mut Random::new(11));
    let exact = exact(&geometry, &sources);
    for options in [
        PropagationOptions { windows: Windows::All, ..PropagationOptions::default() },
        PropagationOptions { exact: ExactSearch::AtMost(usize::MAX), ..options(1) },
    ] {
        let mut all = Propagation::new(Arc::clone(&geometry), &sources, options).expect("valid sources");
        assert!(all.advance(f64::INFINITY, usize::MAX).expect("room for windows") && all.is_done());
        assert_eq!(all.values(), exact.values());
        assert_eq!(all.exact_below(), f64::INFINITY);
        let distance = all.distance();
        assert_eq!(distance.heat(), Err(Error::NoHeat));
        assert_eq!(distance.exact_below, f64::INFINITY);
    }
    // What the exact search knows is exact.
    let few = propagated(&geometry, &sources, 1);
    let inside = few.values().iter().zip(exact.values()).filter(|&(_, &least)| least < few.exact_below());
    assert!(inside.clone().count() > 100 && inside.clone().all(|(value, least)| value == least));
}

#[test]
fn of_many_sources_on_an_edge_of_many_faces_those_that_go_are_near_to_all() {
    let (pages, count) = (200, 500_usize);
    let geometry = geometry(&Arc::new(surface(&common::book(pages, 1))));
    let of_all_pages = |halfedge: &HalfedgeId| geometry.surface().faces_of_edge(*halfedge).count() == pages as usize;
    let mut halfedges = (0..3 * geometry.surface().face_count()).map(HalfedgeId::from_index);
    let halfedge = halfedges.find(of_all_pages).expect("the spine");
    let sources: Vec<(Place, f64)> = (0..count)
        .map(|number| {
            let fraction = (number as f64 + 0.5) / count as f64;
            (Place::Edge { halfedge, fraction }, 0.1 * (number * 7 % count) as f64 / count as f64)
        })
        .collect();
    let exact = exact(&geometry, &sources);
    let propagation = propagated(&geometry, &sources, 4);
    assert_eq!((propagation.exact_below(), propagation.is_exact()), (0.0, false));
    for ((&value, &least), source) in
        propagation.values().iter().zip(exact.values()).zip(propagation.nearest_sources().iter())
    {
        assert!(value >= least * (1.0 - ROUNDING) && value <= least + 1.0 / 64.0, "{value} for {least}");
        assert!(value >= sources[source.expect("all is reached")].1);
    }
}

#[test]
fn paths_descend_it() {
    let surface = Arc::new(surface(&shapes::icosphere(4)));
    let sources = [Place::Vertex(VertexId(0)), Place::Vertex(VertexId(9))];
    let distance = propagated_distance(&surface, &sources, options(1), &mut go_on).expect("distances");
    assert_eq!(distance.sources, sources);
    for vertex in surface.vertices().step_by(97) {
        let path = straighten(&surface, &descend(&surface, &distance, vertex).expect("a path")).expect("a path");
        let value = distance.values[vertex];
        assert!((path.length() - value).abs() <= 5e-3 * value, "{} for {value}", path.length());
    }
    let mut stop = |_, _| ControlFlow::Break(());
    let large = Arc::new(common::surface(&shapes::icosphere(6)));
    assert_eq!(propagated_distance(&large, &sources, options(1), &mut stop), Err(Error::Cancelled));
}

/// Triangles around a vertex whose rim goes up and down, with a source at the middle of each edge that meets there: of those edges each
/// has a source that is a little nearer to the vertex than that of the edge before, or a little farther.
fn hub(count: usize) -> (Arc<ExactGeometry>, Vec<Place>) {
    let rim = (0..count).map(|index| {
        let angle = TAU * index as f64 / count as f64;
        DVec3::new(angle.cos(), 0.2 * (7.0 * angle).sin(), angle.sin())
    });
    let positions = std::iter::once(DVec3::ZERO).chain(rim).collect();
    let triangles = (0..count as u32).map(|index| [0, (index + 1) % count as u32 + 1, index + 1]).collect();
    let surface = Arc::new(surface(&soup(positions, triangles)));
    let sources = (0..count).map(|face| Place::Edge { halfedge: FaceId::from_index(face).halfedge(0), fraction: 0.5 });
    (geometry(&surface), sources.collect())
}

#[test]
fn around_a_vertex_each_edge_is_crossed_by_few_windows_however_many_are_a_little_sooner() {
    const COUNT: usize = 16000;
    let (geometry, sources) = hub(COUNT);
    let sources: Vec<_> = sources.into_iter().map(|place| (place, 0.0)).collect();
    // Where each window counts that is sooner at all, there are more the more edges there are.
    let crossed = propagated(&geometry, &sources, 1).windows() as f64 / (3 * COUNT) as f64;
    assert!(crossed < 6.0, "{crossed}");
}

#[test]
fn slivers_are_crossed_few_times_from_the_start_and_values_are_near() {
    // A square cut across.
    const COLUMNS: u32 = 16000;
    let place = |column: u32, y: f64| DVec3::new(f64::from(column) / f64::from(COLUMNS), y, 0.0);
    let positions = (0..=COLUMNS).flat_map(|column| [place(column, 0.0), place(column, 1.0)]);
    let triangles = (0..COLUMNS).flat_map(|column| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * column + k);
        [[a, c, b], [b, c, d]]
    });
    let surface = Arc::new(surface(&soup(positions.collect(), triangles.collect())));
    for from in [0, COLUMNS] {
        let from = surface.vertex_of_input(InputVertex(from)).expect("a vertex in use");
        let propagation = propagated(&geometry(&surface), &[(Place::Vertex(from), 0.0)], 1);
        let crossed = propagation.windows() as f64 / (3 * surface.face_count()) as f64;
        assert!(crossed < 2.0, "each half-edge {crossed} times");
        for vertex in surface.vertices() {
            let straight = surface.position(vertex).distance(surface.position(from));
            let error = propagation.values()[vertex] - straight;
            assert!((-ROUNDING..0.02).contains(&error), "{error} at {vertex}");
        }
    }
}

#[test]
fn refuses_what_is_not_on_the_surface() {
    let surface = Arc::new(surface(&square(2)));
    let geometry = geometry(&surface);
    let none = Propagation::new::<Place>(Arc::clone(&geometry), &[], options(1));
    assert!(matches!(none.map(|_| ()), Err(Error::NoSource)));
    let missing = Propagation::new(Arc::clone(&geometry), &at(1000), options(1));
    assert!(matches!(missing.map(|_| ()), Err(Error::Surface(SurfaceError::NoSuchVertex { .. }))));
    let mut propagation = propagated(&geometry, &at(0), 1);
    let before = propagation.values().clone();
    assert!(propagation.restart(&at(1000)).is_err() && propagation.restart::<Place>(&[]).is_err());
    assert_eq!(propagation.values(), &before);
}
