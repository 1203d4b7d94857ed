//! Small assemblies.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use heatwalk_base::parallel;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use glam::{DQuat, DVec3, EulerRot};

use super::*;
use crate::cracks::WeldRule;
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
        soup.add(positions.iter().copied(), triangles);
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

/// What a profile in the plane of y and z sweeps along x, 10 long, in so many steps, turned so that no axis is of use.
fn swept(profile: &[[f64; 2]], steps: u32) -> Shape {
    let turn = DQuat::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    let along = |step: u32| 10.0 * f64::from(step) / f64::from(steps);
    let row = |step: u32| profile.iter().map(move |&[y, z]| turn * DVec3::new(along(step), y, z));
    let count = profile.len() as u32;
    let quads =
        (0..steps).flat_map(|step| (1..count).map(move |place| [step * count + place - 1, step * count + place]));
    let triangles = quads.flat_map(|[a, b]| [[a, a + count, b + count], [a, b + count, b]]).collect();
    ((0..=steps).flat_map(row).collect(), triangles)
}

#[test]
fn rims_with_the_surface_between_them_are_no_crack() {
    // The lips of each are 0.005 apart at most, which is half of what contacts may be.
    let mut profiles: Vec<Vec<[f64; 2]>> = Vec::new();
    for degrees in [2.0_f64, 10.0, 40.0, 90.0, 150.0] {
        for parts in [1, 3] {
            for lip in [0.0, 0.00125] {
                let half = 0.0025 - lip;
                let depth = half / (0.5 * degrees).to_radians().tan();
                let shares = (-parts..=parts).map(|part| f64::from(part) / f64::from(parts));
                let groove = shares.map(|share| [half * share, depth * (share.abs() - 1.0)]);
                let beside = |side: f64| (lip > 0.0).then_some([0.0025 * side, 0.0]);
                profiles.push(beside(-1.0).into_iter().chain(groove).chain(beside(1.0)).collect());
            }
        }
    }
    for degrees in [60.0_f64, 120.0, 180.0, 240.0] {
        for parts in [4, 16] {
            let angles = (0..=parts).map(|part| degrees.to_radians() * (f64::from(part) / f64::from(parts) - 0.5));
            profiles.push(angles.map(|angle| [0.0025 * angle.sin(), -0.0025 * angle.cos()]).collect());
        }
    }
    // A box without a lid, and a ribbon.
    profiles.push(vec![[-0.0025, 0.1], [-0.0025, 0.0], [0.0025, 0.0], [0.0025, 0.1]]);
    profiles.push(vec![[-0.0025, 0.0], [0.0, 0.001], [0.0025, 0.0]]);
    for profile in profiles {
        for steps in [1, 10, 50] {
            let surface = assembled(&[swept(&profile, steps)]);
            let bridges = Bridges::find(&surface, BridgeRule::Automatic);
            assert_eq!(bridges.across_cracks().count(), 0, "{profile:?}, {steps} steps");
            assert_eq!(surface.report().crack_vertices, 0);
        }
    }
}

#[test]
fn rims_that_face_each_other_are_a_crack_and_are_told() {
    // A tube with a slit that is too wide to be welded.
    let gap = 4e-3;
    let angles = (0..=32).map(|part| (0.5 * gap) + (std::f64::consts::TAU - gap) * f64::from(part) / 32.0);
    let tube: Vec<[f64; 2]> = angles.map(|angle| [angle.cos(), angle.sin()]).collect();
    let surface = assembled(&[swept(&tube, 20)]);
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    assert!(bridges.across_cracks().count() >= 21 && (bridges.crack_width() - gap).abs() < 1e-6, "{bridges:?}");
    assert!(bridges.is_complete());
    assert_eq!(Bridges::find(&surface, BridgeRule::Off).crack_width(), 0.0);
}

/// Triangles on both sides of a slit, layer upon layer, that hang together at two vertices.
fn layered_slit(layers: u32) -> Surface {
    let spines = vec![DVec3::new(-1.0, 0.5, 0.0), DVec3::new(1.0, 0.5, 0.0), DVec3::new(0.0, 0.5, 3.0)];
    let mut soup = Soup::single("slit", spines, vec![[0, 1, 2]]);
    for side in [0, 1] {
        for layer in 0..layers {
            let (x, z) = (1e-4 * (2.0 * f64::from(side) - 1.0), 1e-3 * f64::from(layer) / f64::from(layers));
            let first = soup.positions.len() as u32;
            soup.positions.extend([DVec3::new(x, 0.0, z), DVec3::new(x, 1.0, z)]);
            soup.triangles.push(if side == 0 { [side, first, first + 1] } else { [side, first + 1, first] });
        }
    }
    Surface::build_by(&soup, WeldRule::Exact, parallel::ONE).expect("a surface")
}

#[test]
fn of_rims_that_all_face_each_other_so_many_portals_are_kept_as_fit_into_memory() {
    let [few, many] = [4, 100].map(|layers| Bridges::find(&layered_slit(layers), BridgeRule::Automatic));
    assert!(few.is_complete() && few.portals().len() > 100, "{}", few.portals().len());
    // A pair of sides has some hundred.
    assert!(!many.is_complete() && many.portals().len() < 200_000, "{}", many.portals().len());
}

/// So many triangles through the middle of a ball, each of which pierces nearly all others.
fn pierced(count: u32) -> Surface {
    let mut random = SplitMix64::seed_from_u64(7);
    let mut point = || DVec3::from_array([(); 3].map(|()| random.random_range(-1.0..1.0)));
    let mut shape = || {
        let [first, second, off] = [point(), point(), point()];
        vec![first, second, 0.1 * off - first - second]
    };
    assembled(&(0..count).map(|_| (shape(), vec![[0, 1, 2]])).collect::<Vec<_>>())
}

#[test]
fn of_parts_that_all_meet_a_few_contacts_each_are_found_and_that_is_told() {
    let [some, many] = [400, 1600].map(|count| Bridges::find(&pierced(count), BridgeRule::Automatic));
    assert!(!some.is_complete() && !many.is_complete());
    assert_eq!((some.group_count(), many.group_count()), (1, 1));
    // In proportion to the parts, and not to their pairs.
    let [of_some, of_many] = [&some, &many].map(|bridges| bridges.portals().len());
    assert!(of_many < 5 * of_some && of_many < 64 * 1600, "{of_some} {of_many}");
}

#[test]
fn what_is_beside_things_of_another_order_of_magnitude_takes_no_time() {
    let far = DVec3::new(2.5e18, 0.0, 0.0);
    let mut shapes: Vec<Shape> =
        (0..300).map(|number| cuboid([f64::from(number); 3], [f64::from(number) + 0.5; 3])).collect();
    shapes[0].0[0] = far;
    let tiny = |scale: f64| (vec![scale * DVec3::X, scale * DVec3::Y, scale * DVec3::Z], vec![[0, 1, 2]]);
    for surface in [assembled(&shapes), assembled(&[tiny(1e31), tiny(1.0), tiny(1e-20)])] {
        let bridges = Bridges::find(&surface, BridgeRule::Automatic);
        assert!(bridges.portals().len() < 100 * surface.face_count(), "{}", bridges.portals().len());
    }
}

#[test]
fn a_chair_whose_parts_miss_each_other_by_rounding_is_one_group() {
    let legs = [[0.0, 0.0], [0.41, 0.0], [0.0, 0.41], [0.41, 0.41]];
    let slats = [0.55, 0.68, 0.82];
    let mut parts = vec![([0.0, 0.0, 0.42], [0.45, 0.45, 0.46])];
    parts.extend(legs.map(|[x, y]| ([x, y, 0.0], [x + 0.04, y + 0.04, 0.42])));
    parts.extend([0.0, 0.41].map(|x| ([x, 0.41, 0.46], [x + 0.04, 0.45, 0.95])));
    parts.extend(slats.map(|z| ([0.04, 0.42, z], [0.41, 0.44, z + 0.06])));
    let turn = DQuat::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    // Of meters, down to millimeters.
    for digit in [1e-7, 1e-5, 1e-4, 1e-3] {
        let rounded = |position: DVec3| digit * (turn * position / digit).round();
        let shape = |&(low, high): &([f64; 3], [f64; 3])| {
            let (positions, triangles) = cuboid(low, high);
            (positions.into_iter().map(rounded).collect(), triangles)
        };
        let mut soup = Soup::default();
        for (positions, triangles) in parts.iter().map(shape) {
            let (first, positions): (u32, Vec<DVec3>) = (soup.positions.len() as u32, positions);
            let triangles: Vec<[u32; 3]> = triangles;
            soup.positions.extend(positions);
            soup.triangles.extend(triangles.iter().map(|triangle| triangle.map(|corner| first + corner)));
        }
        let surface = Surface::build(&soup).expect("a surface");
        let bridges = Bridges::find(&surface, BridgeRule::Automatic);
        assert_eq!(bridges.group_count(), 1, "{digit}");
    }
}
