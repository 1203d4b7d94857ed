//! Tangent planes at vertices: what holds of any surface, and what geometry tells where a surface is flat.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::f64::consts::{PI, TAU};

use glam::DVec3;
use heatwalk::operator::Frames;
use heatwalk::operator::intrinsic::IntrinsicTriangulation;
use heatwalk::sparse::{Scalar, c64};
use heatwalk::surface::triangle;
use heatwalk::{Element, Error, FaceId, HalfedgeId, Soup, Surface, VertexId};
use heatwalk_shapes::{icosphere, torus};

use crate::common::{Damage, band, book, damaged, flat, soup, square, surface};

/// Rounding of a few angles.
const ROUNDING: f64 = 1e-9;

fn frames(surface: &Surface) -> Frames {
    Frames::new(IntrinsicTriangulation::of_surface(surface)).expect("a fan at each vertex")
}

fn sides(frames: &Frames) -> impl Iterator<Item = HalfedgeId> + use<> {
    (0..3 * frames.triangulation().face_count() as u32).map(HalfedgeId)
}

/// Those inside, each with its twin.
fn twins(frames: &Frames) -> impl Iterator<Item = (HalfedgeId, HalfedgeId)> {
    sides(frames).filter_map(|side| Some((side, frames.triangulation().twin(side)?)))
}

fn around(face: u32) -> [HalfedgeId; 3] {
    [0, 1, 2].map(|k| HalfedgeId(3 * face + k))
}

/// Surfaces of all kinds with long and thin triangles, as they are and flipped.
fn uneven() -> Vec<Frames> {
    let rough = Damage { jitter: 0.1, squeeze: 0.4, tear: 0.0 };
    let torn = Damage { tear: 0.1, ..rough };
    let soups =
        [icosphere(3), torus(1.0, 0.4, 30, 15), damaged(icosphere(3), 7, rough), damaged(icosphere(3), 3, torn)];
    let both = |soup: &Soup| {
        let before = frames(&surface(soup));
        let mut after = before.clone();
        after.flip_to_delaunay();
        [before, after]
    };
    soups.iter().chain([&band(40, 1)]).flat_map(both).collect()
}

#[test]
fn rotations_around_faces_and_defects_of_angles_sum_to_the_euler_characteristic() {
    for (soup, characteristic) in [(icosphere(3), 2.0), (torus(1.0, 0.4, 30, 15), 0.0)] {
        let surface = surface(&soup);
        let mut frames = frames(&surface);
        let defects: f64 = surface.vertices().map(|vertex| TAU - frames.angle_sum(vertex)).sum();
        assert!((defects - TAU * characteristic).abs() < ROUNDING, "{defects}");
        for _ in 0..2 {
            let rotations = (0..frames.triangulation().face_count() as u32).map(|face| {
                let [a, b, c] = around(face).map(|side| frames.transport(side));
                (a * b * c).arg()
            });
            let sum = rotations.sum::<f64>();
            assert!((sum - TAU * characteristic).abs() < ROUNDING, "{sum}");
            frames.flip_to_delaunay();
        }
    }
}

#[test]
fn the_rotation_around_a_face_is_the_curvature_that_its_corners_have_of_their_vertices() {
    let surface = surface(&icosphere(2));
    let frames = frames(&surface);
    for face in surface.mesh().faces() {
        let [a, b, c] = around(face.0).map(|side| frames.transport(side));
        let corner = |k: usize| {
            let mut corners = surface.corners(face);
            corners.rotate_left(k);
            TAU * triangle::angle(corners) / frames.angle_sum(surface.faces()[face][k])
        };
        let curvature = corner(0) + corner(1) + corner(2) - PI;
        assert!(curvature > 0.0 && ((a * b * c).arg() - curvature).abs() < ROUNDING, "{curvature}");
    }
}

#[test]
fn transport_along_a_side_and_back_changes_nothing() {
    for frames in uneven() {
        for (side, twin) in twins(&frames) {
            let both = frames.transport(side) * frames.transport(twin);
            assert!((both - 1.0).magnitude() < ROUNDING, "{both} at {side:?}");
        }
    }
}

#[test]
fn a_side_carried_along_itself_is_the_direction_away_from_its_twin() {
    for frames in uneven() {
        for (side, twin) in twins(&frames) {
            let carried = frames.transport(side) * frames.direction(side);
            assert!((carried + frames.direction(twin)).magnitude() < ROUNDING, "{side:?}");
        }
    }
}

/// A sheared square, where flips change most edges, with holes or not.
fn sheared(n: u32, shear: f64) -> Surface {
    let mut soup = square(n);
    for position in &mut soup.positions {
        position.x += shear * position.y;
    }
    surface(&soup)
}

#[test]
fn directions_on_a_flat_surface_are_those_of_the_plane_before_and_after_flips() {
    let surface = sheared(9, 3.0);
    let mut frames = frames(&surface);
    let planes = frames.in_space(&surface);
    for flips in 0..2 {
        for side in sides(&frames) {
            let [start, end] = frames.triangulation().ends(side);
            let along = (surface.position(end) - surface.position(start)).normalize();
            let told = planes[start.index()].vector(frames.direction(side));
            assert!((told - along).length() < ROUNDING, "{told} instead of {along} after {flips} rounds");
            let carried = planes[end.index()].vector(frames.transport(side) * c64::cis(1.0));
            assert!((carried - planes[start.index()].vector(c64::cis(1.0))).length() < ROUNDING);
        }
        let wind = DVec3::new(0.6, -0.8, 0.0);
        let numbers: Vec<c64> = planes.iter().map(|plane| plane.number(wind)).collect();
        for (face, [x, y]) in frames.in_faces(&numbers).into_iter().enumerate() {
            let [start, end] = frames.triangulation().ends(HalfedgeId(3 * face as u32));
            let along = (surface.position(end) - surface.position(start)).normalize();
            assert!((x * along + y * DVec3::Z.cross(along) - wind).length() < ROUNDING);
        }
        frames.flip_to_delaunay();
    }
    assert!(frames.triangulation().flips() > 100, "{}", frames.triangulation().flips());
}

#[test]
fn flipped_signposts_of_a_curved_surface_are_those_laid_out_anew() {
    let rough = Damage { jitter: 0.1, squeeze: 0.4, tear: 0.0 };
    let surface = surface(&damaged(icosphere(3), 7, rough));
    let mut kept = frames(&surface);
    kept.flip_to_delaunay();
    assert!(kept.triangulation().flips() > 100, "{}", kept.triangulation().flips());
    let anew = Frames::new(kept.triangulation().clone()).expect("a fan at each vertex");
    let mut turns: Vec<Option<c64>> = vec![None; surface.vertex_count()];
    for side in sides(&kept) {
        let [vertex, _] = kept.triangulation().ends(side);
        let turn = kept.direction(side) * anew.direction(side).conj();
        let known = turns[vertex.index()].get_or_insert(turn);
        assert!((turn - *known).magnitude() < ROUNDING, "one plane, turned, at {vertex:?}");
    }
}

#[test]
fn planes_of_a_sphere_are_tangent_to_it_and_give_back_their_vectors() {
    let surface = surface(&icosphere(3));
    let frames = frames(&surface);
    for (plane, vertex) in frames.in_space(&surface).iter().zip(surface.vertices()) {
        // Triangles of sides of 0.15.
        assert!((plane.normal - surface.position(vertex)).length() < 0.01);
        let number = c64::new(0.3, -2.0);
        assert!((plane.number(plane.vector(number)) - number).magnitude() < ROUNDING);
        assert!(plane.vector(number).dot(plane.normal).abs() < ROUNDING);
    }
}

#[test]
fn copies_of_a_vertex_where_a_surface_is_no_manifold_have_planes_of_their_own() {
    let book = surface(&book(3, 2));
    assert!(!book.is_oriented_manifold());
    let frames = frames(&book);
    assert_eq!(frames.vertex_count(), book.mesh().vertex_count());
    assert_eq!(frames.in_space(&book).len(), book.mesh().vertex_count());
    let welded = Frames::new(IntrinsicTriangulation::delaunay(&book));
    assert!(matches!(welded, Err(Error::NoTangentPlane { .. })), "two sheets");
    // Two triangles that share a point.
    let tips = surface(&soup(
        flat(&[(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0)]),
        vec![[0, 1, 2], [0, 3, 4]],
    ));
    let faces = tips.faces().as_slice();
    let shared = faces[0].into_iter().find(|vertex| faces[1].contains(vertex)).expect("the point");
    let lengths: Vec<[f64; 3]> = tips.side_lengths().as_chunks().0.to_vec();
    let welded = IntrinsicTriangulation::new(faces, &lengths, &[[None; 3]; 2]).expect("triangles");
    assert_eq!(Frames::new(welded).map(|_| ()), Err(Error::NoTangentPlane { vertex: shared.index() }));
    assert_eq!(self::frames(&tips).vertex_count(), 6);
}

#[test]
fn triangles_without_a_surface_must_fit() {
    let face = |corners: [u32; 3]| corners.map(VertexId);
    let side = |side: u32| Some(HalfedgeId(side));
    let make = |faces: &[[u32; 3]], lengths: &[[f64; 3]], twins: &[[Option<HalfedgeId>; 3]]| {
        let faces: Vec<[VertexId; 3]> = faces.iter().map(|&corners| face(corners)).collect();
        IntrinsicTriangulation::new(&faces, lengths, twins).map(|triangulation| triangulation.face_count())
    };
    // Two triangles glued along one side.
    let (faces, lengths) = ([[0, 1, 2], [2, 1, 3]], [[3.0, 4.0, 5.0], [4.0, 3.0, 5.0]]);
    let twins = [[None, side(3), None], [side(1), None, None]];
    assert_eq!(make(&faces, &lengths, &twins), Ok(2));
    for (side_at_fault, other) in [
        (1, [[None, side(3), None], [None; 3]]),
        (3, [[None; 3], [side(1), None, None]]),
        (1, [[None, side(1), None], [None; 3]]),
        (1, [[None, side(6), None], [None; 3]]),
        (0, [[side(4), None, None], [None, side(0), None]]),
    ] {
        assert_eq!(make(&faces, &lengths, &other), Err(Error::BadGlue { side: side_at_fault }));
    }
    let other_lengths = [[3.0, 4.0, 5.0], [4.5, 3.0, 5.0]];
    assert_eq!(make(&faces, &other_lengths, &twins), Err(Error::BadGlue { side: 1 }), "lengths differ");
    let bad = |refused: heatwalk::Result<usize>| assert!(matches!(refused, Err(Error::BadParameter { .. })));
    bad(make(&faces, &lengths[..1], &twins));
    bad(make(&faces, &lengths, &twins[..1]));
    bad(make(&[[0, 1, 4], [4, 1, 3]], &lengths, &twins));
    bad(make(&[[0, 1, u32::MAX], [u32::MAX, 1, 3]], &lengths, &twins));
    for sides in
        [[3.0, 4.0, 8.0], [3.0, 4.0, 7.0], [0.0, 4.0, 4.0], [-3.0, 4.0, 5.0], [f64::NAN; 3], [f64::INFINITY; 3]]
    {
        bad(make(&faces, &[sides, lengths[1]], &twins));
    }
}

#[test]
fn a_cone_of_lengths_alone_turns_what_goes_around_its_tip_by_its_defect() {
    // Equal triangles around vertex 0: a cone of any angle, also of one that no surface in space has with flat faces.
    for (count, apex) in [(5, 0.9), (8, 1.1)] {
        let faces: Vec<[VertexId; 3]> = (0..count).map(|k| [0, 1 + k, 1 + (k + 1) % count].map(VertexId)).collect();
        let base = 2.0 * (0.5_f64 * apex).sin();
        let lengths = vec![[1.0, base, 1.0]; count as usize];
        let twins: Vec<[Option<HalfedgeId>; 3]> = (0..count)
            .map(|k| {
                [Some(3 * ((k + count - 1) % count) + 2), None, Some(3 * ((k + 1) % count))]
                    .map(|side| side.map(HalfedgeId))
            })
            .collect();
        let frames =
            Frames::new(IntrinsicTriangulation::new(&faces, &lengths, &twins).expect("a cone")).expect("one fan");
        let whole = f64::from(count) * apex;
        assert!((frames.angle_sum(VertexId(0)) - whole).abs() < ROUNDING);
        // What points between two sides at the tip does so in their face.
        let mut vectors = vec![c64::new(0.0, 0.0); count as usize + 1];
        vectors[0] = c64::cis(0.5 * TAU / f64::from(count));
        let [x, y] = frames.in_faces(&vectors)[0];
        assert!((3.0 * c64::new(x, y) - c64::cis(0.5 * apex)).magnitude() < ROUNDING);
        let rim = (0..count).map(|k| frames.transport(HalfedgeId(3 * k + 1)));
        let turned = rim.fold(c64::new(1.0, 0.0), |product, transport| product * transport);
        assert!((turned - c64::cis(TAU - whole)).magnitude() < ROUNDING, "{turned}");
    }
}

#[test]
fn a_surface_given_by_its_lengths_is_flipped_as_itself() {
    let surface = sheared(6, 2.0);
    let of_surface = frames(&surface);
    let triangulation = of_surface.triangulation();
    let faces = 0..triangulation.face_count() as u32;
    let twins: Vec<_> = faces.clone().map(|face| around(face).map(|side| triangulation.twin(side))).collect();
    let lengths: Vec<_> = faces.map(|face| around(face).map(|side| triangulation.length(side))).collect();
    let corners: Vec<[VertexId; 3]> =
        (0..surface.face_count() as u32).map(|face| surface.faces()[FaceId(face)]).collect();
    let mut given = Frames::new(IntrinsicTriangulation::new(&corners, &lengths, &twins).expect("fits")).expect("fans");
    let mut own = of_surface.clone();
    given.flip_to_delaunay();
    own.flip_to_delaunay();
    assert!(own.triangulation().flips() > 10);
    for side in sides(&own) {
        let of = |frames: &Frames| (frames.triangulation().ends(side), frames.triangulation().twin(side));
        assert_eq!(of(&own), of(&given));
        assert_eq!(own.direction(side), given.direction(side));
    }
}
