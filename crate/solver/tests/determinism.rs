//! The same question has the same answer: at every run, and on one thread and on two.
//!
//! Exact distances, propagation and paths are the same to the last bit: they add, multiply, divide and take square roots, which IEEE
//! 754 rounds in one way, and take angles to decide alone. Heat sums in the order of the machine's vectors, and its share of rounding
//! is stated. The shapes here are made of such numbers too: sines differ by machine.
//!
//! A change of the solver that changes a fingerprint says so in the changelog.

#![cfg(not(target_arch = "wasm32"))]

use std::f64::consts::SQRT_2;
use std::num::NonZeroUsize;
use std::sync::Arc;

use glam::DVec3;
use heatwalk::{
    Boundary, DistanceOptions, DistanceSolver, ExactRadius, Method, Parameters, PathKind, Soup, Surface, VertexId,
    go_on,
};

use crate::common::meshes;
use crate::common::truth::Random;
use crate::common::{any_triangles, grid_triangles, soup};

/// Threads that surfaces are built and triangles unfolded on.
const THREADS: [usize; 2] = [1, 2];

/// What the order of sums may change in a distance by heat, as a share of the largest: what distance grows by along an edge is kept in
/// this share of the edge, and a sum that differs in its last digit may be rounded to the next one.
const ORDER_OF_SUMS: f64 = 1.0 / u16::MAX as f64;

/// Meshes by name.
fn mesh(name: &str) -> Soup {
    match name {
        "bunny" => meshes::mesh("bunny"),
        "hills" => hills(24),
        "book" => book(5, 6),
        "any" => any_triangles(60, &mut Random::new(3)),
        _ => panic!("there is no mesh {name}"),
    }
}

/// A grid at heights that are whole parts of 16.
fn hills(side: u32) -> Soup {
    let height = |x: u32, y: u32| f64::from((7 * x * x + 3 * x * y + 5 * y * y) % 23) / 16.0;
    let places = (0..=side).flat_map(|x| (0..=side).map(move |y| (x, y)));
    let positions = places.map(|(x, y)| DVec3::new(x.into(), y.into(), height(x, y))).collect();
    soup(positions, grid_triangles(0, side).collect())
}

/// Pages of whole coordinates, joined along one edge.
fn book(pages: u32, side: u32) -> Soup {
    let mut book = Soup::default();
    for page in 0..pages {
        let out = DVec3::new(f64::from(page) - 2.0, f64::from(page * page) - 3.0, 0.0);
        let first = book.positions.len() as u32;
        let places = (0..=side).flat_map(|i| (0..=side).map(move |j| out * f64::from(i) + DVec3::Z * f64::from(j)));
        book.add(places, &grid_triangles(0, side).collect::<Vec<_>>());
        assert_eq!(book.positions.len() as u32, first + (side + 1) * (side + 1));
    }
    book
}

/// FNV-1a, of the bits of numbers.
fn fingerprint(numbers: impl IntoIterator<Item = f64>) -> u64 {
    let bytes = numbers.into_iter().flat_map(|number| number.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3))
}

/// Distances of all vertices from two of them, and the places of a path.
fn answer(soup: &Soup, options: &DistanceOptions, threads: usize) -> (Vec<f64>, Vec<f64>) {
    let threads = NonZeroUsize::new(threads).expect("a thread");
    let surface = Arc::new(Surface::build_on(soup, threads).expect("a surface"));
    let vertex = |share: usize| VertexId((share * (surface.vertex_count() - 1) / 7) as u32);
    let mut solver = DistanceSolver::on_threads(Arc::clone(&surface), threads);
    let answer = solver.distance(&[vertex(0), vertex(2)], options, &mut go_on).expect("two sources");
    let path = solver.path(&answer, vertex(6), PathKind::Straightened).map_or(Vec::new(), |path| path.points);
    let places = path.iter().flat_map(|point| point.position.to_array()).collect();
    (answer.distance.values.iter().copied().collect(), places)
}

fn options(name: &str) -> DistanceOptions {
    match name {
        "exact" => DistanceOptions::by(Method::Exact),
        "propagation" => DistanceOptions::by(Method::Propagation),
        "limited" => DistanceOptions { max_distance: 1.5, ..DistanceOptions::by(Method::Exact) },
        _ => panic!("there are no options {name}"),
    }
}

/// Mesh, options, and the fingerprints of distances and of a path.
const FINGERPRINTS: [(&str, &str, [u64; 2]); 12] = [
    ("bunny", "exact", [0x1d0f_4111_abac_5010, 0x40cf_3923_80d6_60f3]),
    ("bunny", "propagation", [0x01dd_0e1f_0370_4680, 0x40cf_3923_80d6_60f3]),
    ("bunny", "limited", [0xe3fe_dc7b_7cd0_efdf, 0xcbf2_9ce4_8422_2325]),
    ("hills", "exact", [0x96cf_4fe1_1a84_9657, 0x7fce_c499_dd52_f5ca]),
    ("hills", "propagation", [0x96cf_4fe1_1a84_9657, 0x7fce_c499_dd52_f5ca]),
    ("hills", "limited", [0x85e8_4422_a642_4ae8, 0xcbf2_9ce4_8422_2325]),
    ("book", "exact", [0x3c47_b5c0_1648_4a88, 0x8446_a9b4_7f19_aea8]),
    ("book", "propagation", [0x3c47_b5c0_1648_4a88, 0x8446_a9b4_7f19_aea8]),
    ("book", "limited", [0x9806_e09d_0e67_eb89, 0xcbf2_9ce4_8422_2325]),
    ("any", "exact", [0x7ad1_4011_520b_cea9, 0xc7ad_dc0a_3b0a_eddc]),
    ("any", "propagation", [0x7ad1_4011_520b_cea9, 0xc7ad_dc0a_3b0a_eddc]),
    ("any", "limited", [0x7ad1_4011_520b_cea9, 0xc7ad_dc0a_3b0a_eddc]),
];

#[test]
fn exact_distances_propagation_and_paths_are_the_same_to_the_last_bit() {
    let mut others = String::new();
    for (name, options_name, known) in FINGERPRINTS {
        for threads in THREADS {
            let (values, path) = answer(&mesh(name), &options(options_name), threads);
            let found = [fingerprint(values), fingerprint(path)];
            if found != known {
                others += &format!("(\"{name}\", \"{options_name}\", {found:#018x?}), on {threads} threads\n");
            }
        }
    }
    assert!(others.is_empty(), "the solver gives other numbers than it did:\n{others}");
}

/// Mesh, boundary, and distances by heat at sevenths of the vertices, as one machine has them.
const HEAT: [(&str, Boundary, [f64; 8]); 8] = [
    (
        "bunny",
        Boundary::Neumann,
        [
            0.0,
            4.755610365082824,
            0.0,
            7.312319336642803,
            2.683571165920627,
            7.117340146451725,
            4.822409939206798,
            5.351619088855709,
        ],
    ),
    (
        "bunny",
        Boundary::Dirichlet,
        [
            0.0,
            4.755610365082824,
            0.0,
            7.312319336642803,
            2.683571165920627,
            7.117340146451725,
            4.822409939206798,
            5.351619088855709,
        ],
    ),
    (
        "hills",
        Boundary::Neumann,
        [
            0.0,
            13.557485837902178,
            0.0,
            15.141684431861314,
            7.624261226715252,
            19.948848777985127,
            15.375038449215541,
            27.54556093965135,
        ],
    ),
    (
        "hills",
        Boundary::Average,
        [
            0.0,
            13.873437909755545,
            0.0,
            15.591223388441188,
            8.138472079357436,
            20.745892587681688,
            16.05533161531294,
            28.195678243973138,
        ],
    ),
    (
        "book",
        Boundary::Neumann,
        [
            0.0,
            14.660422221671856,
            0.0,
            SQRT_2,
            6.549755741660421,
            24.331050121192877,
            26.476404589747453,
            79.14543574963751,
        ],
    ),
    (
        "book",
        Boundary::Dirichlet,
        [
            0.0,
            10.824381785586676,
            0.0,
            1.896984174994425,
            5.651431395957235,
            17.78742807706637,
            15.609435801054843,
            44.03368530420032,
        ],
    ),
    (
        "any",
        Boundary::Neumann,
        [
            0.0,
            1.23421513869093,
            0.0,
            0.6855265377961196,
            0.6195648820857802,
            0.6059558418425725,
            1.213891149563285,
            0.5268577212928685,
        ],
    ),
    (
        "any",
        Boundary::Average,
        [
            0.0,
            1.23421513869093,
            0.0,
            0.6855265377961196,
            0.6195648820857802,
            0.6059558418425725,
            1.213891149563285,
            0.5268577212928685,
        ],
    ),
];

#[test]
fn heat_is_the_same_on_any_number_of_threads_and_known_but_for_the_order_of_sums() {
    let mut others = String::new();
    for (name, boundary, known) in HEAT {
        let heat = Parameters { boundary, exact_radius: ExactRadius::Edges(0.0), ..Parameters::default() };
        let options = DistanceOptions { heat, ..DistanceOptions::by(Method::Heat) };
        let [values, again] =
            [THREADS[0], THREADS[THREADS.len() - 1]].map(|threads| answer(&mesh(name), &options, threads).0);
        assert_eq!(fingerprint(values.iter().copied()), fingerprint(again), "{name} on more threads");
        let largest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let found: [f64; 8] = std::array::from_fn(|share| values[share * (values.len() - 1) / 7]);
        let is_same = |(a, b): (&f64, &f64)| a == b || (a - b).abs() <= ORDER_OF_SUMS * largest;
        if !found.iter().zip(&known).all(is_same) {
            others += &format!("(\"{name}\", Boundary::{boundary:?}, {found:?}),\n");
        }
    }
    assert!(others.is_empty(), "the solver gives other numbers than it did:\n{others}");
}
