//! Generated shapes: closed where they should be, outward, well shaped, the same every time.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use std::collections::HashMap;

use glam::DVec3;
use heatwalk_shapes as shapes;
use heatwalk_surface::{BridgeRule, Bridges, Error, Soup, Surface};

/// The triangles of a part over vertices welded by position, degenerate ones dropped.
struct Welded {
    vertices: usize,
    triangles: Vec<[usize; 3]>,
    /// How often each directed edge occurs.
    edges: HashMap<(usize, usize), usize>,
}

fn weld(soup: &Soup, part: usize) -> Welded {
    let mut numbers = HashMap::new();
    let mut triangles = Vec::new();
    for triangle in soup.parts[part].triangles().map(|triangle| &soup.triangles[triangle]) {
        let welded = triangle.map(|corner| {
            let next = numbers.len();
            // Adding 0 turns -0 into 0.
            let key = (soup.positions[corner as usize] + 0.0).to_array().map(f64::to_bits);
            *numbers.entry(key).or_insert(next)
        });
        assert!(welded[0] != welded[1] && welded[1] != welded[2] && welded[2] != welded[0], "degenerate triangle");
        triangles.push(welded);
    }
    let mut edges = HashMap::new();
    for triangle in &triangles {
        for corner in 0..3 {
            *edges.entry((triangle[corner], triangle[(corner + 1) % 3])).or_insert(0) += 1;
        }
    }
    Welded { vertices: numbers.len(), triangles, edges }
}

impl Welded {
    /// Every directed edge once: manifold edges and one orientation.
    fn is_oriented_manifold(&self) -> bool {
        self.edges.values().all(|&count| count == 1)
    }

    fn boundary_edges(&self) -> usize {
        self.edges.keys().filter(|&&(from, to)| !self.edges.contains_key(&(to, from))).count()
    }

    fn euler_characteristic(&self) -> i64 {
        let undirected = (self.edges.len() + self.boundary_edges()) / 2;
        self.vertices as i64 - undirected as i64 + self.triangles.len() as i64
    }

    fn components(&self) -> usize {
        let mut parent: Vec<usize> = (0..self.vertices).collect();
        fn root(parent: &mut [usize], mut vertex: usize) -> usize {
            while parent[vertex] != vertex {
                parent[vertex] = parent[parent[vertex]];
                vertex = parent[vertex];
            }
            vertex
        }
        for &(from, to) in self.edges.keys() {
            let (from, to) = (root(&mut parent, from), root(&mut parent, to));
            parent[from] = to;
        }
        (0..self.vertices).filter(|&vertex| parent[vertex] == vertex).count()
    }
}

fn corners(soup: &Soup, triangle: usize) -> [DVec3; 3] {
    soup.triangles[triangle].map(|corner| soup.positions[corner as usize])
}

/// Six times the enclosed volume, positive where triangles are outward.
fn volume(soup: &Soup, part: usize) -> f64 {
    soup.parts[part].triangles().map(|triangle| corners(soup, triangle)).map(|[a, b, c]| a.dot(b.cross(c))).sum()
}

/// Smallest angle of every triangle of a part, in degrees, sorted.
fn smallest_angles(soup: &Soup, part: usize) -> Vec<f64> {
    let mut angles: Vec<f64> = soup.parts[part]
        .triangles()
        .map(|triangle| {
            let p = corners(soup, triangle);
            let angle = |i: usize| (p[(i + 1) % 3] - p[i]).angle_between(p[(i + 2) % 3] - p[i]).to_degrees();
            angle(0).min(angle(1)).min(angle(2))
        })
        .collect();
    angles.sort_by(f64::total_cmp);
    angles
}

#[test]
fn every_name_gives_a_valid_soup_of_page_size() {
    for &name in shapes::names() {
        let soup = shapes::by_name(name).unwrap().soup;
        let triangles = soup.triangles.len();
        assert!((5_000..=50_000).contains(&triangles), "{name}: {triangles} triangles");
        assert!(soup.positions.iter().all(|position| position.is_finite()), "{name}");
        assert!(soup.triangles.iter().flatten().all(|&corner| (corner as usize) < soup.positions.len()), "{name}");
        assert!(soup.parts.iter().flat_map(|part| part.triangles()).eq(0..triangles), "{name}");
        // Walls meet along vertical edges where two blocks touch at a corner only; nobody walks on them.
        assert!(weld(&soup, 0).is_oriented_manifold(), "{name}");
    }
}

#[test]
fn an_unknown_name_lists_the_known_ones() {
    let error = shapes::by_name("teapot").unwrap_err();
    assert!(matches!(error, Error::BadParameter { .. }));
    for name in shapes::names() {
        assert!(error.to_string().contains(name), "{name} is missing in: {error}");
    }
}

#[test]
fn topology_of_closed_shapes() {
    for (name, genus) in [
        ("animal", 0),
        ("horse", 0),
        ("triceratops", 0),
        // Two zygomatic arches.
        ("skull", 2),
        ("high_genus", 3),
        ("ring", 1),
        ("torus", 1),
        ("icosphere", 0),
        ("uv_sphere", 0),
    ] {
        let soup = shapes::by_name(name).unwrap().soup;
        let welded = weld(&soup, 0);
        assert_eq!(welded.boundary_edges(), 0, "{name}");
        assert_eq!(welded.components(), 1, "{name}");
        assert_eq!(welded.euler_characteristic(), 2 - 2 * genus, "{name}");
        assert!(volume(&soup, 0) > 0.0, "{name} is inside out");
    }
}

#[test]
fn topology_of_open_shapes() {
    for (name, characteristic) in [("hemisphere", 1), ("terrain", 1), ("strip", 1)] {
        let welded = weld(&shapes::by_name(name).unwrap().soup, 0);
        assert_eq!((welded.components(), welded.euler_characteristic()), (1, characteristic), "{name}");
        assert!(welded.boundary_edges() > 0, "{name}");
    }
    let cylinder = weld(&shapes::cylinder(2.0, 24, 10), 0);
    assert_eq!((cylinder.euler_characteristic(), cylinder.boundary_edges()), (0, 48));
    assert!(cylinder.is_oriented_manifold());
}

#[test]
fn flat_shapes_face_up() {
    for soup in [shapes::grid(5, 3), shapes::strip(1.0, 4.0, 3), shapes::terrain(16), shapes::maze(3, 2)] {
        for triangle in soup.parts[0].triangles() {
            let [a, b, c] = corners(&soup, triangle);
            assert!((b - a).cross(c - a).y > 0.0, "{} faces down", soup.parts[0].name);
        }
    }
}

#[test]
fn the_road_of_the_maze_is_one_flat_piece_between_walls() {
    let soup = shapes::maze(10, 6);
    let names: Vec<&str> = soup.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["road", "walls"]);
    let road = weld(&soup, 0);
    assert_eq!(road.components(), 1);
    assert!(road.euler_characteristic() < 1, "there are loops");
    let selected = soup.select(&[0]).unwrap();
    assert!(selected.positions.iter().all(|position| position.y == 0.0));
    // The walls are open at the ground; with it, where the apex is, they enclose a positive volume.
    assert!(volume(&soup, 1) > 0.0);
}

#[test]
fn hemisphere_has_its_boundary_in_the_plane_and_a_closed_stand() {
    let soup = shapes::hemisphere(12);
    assert_eq!(soup.parts[0].len(), 4 * 12 * 12);
    let dome = soup.select(&[0]).unwrap();
    assert!(dome.positions.iter().all(|position| (position.length() - 1.0).abs() < 1e-14 && position.y >= 0.0));
    assert_eq!(dome.positions.iter().filter(|position| position.y == 0.0).count(), 48);
    let stand = weld(&soup, 1);
    assert!(stand.is_oriented_manifold());
    assert_eq!((stand.boundary_edges(), stand.euler_characteristic()), (0, 2));
    assert!(volume(&soup, 1) > 0.0);
}

#[test]
fn the_seam_of_the_uv_sphere_is_duplicated() {
    let soup = shapes::uv_sphere(16, 8);
    assert_eq!(soup.positions.len(), 17 * 9);
    assert_eq!(weld(&soup, 0).vertices, 16 * 7 + 2);
    assert_eq!(soup.triangles.len(), 2 * 16 * 7);
}

#[test]
fn spheres_lie_on_the_sphere() {
    let soup = shapes::icosphere(3);
    assert_eq!((soup.positions.len(), soup.triangles.len()), (642, 1280));
    // Rounding of a square root and three divisions.
    assert!(soup.positions.iter().all(|position| (position.length() - 1.0).abs() < 1e-15));
}

#[test]
fn implicit_bodies_are_well_shaped() {
    for name in ["animal", "horse", "triceratops", "skull", "high_genus", "ring"] {
        let soup = shapes::by_name(name).unwrap().soup;
        let triangles = soup.parts[0].len();
        assert!((10_000..=50_000).contains(&triangles), "{name}: {triangles} triangles");
        let angles = smallest_angles(&soup, 0);
        // Relaxed Surface Nets: found are 10.5° at worst, where a horn meets its ear, and 34° below the best 99 %.
        assert!(angles[triangles / 100] > 30.0, "{name}: 1 % quantile {:.1}°", angles[triangles / 100]);
        assert!(angles[0] > 8.0, "{name}: {:.1}°", angles[0]);
    }
}

#[test]
fn figures_stand_on_the_ground_and_are_symmetric() {
    for name in ["animal", "horse", "triceratops"] {
        let soup = shapes::by_name(name).unwrap().soup;
        let lowest = soup.positions.iter().map(|position| position.y).fold(f64::INFINITY, f64::min);
        // The rim of the cut at the ground is rounded.
        assert!(lowest.abs() < 0.02, "{name}: {lowest}");
        let (least, most) = soup
            .positions
            .iter()
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), p| (p.z.min(least), p.z.max(most)));
        // Within an edge: vertices of the two halves are not mirror images.
        assert!((least + most).abs() < 0.04, "{name}: {least} to {most}");
    }
}

#[test]
fn the_skull_has_a_closed_jaw_and_stand_and_open_hollows() {
    let soup = shapes::by_name("skull").unwrap().soup;
    let names: Vec<&str> = soup.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["skull", "lower jaw", "hollows", "stand"]);
    for (part, rims, components) in [(1, 0, 1), (2, 3, 3), (3, 0, 1)] {
        let welded = weld(&soup, part);
        assert!(welded.is_oriented_manifold(), "{}", names[part]);
        assert_eq!(welded.boundary_edges() > 0, rims > 0, "{}", names[part]);
        assert_eq!(welded.components(), components, "{}", names[part]);
        // A sphere each, less its rims.
        assert_eq!(welded.euler_characteristic(), 2 * components as i64 - rims, "{}", names[part]);
    }
    assert!(volume(&soup, 1) > 0.0 && volume(&soup, 3) > 0.0);
}

#[test]
fn shapes_are_deterministic() {
    for name in shapes::names() {
        assert_eq!(shapes::by_name(name).unwrap().soup, shapes::by_name(name).unwrap().soup, "{name}");
    }
}

#[test]
fn a_robot_is_made_of_closed_parts_in_materials() {
    let model = shapes::robot(0.06);
    let robot = &model.soup;
    assert_eq!(robot.parts.len(), 33);
    for (index, part) in robot.parts.iter().enumerate() {
        let welded = weld(robot, index);
        assert!(welded.is_oriented_manifold(), "{}", part.name);
        let shape = (welded.boundary_edges(), welded.components(), welded.euler_characteristic());
        assert_eq!(shape, (0, 1, 2), "{}", part.name);
        // Outward: about its own middle, not that of the robot.
        let vertices = part.triangles().flat_map(|triangle| corners(robot, triangle));
        let middle = vertices.sum::<DVec3>() / (3 * part.len()) as f64;
        let signed = |triangle: usize| {
            let [a, b, c] = corners(robot, triangle).map(|corner| corner - middle);
            a.dot(b.cross(c))
        };
        assert!(part.triangles().map(signed).sum::<f64>() > 0.0, "{}", part.name);
    }
    let appearance = &model.appearance;
    assert_eq!((appearance.runs.len(), appearance.images.len()), (33, 4));
    assert!(appearance.runs.iter().all(|run| run.material.is_some_and(|index| index < appearance.materials.len())));
    let lowest = robot.positions.iter().map(|position| position.y).fold(f64::INFINITY, f64::min);
    assert!(lowest.abs() < 1e-12, "it stands on the ground");
}

#[test]
fn the_parts_of_a_robot_stay_together_as_it_moves() {
    let robot = shapes::robot(0.06);
    let clips = robot.motion.clips();
    assert_eq!(clips.iter().map(|clip| clip.name.as_str()).collect::<Vec<_>>(), ["Wave", "Walk"]);
    for (number, clip) in clips.iter().enumerate() {
        for step in 0..=8 {
            let posed = robot.posed(number, clip.duration() * f64::from(step) / 8.0).unwrap().soup;
            let surface = Surface::build(&posed).unwrap();
            let bridges = Bridges::find(&surface, BridgeRule::Automatic);
            assert_eq!(bridges.group_count(), 1, "{} at {step}/8", clip.name);
            let apart = posed.positions.iter().zip(&robot.soup.positions).map(|(a, b)| a.distance(*b));
            let moved = apart.fold(0.0, f64::max);
            assert!(step % 8 == 0 && number == 0 || moved > 0.1, "{} at {step}/8: {moved}", clip.name);
            assert!(moved < if step % 8 == 0 && number == 0 { 1e-12 } else { 2.5 }, "{moved}");
        }
    }
}
