//! Small assemblies.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use glam::DVec3;

use super::*;
use crate::soup::Soup;

/// A portal is within a spacing of each place that was taken, and these are half a spacing apart.
const COVERED: f64 = 1.25;

/// Triangles of one component.
pub type Shape = (Vec<DVec3>, Vec<[u32; 3]>);

pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> Shape {
    let corner =
        |number: usize| DVec3::from_array([0, 1, 2].map(|k| if number >> k & 1 == 1 { high[k] } else { low[k] }));
    let quads: [[u32; 4]; 6] = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

/// With a vertex at each end of each axis.
pub fn sphere(centre: [f64; 3], radius: f64) -> Shape {
    const RINGS: u32 = 16;
    const SEGMENTS: u32 = 32;
    let mut positions = vec![DVec3::Z, DVec3::NEG_Z];
    let mut triangles = Vec::new();
    let vertex = |ring: u32, segment: u32| 2 + (ring - 1) * SEGMENTS + segment % SEGMENTS;
    for ring in 1..RINGS {
        let (out, up) = (std::f64::consts::PI * f64::from(ring) / f64::from(RINGS)).sin_cos();
        for segment in 0..SEGMENTS {
            let (y, x) = (std::f64::consts::TAU * f64::from(segment) / f64::from(SEGMENTS)).sin_cos();
            positions.push(DVec3::new(out * x, out * y, up));
            if ring > 1 {
                let [a, b] = [vertex(ring - 1, segment), vertex(ring - 1, segment + 1)];
                let [c, d] = [vertex(ring, segment), vertex(ring, segment + 1)];
                triangles.extend([[a, c, d], [a, d, b]]);
            }
        }
    }
    for segment in 0..SEGMENTS {
        triangles.push([0, vertex(1, segment), vertex(1, segment + 1)]);
        triangles.push([1, vertex(RINGS - 1, segment + 1), vertex(RINGS - 1, segment)]);
    }
    (positions.into_iter().map(|position| DVec3::from_array(centre) + radius * position).collect(), triangles)
}

/// The components are numbered as the shapes are.
pub fn assembled(shapes: &[Shape]) -> Surface {
    let mut soup = Soup::default();
    for (positions, triangles) in shapes {
        let first = soup.positions.len() as u32;
        soup.positions.extend(positions);
        soup.triangles.extend(triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
        soup.end_part("shape");
    }
    let surface = Surface::build(&soup).expect("a surface");
    assert_eq!(surface.report().components, shapes.len());
    surface
}

fn joined(surface: &Surface, rule: BridgeRule) -> Vec<[u32; 2]> {
    Bridges::find(surface, rule).contacts().iter().map(|contact| contact.components).collect()
}

/// Piercing boxes, a box standing on one of them, and a sphere that nearly touches another.
fn assembly() -> Vec<Shape> {
    vec![
        cuboid([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]),
        cuboid([-2.0, -0.3, -0.3], [2.0, 0.3, 0.3]),
        cuboid([-0.5, -0.5, 1.0], [0.5, 0.5, 2.0]),
        sphere([2.503, 0.0, 0.0], 0.5),
        sphere([0.0, 3.0, 0.0], 0.5),
    ]
}

/// Where the portals of a contact are.
fn places(surface: &Surface, bridges: &Bridges, components: [u32; 2]) -> Vec<DVec3> {
    let contact = bridges.contacts().iter().find(|contact| contact.components == components).expect("a contact");
    let portals = &bridges.portals()[contact.first as usize..][..contact.count as usize];
    portals.iter().map(|portal| portal.ends[0].position(surface)).collect()
}

fn nearest(places: &[DVec3], place: DVec3) -> f64 {
    places.iter().map(|&other| other.distance(place)).fold(f64::INFINITY, f64::min)
}

/// Places around a square around the z axis.
fn square(half_side: f64, height: f64) -> impl Iterator<Item = DVec3> {
    (0..400).map(move |number| {
        let along = half_side * (f64::from(number % 100) / 50.0 - 1.0);
        let [x, y] =
            [[along, half_side], [half_side, -along], [-along, -half_side], [-half_side, along]][number as usize / 100];
        DVec3::new(x, y, height)
    })
}

#[test]
fn portals_lie_on_their_components_and_know_their_gaps() {
    let surface = assembled(&assembly());
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    assert_eq!(joined(&surface, BridgeRule::Automatic), [[0, 1], [0, 2], [1, 3]]);
    assert_eq!([0, 1, 2, 3, 4].map(|component| bridges.group(component)), [0, 0, 0, 0, 1]);
    assert_eq!(bridges.group_count(), 2);
    for contact in bridges.contacts() {
        // The sphere is nearest in a single vertex.
        assert!(contact.count >= if contact.components == [1, 3] { 1 } else { 3 });
        for portal in &bridges.portals()[contact.first as usize..][..contact.count as usize] {
            assert_eq!(portal.ends.map(|end| end.component(&surface)), contact.components);
            let [first, second] = portal.ends.map(|end| end.position(&surface));
            assert!((portal.gap - first.distance(second)).abs() < 1e-13);
            for end in portal.ends {
                assert_eq!(surface.point(end).map(|point| point.place()), Ok(end));
                assert_eq!(end, end.snapped(&surface));
            }
            let most = if contact.components == [1, 3] { 0.0075 } else { 1e-13 };
            assert!(portal.gap <= most, "{}", portal.gap);
        }
    }
}

#[test]
fn portals_of_piercing_boxes_lie_along_the_crossing() {
    let surface =
        assembled(&[cuboid([-0.3, -0.3, -2.0], [0.3, 0.3, 2.0]), cuboid([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0])]);
    let places = places(&surface, &Bridges::find(&surface, BridgeRule::Automatic), [0, 1]);
    for place in &places {
        assert!(
            (place.x.abs().max(place.y.abs()) - 0.3).abs() < 0.006 && (place.z.abs() - 1.0).abs() < 0.006,
            "{place}"
        );
    }
    let spacing = 0.0075 * 24_f64.sqrt();
    assert!(square(0.3, 1.0).chain(square(0.3, -1.0)).all(|place| nearest(&places, place) < COVERED * spacing));
    assert!(places.len() as f64 <= 2.0 * 2.0 * 2.4 / spacing, "{}", places.len());
}

#[test]
fn a_box_on_a_box_has_portals_all_over_the_overlap() {
    for gap in [0.0, 1e-3] {
        let upper = cuboid([-0.5, -0.5, 1.0 + gap], [0.5, 0.5, 2.0]);
        let surface = assembled(&[cuboid([-1.0, -1.0, 0.0], [1.0, 1.0, 1.0]), upper]);
        let bridges = Bridges::find(&surface, BridgeRule::Automatic);
        assert!(bridges.portals().iter().all(|portal| portal.gap >= gap - 1e-13 && portal.gap < gap + 0.004));
        let places = places(&surface, &bridges, [0, 1]);
        let spacing = 0.0075 * 12_f64.sqrt();
        assert!(square(0.5, 1.0).all(|place| nearest(&places, place) < COVERED * spacing));
        let inside = (1..10).flat_map(|ring| square(0.05 * f64::from(ring), 1.0));
        assert!(inside.map(|place| nearest(&places, place)).fold(0.0, f64::max) < 3.0 * spacing);
        assert!(places.len() < 1000, "{}", places.len());
    }
}

#[test]
fn both_sides_of_a_thin_plate_have_portals() {
    let surface =
        assembled(&[cuboid([-1.0, -1.0, 0.0], [1.0, 1.0, 0.002]), cuboid([-0.1, -0.1, -1.0], [0.1, 0.1, 1.0])]);
    let places = places(&surface, &Bridges::find(&surface, BridgeRule::Automatic), [0, 1]);
    for height in [0.0, 0.002] {
        let side: Vec<_> = places.iter().copied().filter(|place| (place.z - height).abs() < 1e-12).collect();
        assert!(square(0.1, height).all(|place| nearest(&side, place) < COVERED * 0.0075 * 12_f64.sqrt()));
    }
}

#[test]
pub fn spheres_are_joined_up_to_the_tolerance() {
    // The diagonal is √(4² + 2² + 2²), the smaller component's √12, so that the scene decides.
    let diagonal = 24_f64.sqrt();
    for (share, count) in [(-1e-4, 1), (1e-4, 1), (0.9e-3, 1), (2.9e-3, 1), (3.1e-3, 0), (0.02, 0)] {
        let surface = assembled(&[sphere([0.0; 3], 1.0), sphere([0.0, 0.0, 2.0 + share * diagonal], 1.0)]);
        let bridges = Bridges::find(&surface, BridgeRule::Automatic);
        assert_eq!(bridges.contacts().len(), count, "{share}");
        let least = bridges.portals().iter().map(|portal| portal.gap).fold(f64::INFINITY, f64::min);
        if count > 0 {
            assert!((least - (share * diagonal).max(0.0)).abs() < 1e-12, "{least}");
        }
    }
}

#[test]
fn small_parts_must_be_nearer() {
    let ground = cuboid([-1.0, -1.0, -1.0], [1.0, 1.0, 0.0]);
    let particle = |gap: f64| cuboid([0.0, 0.0, gap], [0.01, 0.01, gap + 0.01]);
    // 5 % of the particle's diagonal are 8.7e-4, 0.1 % of that of the scene 3e-3.
    for (gap, count) in [(0.0, 1), (8e-4, 1), (9e-4, 0)] {
        assert_eq!(joined(&assembled(&[ground.clone(), particle(gap)]), BridgeRule::Automatic).len(), count, "{gap}");
    }
}

#[test]
fn what_stays_apart() {
    let row: Vec<_> = (0..10).map(|number| sphere([2.2 * f64::from(number), 0.0, 0.0], 1.0)).collect();
    assert_eq!(joined(&assembled(&row), BridgeRule::Automatic), [[0; 2]; 0]);
    let shells: Vec<_> = [1.0, 0.98, 0.9].map(|radius| sphere([0.0; 3], radius)).into();
    assert_eq!(joined(&assembled(&shells), BridgeRule::Automatic), [[0; 2]; 0]);
    let inside = [cuboid([-1.0; 3], [1.0; 3]), sphere([0.2; 3], 0.5)];
    assert_eq!(joined(&assembled(&inside), BridgeRule::Automatic), [[0; 2]; 0]);
}

#[test]
fn wider_gaps_join_only_what_is_separate_still() {
    // The diagonal is about 5.5, and the fingers are apart by 2e-3 of it.
    let gap = 0.011;
    let fingers = [cuboid([-2.0, -1.0, 0.0], [2.0, -0.5 * gap, 0.3]), cuboid([-2.0, 0.5 * gap, 0.0], [2.0, 1.0, 0.3])];
    assert_eq!(joined(&assembled(&fingers), BridgeRule::Automatic), [[0, 1]]);
    let [first, second] = fingers;
    let palm = cuboid([1.8, -0.9, -0.1], [2.3, 0.9, 0.4]);
    let beside = cuboid([-2.0, 1.0 + gap, 0.0], [2.0, 2.0, 0.3]);
    let surface = assembled(&[first, second, palm, beside]);
    assert_eq!(joined(&surface, BridgeRule::Automatic), [[0, 2], [1, 2], [1, 3]]);
    assert_eq!(Bridges::find(&surface, BridgeRule::Automatic).group_count(), 1);
}

#[test]
fn a_distance_of_ones_own() {
    let parts = [sphere([0.0; 3], 1.0), sphere([0.0, 0.0, 2.25], 1.0), cuboid([-1.0, -1.0, 3.2], [1.0, 1.0, 4.0])];
    let surface = assembled(&parts);
    assert_eq!(joined(&surface, BridgeRule::Within(0.24)), [[1, 2]]);
    assert_eq!(joined(&surface, BridgeRule::Within(0.26)), [[0, 1], [1, 2]]);
    assert_eq!(joined(&surface, BridgeRule::Within(0.0)), [[1, 2]]);
    assert_eq!(joined(&surface, BridgeRule::Within(f64::NAN)), [[1, 2]]);
    // The box is 2.2 away from the first sphere, and the diagonal of all is 5.7.
    assert_eq!(joined(&surface, BridgeRule::Within(f64::INFINITY)), [[0, 1], [1, 2]]);
    assert_eq!(joined(&surface, BridgeRule::Off), [[0; 2]; 0]);
    let alone = assembled(&[sphere([0.0; 3], 1.0)]);
    assert_eq!(Bridges::find(&alone, BridgeRule::Automatic), Bridges::new(&alone, Vec::new()));
}

#[test]
fn neither_the_unit_nor_the_origin_matters() {
    let surface = assembled(&assembly());
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    let moves = [(1e-6, 0.0), (1e6, 0.0), (1e-150, 0.0), (1e150, 0.0), (1.0, 1e6), (1e-6, 100.0), (6e6, 1.5e11)];
    for (scale, offset) in moves {
        let moved = |&position: &DVec3| scale * position + DVec3::new(offset, -offset, 0.5 * offset);
        let other = surface.with_positions(surface.positions().iter().map(moved).collect());
        let found = Bridges::find(&other, BridgeRule::Automatic);
        assert_eq!(
            found.contacts().iter().map(|contact| contact.components).collect::<Vec<_>>(),
            joined(&surface, BridgeRule::Automatic),
            "{scale} {offset}"
        );
        let rounding = 1e-9 + f64::EPSILON * offset / scale;
        for contact in bridges.contacts() {
            let places = places(&surface, &bridges, contact.components);
            let moved_places = self::places(&other, &found, contact.components);
            let spacing = 0.0075 * 6.0;
            let ratio = moved_places.len() as f64 / places.len() as f64;
            assert!((0.8..1.25).contains(&ratio), "{ratio} at {scale} {offset}");
            assert!(
                places.iter().all(|place| nearest(&moved_places, moved(place)) < (1.5 * spacing + rounding) * scale)
            );
        }
    }
}

#[test]
fn what_is_found_once_is_found_again() {
    let surface = assembled(&assembly());
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    assert_eq!(bridges, Bridges::find(&surface.clone(), BridgeRule::Automatic));
}
