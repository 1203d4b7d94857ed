//! Boxes and balls that stay apart.

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

use heatwalk_base::union_find::UnionFind;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::SplitMix64;

use glam::{DQuat, DVec3, EulerRot};

use crate::bridges::tests::{assembled, cuboid, sphere};
use crate::bridges::{BridgeRule, Bridges, Link, Portal};
use crate::surface::Surface;

/// What gaps may be off by rounding, where coordinates are below 100.
const ROUNDING: f64 = 1e-12;

fn links(surface: &Surface, rule: BridgeRule) -> Vec<Link> {
    Bridges::find(surface, rule).links(surface)
}

fn portals(link: &Link) -> impl Iterator<Item = &Portal> {
    link.contacts.iter().flat_map(|(_, portals)| portals)
}

fn diagonal(surface: &Surface) -> f64 {
    let [low, high] = [f64::min, f64::max].map(|pick| {
        [0, 1, 2].map(|k| surface.positions().iter().map(|position| position[k]).reduce(pick).expect("a vertex"))
    });
    [0, 1, 2].map(|k| (high[k] - low[k]).powi(2)).iter().sum::<f64>().sqrt()
}

#[test]
fn the_nearest_groups_are_linked_first() {
    let balls = [0.0, 2.5, 4.9, 7.2, 11.0].map(|x| sphere([x, 0.0, 0.0], 1.0));
    let surface = assembled(&balls);
    let links = links(&surface, BridgeRule::Automatic);
    assert_eq!(links.iter().map(|link| link.components).collect::<Vec<_>>(), [[2, 3], [1, 2], [0, 1], [3, 4]]);
    for (link, gap) in links.iter().zip([0.3, 0.4, 0.5, 1.8]) {
        assert!((link.gap - gap).abs() < ROUNDING, "{}", link.gap);
        let least = portals(link).map(|portal| portal.gap).fold(f64::INFINITY, f64::min);
        assert!((least - gap).abs() < ROUNDING, "{least} for {gap}");
        assert!(portals(link).all(|portal| portal.gap <= gap + 1e-3 * diagonal(&surface) + ROUNDING));
    }
    let bridges = Bridges::find(&surface, BridgeRule::Automatic);
    for count in 0..=links.len() {
        let linked = bridges.linked(&surface, &links[..count]);
        assert_eq!(linked.group_count(), 5 - count);
        assert_eq!(linked.contacts().len(), count);
        assert!(linked.links(&surface).iter().map(|link| link.gap).eq(links[count..].iter().map(|link| link.gap)));
    }
}

/// Boxes of random sizes at random places: their distances have a closed form, and so has the tree that joins them.
#[test]
fn links_are_a_minimum_spanning_tree() {
    const BOXES: usize = 60;
    let mut random = SplitMix64::seed_from_u64(3);
    let boxes: Vec<[[f64; 3]; 2]> = (0..BOXES)
        .map(|_| {
            let low = [0, 1, 2].map(|_| random.random_range(0.0..10.0));
            [low, low.map(|low| low + random.random_range(0.2..1.2))]
        })
        .collect();
    let distance = |a: usize, b: usize| {
        let along = |k: usize| (boxes[b][0][k] - boxes[a][1][k]).max(boxes[a][0][k] - boxes[b][1][k]).max(0.0);
        (along(0).powi(2) + along(1).powi(2) + along(2).powi(2)).sqrt()
    };
    let mut pairs: Vec<_> = (0..BOXES).flat_map(|b| (0..b).map(move |a| (distance(a, b), a, b))).collect();
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let sets = UnionFind::new(BOXES);
    let mut expected = Vec::new();
    for (gap, a, b) in pairs {
        let [a, b] = [a as u32, b as u32];
        if sets.least(a) != sets.least(b) {
            sets.join(a, b);
            expected.push(gap);
        }
    }
    let shapes: Vec<_> = boxes.iter().map(|&[low, high]| cuboid(low, high)).collect();
    let surface = assembled(&shapes);
    let bridges = Bridges::find(&surface, BridgeRule::Off);
    let links = bridges.links(&surface);
    assert_eq!(links.len(), BOXES - 1);
    for (link, gap) in links.iter().zip(expected) {
        assert!((link.gap - gap).abs() < ROUNDING, "{} for {gap}", link.gap);
        let [a, b] = link.components.map(|component| component as usize);
        // Boxes of which one is in the other are apart though the distance of what they fill is 0.
        assert!((distance(a, b) - gap).abs() < ROUNDING, "{a} {b}");
    }
    assert_eq!(bridges.linked(&surface, &links).group_count(), 1);
}

#[test]
fn a_table_is_linked_to_the_floor_by_all_its_legs() {
    let floor = cuboid([-2.0, -2.0, -1.0], [2.0, 2.0, -0.1]);
    let top = cuboid([-1.0, -1.0, 1.0], [1.0, 1.0, 1.1]);
    let leg = |x: f64, y: f64| cuboid([x - 0.1, y - 0.1, 0.0], [x + 0.1, y + 0.1, 1.05]);
    let parts = [floor, top, leg(0.8, 0.8), leg(-0.8, 0.8), leg(0.8, -0.8), leg(-0.8, -0.8)];
    let surface = assembled(&parts);
    let links = links(&surface, BridgeRule::Automatic);
    assert_eq!(links.len(), 1);
    let mut components: Vec<_> = links[0].contacts.iter().map(|&(components, _)| components).collect();
    components.sort_unstable();
    assert_eq!(components, [[0, 2], [0, 3], [0, 4], [0, 5]]);
    assert!(portals(&links[0]).all(|portal| (portal.gap - 0.1).abs() < ROUNDING));
}

#[test]
fn a_link_crosses_only_where_its_groups_are_nearest() {
    // The second bar rises from the first by a tenth of its length.
    let mut rising = cuboid([-1.0, -0.1, 0.0], [1.0, 0.1, 0.1]);
    for position in &mut rising.0 {
        position.z += 0.3 + 0.1 * (position.x + 1.0);
    }
    let surface = assembled(&[cuboid([-1.0, -0.1, -0.1], [1.0, 0.1, 0.0]), rising]);
    let links = links(&surface, BridgeRule::Automatic);
    assert_eq!(links.len(), 1);
    // Feet of perpendiculars are nearer by 0.5 % and displaced by a tenth of the gap.
    let most = -1.0 + 10.0 * (1e-3 * diagonal(&surface) + 0.005 * 0.3) + 0.1 * 0.31;
    for portal in portals(&links[0]) {
        assert!(portal.ends.iter().all(|end| end.position(&surface).x <= most));
    }
}

#[test]
fn without_bridges_what_pierces_is_linked_over_no_gap() {
    let surface = assembled(&[cuboid([-1.0; 3], [1.0; 3]), cuboid([0.0; 3], [2.0; 3]), sphere([9.0, 0.0, 0.0], 1.0)]);
    let links = links(&surface, BridgeRule::Off);
    assert_eq!(links.iter().map(|link| link.components).collect::<Vec<_>>(), [[0, 1], [1, 2]]);
    assert_eq!(links[0].gap, 0.0);
    assert!(portals(&links[0]).count() > 10);
}

#[test]
fn what_is_one_group_has_no_links() {
    let surface = assembled(&[cuboid([-1.0; 3], [1.0; 3]), cuboid([0.0; 3], [2.0; 3])]);
    assert_eq!(links(&surface, BridgeRule::Automatic), []);
    assert_eq!(Bridges::default().links(&surface), []);
}

/// Two squares of slivers across each other, one near above the other, at an angle to all axes: all their boxes overlap.
fn slivers(count: u32) -> Surface {
    let turn = DQuat::from_euler(EulerRot::XYZ, 0.3, 0.7, 1.1);
    let square = |height: f64, quarter: f64| {
        let turn = turn * DQuat::from_rotation_z(quarter);
        let corner = |number: u32| {
            let x = f64::from(number / 2) / f64::from(count) - 0.5;
            turn * DVec3::new(x, f64::from(number % 2) - 0.5, height)
        };
        let strip = |column: u32| {
            let first = 2 * column;
            [[first, first + 2, first + 1], [first + 1, first + 2, first + 3]]
        };
        ((0..2 * count + 2).map(corner).collect(), (0..count).flat_map(strip).collect())
    };
    assembled(&[square(0.0, 0.0), square(0.01, 1.5)])
}

#[test]
fn of_slivers_across_each_other_a_link_is_found_within_the_budget_and_that_is_told() {
    for (count, is_complete) in [(20, true), (1000, false)] {
        let surface = slivers(count);
        let bridges = Bridges::find(&surface, BridgeRule::Off);
        let links = bridges.links(&surface);
        assert_eq!(links.len(), 1);
        assert_eq!(links[0].is_complete, is_complete);
        assert!((links[0].gap - 0.01).abs() < 1e-4, "{}", links[0].gap);
        let linked = bridges.linked(&surface, &links);
        assert_eq!((linked.group_count(), linked.is_complete()), (1, is_complete));
    }
}
