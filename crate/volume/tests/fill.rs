//! Tetrahedra inside of surfaces.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::HashMap;
use std::f64::consts::PI;
use std::num::NonZeroUsize;
use std::ops::ControlFlow;

use glam::{DMat3, DVec3, EulerRot};
use heatwalk::{Soup, Surface, go_on};
use heatwalk_shapes as shapes;
use heatwalk_volume::TetSoup;
use heatwalk_volume::fill::{Error, Filled, Resolution, Result, Solid};

const ONE: NonZeroUsize = NonZeroUsize::MIN;

fn solid(soup: &Soup) -> Result<Solid> {
    Solid::new(soup, &Surface::build(soup).unwrap(), ONE)
}

fn fill(soup: &Soup, cells: f64) -> Filled {
    solid(soup).unwrap().fill(Resolution::Cells(cells), &mut go_on).unwrap()
}

fn volume(soup: &TetSoup) -> f64 {
    let volume = |tetrahedron: &[u32; 4]| {
        let [a, b, c, d] = tetrahedron.map(|corner| soup.positions[corner as usize]);
        (b - a).cross(c - a).dot(d - a) / 6.0
    };
    let volumes: Vec<f64> = soup.tetrahedra.iter().map(volume).collect();
    assert!(volumes.iter().all(|&volume| volume > 0.0), "all are right-handed");
    volumes.iter().sum()
}

/// A box, counter-clockwise from outside.
fn cuboid(low: [f64; 3], high: [f64; 3]) -> Soup {
    let corner = |k: usize| DVec3::from([0, 1, 2].map(|axis| if k >> axis & 1 == 1 { high[axis] } else { low[axis] }));
    let quads = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    Soup::single("box", (0..8).map(corner).collect(), triangles)
}

fn joined(soups: &[Soup]) -> Soup {
    let mut all = Soup::default();
    for soup in soups {
        all.add(soup.positions.iter().copied(), &soup.triangles);
        all.end_part("part");
    }
    all
}

fn inverted(mut soup: Soup) -> Soup {
    soup.triangles.iter_mut().for_each(|triangle| triangle.swap(0, 1));
    soup
}

fn scaled(mut soup: Soup, factor: f64) -> Soup {
    soup.positions.iter_mut().for_each(|position| *position *= factor);
    soup
}

/// Whether every face is of one tetrahedron or two, and the faces of one close.
fn assert_conforming(soup: &TetSoup) {
    let mut faces: HashMap<[u32; 3], usize> = HashMap::new();
    for &[a, b, c, d] in &soup.tetrahedra {
        for mut face in [[a, b, c], [a, b, d], [a, c, d], [b, c, d]] {
            face.sort_unstable();
            *faces.entry(face).or_default() += 1;
        }
    }
    let mut edges: HashMap<[u32; 2], usize> = HashMap::new();
    for (&[a, b, c], &count) in &faces {
        assert!(count <= 2);
        for edge in [[a, b], [b, c], [a, c]].into_iter().filter(|_| count == 1) {
            *edges.entry(edge).or_default() += 1;
        }
    }
    assert!(edges.values().all(|count| count % 2 == 0), "the boundary is closed");
}

#[test]
fn closed_shapes_fill_within_their_bounds() {
    for name in ["animal", "robot", "horse", "triceratops", "high_genus", "ring", "torus", "icosphere", "uv_sphere"] {
        let soup = shapes::by_name(name).unwrap().soup;
        let solid = solid(&soup).unwrap();
        let resolution = Resolution::Tetrahedra(20_000);
        let estimate = solid.estimate(resolution).unwrap();
        let Filled { soup, report } = solid.fill(resolution, &mut go_on).unwrap();
        assert_conforming(&soup);
        assert_eq!((soup.tetrahedra.len(), soup.positions.len()), (report.tetrahedra, report.vertices));
        let [least, greatest] = report.dihedral_angles;
        // Table 1 of Labelle & Shewchuk.
        assert!(least > 9.31 && greatest < 161.65, "{name}: {least} {greatest}");
        assert!((volume(&soup) - report.volume).abs() < 1e-9 * report.volume, "{name}");
        // Shifts go on until less than 10⁻⁴ of a cell is missing at the surface, here 2 · 10⁻⁴ of the volume, or leave a hundredth of the 2 %
        // that chords take away.
        let lost = report.surface_volume.map_or(0.0, |volume| (report.volume / volume - 1.0).abs());
        assert!(lost < 1e-3, "{name}: {lost}");
        assert!(report.deviation < 0.5 * report.cell_side, "{name}: {}", report.deviation / report.cell_side);
        for (found, expected) in [(report.tetrahedra, estimate.tetrahedra), (report.vertices, estimate.vertices)] {
            assert!((found as f64 / expected as f64 - 1.0).abs() < 0.1, "{name}: {found}, {expected} expected");
        }
    }
}

#[test]
fn a_sphere_converges_with_its_volume_at_every_resolution() {
    let mut before = f64::INFINITY;
    for cells in [6.0, 12.0, 24.0] {
        let Filled { report, .. } = fill(&shapes::icosphere(5), cells);
        let error = (report.volume / report.surface_volume.unwrap() - 1.0).abs();
        // Each shift leaves a fifth of what is missing, 3 % at six cells.
        assert!(error < 3e-4, "{cells}: {error}");
        // Of second order in the side of the cells, until the triangles of the sphere are seen.
        assert!(report.deviation < 0.35 * before, "{cells}: {}", report.deviation);
        before = report.deviation;
    }
}

#[test]
fn what_overlapping_parts_enclose_together_is_filled() {
    // Two unit spheres whose centres are 1 apart share a lens.
    let mut second = shapes::icosphere(5);
    second.positions.iter_mut().for_each(|position| position.x += 1.0);
    let exact = 8.0 / 3.0 * PI - 5.0 / 12.0 * PI;
    for cells in [12.0, 24.0] {
        let report = fill(&joined(&[shapes::icosphere(5), second.clone()]), cells).report;
        assert_eq!(report.surface_volume, None);
        // The share of places that tetrahedra lack is known to its square root: 4 of 1,300 and 5 of 7,000 points inside.
        assert!((report.volume / exact - 1.0).abs() < 3e-3, "{cells}: {}", report.volume / exact);
    }
}

#[test]
fn boxes_on_the_lattice_are_exact() {
    let Filled { soup, report } = fill(&cuboid([0.0; 3], [1.0, 2.0, 0.5]), 16.0);
    assert!((report.volume - 1.0).abs() < 1e-9, "{}", report.volume);
    assert!(report.deviation < 1e-9);
    assert_conforming(&soup);
}

#[test]
fn parts_that_overlap_touch_or_are_inside_out_are_one_solid() {
    let (a, b) = (cuboid([0.0; 3], [1.0; 3]), cuboid([0.5, 0.0, 0.0], [2.0, 1.0, 1.0]));
    let touching = cuboid([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]);
    for parts in [
        vec![a.clone(), b.clone()],
        vec![inverted(a.clone()), b],
        vec![a.clone(), touching.clone()],
        vec![inverted(a.clone()), inverted(touching)],
        vec![a.clone(), a, cuboid([0.5, 0.0, 0.0], [2.0, 1.0, 1.0])],
    ] {
        let Filled { soup, report } = fill(&joined(&parts), 16.0);
        assert!((report.volume - 2.0).abs() < 1e-9, "{}", report.volume);
        assert_conforming(&soup);
    }
}

#[test]
fn cavities_stay_empty_and_parts_within_parts_are_filled() {
    let (outer, inner) = (shapes::icosphere(4), scaled(shapes::icosphere(4), 0.5));
    let shell = 4.0 / 3.0 * PI * (1.0 - 0.125);
    let hollow = joined(&[outer.clone(), inverted(inner.clone())]);
    for soup in [&hollow, &inverted(hollow.clone())] {
        let report = fill(soup, 24.0).report;
        assert!((report.volume / shell - 1.0).abs() < 0.02, "{}", report.volume / shell);
    }
    let full = fill(&joined(&[outer.clone(), inner]), 24.0).report;
    // Triangles tell the volume of the outer one alone, places that of both.
    let share = full.volume / fill(&outer, 24.0).report.volume;
    assert!((share - 1.0).abs() < 2e-3, "{share}");
}

#[test]
fn what_is_thinner_than_a_cell_is_not_lost() {
    let turn = DMat3::from_euler(EulerRot::XYZ, 0.4, 0.3, 0.2);
    // A fifth of a cell takes more than the boundary may be shifted by.
    for (thickness, least) in [(0.2, 0.85), (0.5, 0.98), (0.8, 0.98)] {
        let mut plate = cuboid([0.0; 3], [20.0, 20.0, thickness]);
        plate.positions.iter_mut().for_each(|position| *position = turn * *position);
        let [low, high] = [DVec3::min, DVec3::max]
            .map(|extreme: fn(DVec3, DVec3) -> DVec3| plate.positions.iter().copied().reduce(extreme).unwrap());
        // Cells of side 1.
        let Filled { soup, report } = fill(&plate, (high - low).max_element());
        assert_conforming(&soup);
        let kept = report.volume / report.surface_volume.unwrap();
        // The rim is rounded, and tetrahedra that would be too flat are left out; the boundary is shifted for the rest, and volume jumps
        // where points change sides.
        assert!(kept > least && kept < 1.02, "{thickness}: {kept}");
        assert!(report.deviation < 0.5 * thickness, "{thickness}: {}", report.deviation);
    }
}

#[test]
fn triangles_do_not_tell_the_volume_of_parts_that_overlap_however_little() {
    let (a, b) = (cuboid([0.0; 3], [1.0; 3]), cuboid([0.999, 0.0, 0.0], [2.0, 1.0, 1.0]));
    assert_eq!(fill(&joined(&[a.clone(), b]), 16.0).report.surface_volume, None);
    let touching = cuboid([1.0, 0.0, 0.0], [2.0, 1.0, 1.0]);
    assert_eq!(fill(&joined(&[a, touching]), 16.0).report.surface_volume, Some(2.0));
}

#[test]
fn size_makes_no_difference() {
    let soup = shapes::torus(1.0, 0.4, 24, 12);
    // A power of two, so that nothing is rounded.
    let factor = 2.0_f64.powi(-100);
    let (plain, small) = (fill(&soup, 12.0), fill(&scaled(soup, factor), 12.0));
    assert_eq!(plain.soup.tetrahedra, small.soup.tetrahedra);
    assert!(plain.soup.positions.iter().zip(&small.soup.positions).all(|(&a, &b)| a * factor == b));
}

#[test]
fn small_holes_are_closed() {
    let mut soup = shapes::icosphere(4);
    let whole = fill(&soup, 20.0).report.volume;
    soup.triangles.retain(|triangle| triangle.iter().all(|&corner| soup.positions[corner as usize].z < 0.97));
    let report = fill(&soup, 20.0).report;
    assert_eq!((report.holes, report.surface_volume), (1, None));
    assert!((report.volume / whole - 1.0).abs() < 0.01, "{} {whole}", report.volume);
}

#[test]
fn what_cannot_be_filled_says_why() {
    for name in ["hemisphere", "terrain", "strip", "maze"] {
        let error = solid(&shapes::by_name(name).unwrap().soup).unwrap_err();
        assert!(matches!(error, Error::Open { holes, edges, .. } if holes > 0 && edges > 2), "{name}: {error}");
        assert!(error.to_string().contains("edges around vertex"), "{error}");
    }
    let sphere = solid(&shapes::icosphere(2)).unwrap();
    for cells in [0.0, -1.0, 0.5, 2000.0, f64::NAN, f64::INFINITY] {
        assert_eq!(sphere.fill(Resolution::Cells(cells), &mut go_on).unwrap_err().code(), "bad-parameter");
    }
    assert_eq!(sphere.estimate(Resolution::Tetrahedra(0)).unwrap_err().code(), "bad-parameter");
    // No lattice point comes to lie between these planes.
    let plate = solid(&cuboid([0.0, 0.0, 0.49], [1.0, 1.0, 0.491])).unwrap();
    let error = plate.fill(Resolution::Cells(3.0), &mut go_on).unwrap_err();
    assert_eq!(error, Error::TooCoarse { cells: 3.0 });
}

#[test]
fn it_can_be_cancelled_and_tells_how_far_it_is() {
    let solid = solid(&shapes::icosphere(3)).unwrap();
    let mut shares = Vec::new();
    let mut record = |_, share: f64| {
        shares.push(share);
        ControlFlow::Continue(())
    };
    solid.fill(Resolution::Cells(40.0), &mut record).unwrap();
    assert!(shares.len() > 5 && shares.is_sorted() && shares[shares.len() - 1] < 1.0, "{shares:?}");
    for stop in 0..shares.len() {
        let mut calls = 0;
        let mut until = |_, _| {
            calls += 1;
            if calls > stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        assert_eq!(solid.fill(Resolution::Cells(40.0), &mut until).unwrap_err(), Error::Cancelled);
        assert_eq!(calls, stop + 1, "nothing goes on after it was stopped");
    }
}

#[cfg(not(target_arch = "wasm32"))]
#[test]
fn it_is_the_same_on_any_number_of_threads() {
    let soup = shapes::torus(1.0, 0.4, 48, 20);
    let surface = Surface::build(&soup).unwrap();
    let on = |threads: usize| {
        let solid = Solid::new(&soup, &surface, NonZeroUsize::new(threads).unwrap()).unwrap();
        solid.fill(Resolution::Cells(50.0), &mut go_on).unwrap()
    };
    let one = on(1);
    assert_eq!(one, on(2));
    assert_eq!(one, on(5));
}
