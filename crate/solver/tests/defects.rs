//! One defect in an otherwise sound mesh: a right distance all the same, or an error that names the element.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use crate::common::{solver_with, soup, stretched};
use glam::DVec3;
use heatwalk::surface::Error as SurfaceError;
use heatwalk::{
    Boundary, Distance, Element, ExactRadius, HeatSolver, InputVertex, LinearSolver, MemoryLimit, MultiSource,
    Operator, Parameters, Place, Soup, Surface, TimeStep,
};
use heatwalk_shapes as shapes;

/// Far from the defect and from the poles of numbering.
const SOURCE: u32 = 700;

fn ball() -> Soup {
    shapes::icosphere(4)
}

/// With an exact region of one size, so that a few triangles more do not change it.
const DIALS: Parameters = Parameters {
    operator: Operator::Delaunay,
    solver: LinearSolver::Cholesky,
    time_step: TimeStep::Automatic,
    boundary: Boundary::Neumann,
    sources: MultiSource::Exact,
    exact_radius: ExactRadius::Edges(4.0),
    memory: MemoryLimit::Automatic,
};

fn distance(soup: &Soup, operator: Operator) -> (HeatSolver, Distance) {
    let solver = solver_with(soup, Parameters { operator, ..DIALS });
    let source = solver.surface().vertex_of_input(InputVertex(SOURCE)).expect("a vertex that triangles use");
    let distance = solver.distance(&[Place::Vertex(source)]).expect("a source");
    (solver, distance)
}

/// Every input vertex of the clean ball must be as far as on the clean ball, within a share of the largest distance.
fn check(name: &str, defective: &Soup, share: f64) {
    let (clean_solver, clean) = distance(&ball(), Operator::Delaunay);
    let (solver, distance) = distance(defective, Operator::Delaunay);
    for vertex in 0..ball().positions.len() {
        let at = |solver: &HeatSolver, distance: &Distance| {
            solver.surface().vertex_of_input(InputVertex::from_index(vertex)).map(|point| distance.values[point])
        };
        let Some(value) = at(&solver, &distance) else { continue };
        let wanted = at(&clean_solver, &clean).expect("the ball uses all its vertices");
        assert!((value - wanted).abs() <= share * clean.max(), "{name}, vertex {vertex}: {value} for {wanted}");
    }
}

#[test]
fn defects_that_change_no_shape() {
    let rounding = 1e-9;
    let clean = ball();

    let mut duplicate = clean.clone();
    duplicate.triangles.push(clean.triangles[40]);
    check("duplicate face", &duplicate, rounding);

    let mut unreferenced = clean.clone();
    unreferenced.positions.push(DVec3::splat(9.0));
    check("unreferenced vertex", &unreferenced, rounding);

    let mut repeated = clean.clone();
    let [a, b, _] = clean.triangles[40];
    repeated.triangles.push([a, b, b]);
    check("face with a repeated corner", &repeated, rounding);

    let mut zero_area = clean.clone();
    zero_area.positions.push((clean.positions[a as usize] + clean.positions[b as usize]) * 0.5);
    zero_area.triangles.push([a, b, clean.positions.len() as u32]);
    check("zero-area face on an edge", &zero_area, 0.01);

    let mut flipped = clean.clone();
    flipped.triangles[40].swap(0, 1);
    check("one face flipped", &flipped, rounding);

    let mut seam = clean.clone();
    for triangle in &mut seam.triangles {
        let height = |&vertex: &u32| clean.positions[vertex as usize].dot(clean.positions[SOURCE as usize]);
        let is_opposite = triangle.iter().map(height).sum::<f64>() < 0.0;
        for vertex in triangle {
            let position = clean.positions[*vertex as usize];
            if is_opposite {
                seam.positions.push(position);
                *vertex = seam.positions.len() as u32 - 1;
            }
        }
    }
    seam.triangles.rotate_left(7);
    // Vertices inside the half opposite the source are no longer used; the others must not notice.
    check("UV seam", &seam, rounding);
}

#[test]
fn polygon_soup() {
    let clean = ball();
    let positions: Vec<DVec3> =
        clean.triangles.iter().flatten().map(|&vertex| clean.positions[vertex as usize]).collect();
    let triangles = (0..clean.triangles.len() as u32).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect();
    let loose = soup(positions, triangles);
    let corner = clean.triangles.iter().flatten().position(|&vertex| vertex == SOURCE).expect("a used vertex");
    let solver = solver_with(&loose, DIALS);
    let source = solver.surface().vertex_of_input(InputVertex::from_index(corner)).expect("used");
    let distance_of_soup = solver.distance(&[Place::Vertex(source)]).expect("a source");
    let (clean_solver, wanted) = distance(&clean, Operator::Delaunay);
    for (corner, &vertex) in clean.triangles.iter().flatten().enumerate() {
        let value =
            distance_of_soup.values[solver.surface().vertex_of_input(InputVertex::from_index(corner)).expect("used")];
        let wanted = wanted.values[clean_solver.surface().vertex_of_input(InputVertex(vertex)).expect("used")];
        // Another numbering: other rounding.
        assert!((value - wanted).abs() < 1e-9, "{value} for {wanted}");
    }
}

#[test]
fn defects_that_add_a_little_surface() {
    let rounding = 1e-9;
    let clean = ball();
    let [a, b, _] = clean.triangles[40];

    // A fin: three faces at one edge. Distances on the ball can only become shorter by what the heat in the fin does.
    let mut fin = clean.clone();
    fin.positions.push(clean.positions[a as usize] * 1.1);
    fin.triangles.push([a, b, clean.positions.len() as u32]);
    check("non-manifold edge", &fin, 0.01);

    // Needles and caps of all degrees at one corner.
    for length in [1e-3, 1e-9, 1e-15] {
        let mut short = clean.clone();
        let apex = short.positions.len() as u32;
        let [p, q] = [a, b].map(|vertex| clean.positions[vertex as usize]);
        short.positions.push(p + (q - p) * length);
        let faces: Vec<usize> = (0..clean.triangles.len())
            .filter(|&face| clean.triangles[face].contains(&a) && clean.triangles[face].contains(&b))
            .collect();
        for face in faces {
            let triangle = clean.triangles[face];
            short.triangles[face] = triangle.map(|vertex| if vertex == a { apex } else { vertex });
            short.triangles.push(triangle.map(|vertex| if vertex == b { apex } else { vertex }));
        }
        check("very short edge", &short, 0.01);
    }

    let mut pair = clean.clone();
    pair.add(clean.positions.iter().map(|&position| position + DVec3::X * 5.0), &clean.triangles);
    check("disconnected", &pair, rounding);
    let (solver, distance) = distance(&pair, Operator::Delaunay);
    assert_eq!(distance.unreachable(), solver.surface().vertex_count() / 2);
}

#[test]
fn scale_and_place_do_not_matter() {
    let (_, clean) = distance(&ball(), Operator::Delaunay);
    for (scale, offset, share) in [(1e-8, 0.0, 1e-9), (1e8, 0.0, 1e-9), (1.0, 1e5, 1e-6)] {
        let mut moved = ball();
        for position in &mut moved.positions {
            *position = *position * scale + DVec3::splat(offset);
        }
        let (_, distance) = distance(&moved, Operator::Delaunay);
        for (value, wanted) in distance.values.iter().zip(&clean.values) {
            // An offset of 1e5 takes five digits of the coordinates.
            assert!((value / scale - wanted).abs() <= share * clean.max(), "{scale} {offset}: {value} for {wanted}");
        }
    }
}

#[test]
fn errors_name_the_element() {
    let clean = ball();
    let mut not_a_number = clean.clone();
    not_a_number.positions[17].y = f64::NAN;
    assert_eq!(Surface::build(&not_a_number).err(), Some(SurfaceError::NotFinite { vertex: 17 }));

    let mut out_of_range = clean.clone();
    out_of_range.triangles[23][1] = 99_999;
    let vertices = clean.positions.len();
    assert_eq!(
        Surface::build(&out_of_range).err(),
        Some(SurfaceError::IndexOutOfRange { triangle: 23, vertex: 99_999, vertices })
    );
}

#[test]
fn every_operator_gives_numbers() {
    // The plain and the relocated operator may be wrong on slivers, but never NaN and never negative.
    let squashed = stretched(ball(), 1e-5);
    for operator in [Operator::Delaunay, Operator::Plain, Operator::Relocate] {
        let (_, distance) = distance(&squashed, operator);
        assert!(distance.values.iter().all(|value| value.is_finite() && *value >= 0.0), "{operator:?}");
    }
}
