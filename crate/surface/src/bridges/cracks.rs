//! Cracks within a component: boundary edges that run along each other, where vertices of one side lie inside edges of the other
//! (T-junctions). Welding closes cracks whose vertices come together; here portals lead across the others.

use std::collections::HashSet;

use glam::DVec3;
use heatwalk_base::parallel;
use heatwalk_base::sort;

use super::Portal;
use super::scene::{Scene, cuts};
use super::triangles::{nearest_on_segment, on_side};
use crate::element::{FaceId, HalfedgeId};
use crate::index::{Bounds, Tree, along_curve};
use crate::point::Place;
use crate::triangle::unit;

/// Edges on both sides of a crack are apart by this share of the longer one at most: as far as an arc of 20° is from its chord.
const OF_EDGE: f64 = 0.05;

/// Cosine of the angle from which on edges do not run along each other: 30°.
const ALONG: f64 = 0.866;

/// Triangles on the same side of an edge, with more than this cosine between them (30°), are layers and not the two sides of a
/// crack.
const LAYERED: f64 = 0.866;

/// Edges that are apart by this share of the altitudes of their triangles have no surface between them, unless it is folded by
/// less than 6°: these are layers.
const TIGHT: f64 = 0.05;

/// Triangles on both sides of a crack that is not as tight point away from each other, with this cosine between them at most
/// (120°). Those on the walls of a groove do not.
const OPPOSED: f64 = -0.5;

/// In the plane of each triangle, the other edge is before or behind its own by this share of its altitude at most. Across a
/// strip, it is behind by all of it or more.
const OF_ALTITUDE: f64 = 0.5;

/// Edges that run along each other over less than this share of the shorter one only meet at their ends.
const MEETING: f64 = 1e-3;

/// Pairs of edges that are looked at, of a boundary of so many edges: so many, and so many an edge. Where a crack is, each edge
/// has a few beside it.
const PAIRS: usize = 1 << 20;
const PAIRS_OF_EDGE: usize = 64;

/// A portal that is found counts as so many pairs, so that all of them fit into memory.
const PAIRS_OF_PORTAL: usize = 8;

/// Portals along a crack are this share of the usual spacing apart, since all that crosses has to pass through one.
const OF_SPACING: f64 = 0.5;

/// Edges of a leaf.
const LEAF: usize = 4;

/// A boundary edge.
struct Rim {
    halfedge: HalfedgeId,
    component: u32,
    ends: [DVec3; 2],
    /// Unit vector along it.
    along: DVec3,
    length: f64,
    /// Unit vector at right angles to it, to where its triangle lies.
    side: DVec3,
    /// How far the triangle reaches there.
    altitude: f64,
}

impl Rim {
    fn new(scene: &Scene, halfedge: HalfedgeId) -> Self {
        let (face, k) = (halfedge.triangle(), halfedge.corner());
        let corners = scene.triangle(face.0);
        let ends = [corners[k], corners[(k + 1) % 3]];
        let along = unit(ends[1] - ends[0]);
        let side = scene.normal(face.0).cross(along);
        Self {
            halfedge,
            component: scene.surface.component(scene.surface.faces()[face][0]),
            ends,
            along,
            length: ends[0].distance(ends[1]),
            side,
            altitude: side.dot(corners[(k + 2) % 3] - ends[0]),
        }
    }

    /// How far from it another edge along it may be.
    fn reach(&self, most: f64) -> f64 {
        most.min(OF_EDGE * self.length)
    }

    /// Whether another edge beside it, `gap` away from its own, lies on the other side of a crack.
    fn faces(&self, other: &Self, gap: DVec3) -> bool {
        let is_near = |rim: &Self| rim.side.dot(gap).abs() <= OF_ALTITUDE * rim.altitude;
        let is_tight = gap.length() <= TIGHT * self.altitude.min(other.altitude);
        is_tight || (self.side.dot(other.side) <= OPPOSED && is_near(self) && is_near(other))
    }

    fn at(&self, share: f64) -> DVec3 {
        self.ends[0] + (self.ends[1] - self.ends[0]) * share
    }

    fn place(&self, scene: &Scene, share: f64) -> Place {
        let face: FaceId = self.halfedge.triangle();
        Place::Face { face, weights: on_side(self.halfedge.corner(), share) }.snapped(scene.surface)
    }
}

/// Portals within each component that has some.
type Across = Vec<([u32; 2], Vec<Portal>)>;

/// The portals across the cracks within components; and whether these are all, or there is too much to look at.
/// `most`: how wide cracks may be, as a share of the diagonal of the scene.
pub fn across_cracks(scene: &Scene, most: f64) -> (Across, bool) {
    let surface = scene.surface;
    let halfedges = (0..3 * surface.face_count() as u32).map(HalfedgeId);
    let boundary = halfedges.filter(|&halfedge| surface.edges().is_single(halfedge));
    let rims: Vec<Rim> = boundary.map(|halfedge| Rim::new(scene, halfedge)).collect();
    if rims.is_empty() {
        return (Vec::new(), true);
    }
    let middle = |index: usize| rims[index].at(0.5);
    let order = along_curve(rims.len(), middle, parallel::ONE);
    let rims: Vec<&Rim> = order.into_iter().map(|index| &rims[index as usize]).collect();
    let mut found: Vec<([u32; 2], HalfedgeId, Portal)> = Vec::new();
    let reach = |rim: &Rim| rim.reach(most) + scene.rounding;
    let are_all = for_pairs(&rims, reach, &mut |first, second| {
        // The one that comes first in the surface, so that the order of the search makes no difference.
        let [first, second] = if first.halfedge < second.halfedge { [first, second] } else { [second, first] };
        let components = [first.component; 2];
        let before = found.len();
        portals_between(scene, [first, second], most, &mut |portal| found.push((components, first.halfedge, portal)));
        found.len() - before
    });
    sort::sort_by_key(&mut found, |&(components, halfedge, _)| (components, halfedge));
    // Both edges at a vertex tell of it.
    let mut known = HashSet::new();
    found.retain(|(.., portal)| {
        let [a, b] = portal.ends.map(number);
        let is_at_vertex = portal.ends.iter().any(|end| matches!(end, Place::Vertex(_)));
        !is_at_vertex || known.insert([a.min(b), a.max(b)])
    });
    let contacts = found.chunk_by(|a, b| a.0 == b.0);
    (contacts.map(|own| (own[0].0, own.iter().map(|&(.., portal)| portal).collect())).collect(), are_all)
}

/// What tells the vertex, the edge or the face of a place from others.
fn number(place: Place) -> (u8, u32) {
    match place {
        Place::Vertex(vertex) => (0, vertex.0),
        Place::Edge { halfedge, .. } => (1, halfedge.0),
        Place::Face { face, .. } => (2, face.0),
    }
}

/// Shows each edge with those beside it that are no longer, as far as it reaches. Returns whether these were all, or too many.
/// `found`: how many portals it makes.
fn for_pairs<'a>(
    rims: &[&'a Rim],
    reach: impl Fn(&Rim) -> f64,
    found: &mut impl FnMut(&'a Rim, &'a Rim) -> usize,
) -> bool {
    let tree = Tree::<2, LEAF>::new(rims.len());
    let of_leaf = |leaf: &[&Rim]| Bounds::of_points(leaf.iter().flat_map(|rim| rim.ends));
    let boxes = tree.values(|leaf| of_leaf(&rims[leaf]), Bounds::around);
    let mut left = PAIRS_OF_EDGE.saturating_mul(rims.len()).saturating_add(PAIRS);
    for &rim in rims {
        let own = Bounds::of_points(rim.ends);
        let squared = reach(rim).powi(2);
        for leaf in tree.leaves(|node| boxes[node].squared_distance(own) <= squared) {
            if left == 0 {
                return false;
            }
            left -= 1;
            for &other in &rims[leaf] {
                let is_no_longer = (other.length, other.halfedge) < (rim.length, rim.halfedge);
                if is_no_longer && other.component == rim.component {
                    left = left.saturating_sub(PAIRS_OF_PORTAL * found(rim, other));
                }
            }
        }
    }
    true
}

/// The portals between two edges, where these run along each other.
fn portals_between(scene: &Scene, [first, second]: [&Rim; 2], most: f64, found: &mut impl FnMut(Portal)) {
    let shorter = first.length.min(second.length);
    let within = first.reach(most).max(second.reach(most)) + scene.rounding;
    if first.along.dot(second.along).abs() < ALONG || first.side.dot(second.side) > LAYERED {
        return;
    }
    let shares = second.ends.map(|end| nearest_on_segment(end, first.ends));
    let (enters, leaves) = (shares[0].min(shares[1]), shares[0].max(shares[1]));
    let length = (leaves - enters) * first.length;
    if length <= MEETING * shorter {
        return;
    }
    let spacing = OF_SPACING * scene.spacing([first.component; 2]);
    // Where both ends of what runs along each other are near, all between is.
    let apart = |share: f64| {
        let point = first.at(share);
        second.at(nearest_on_segment(point, second.ends)) - point
    };
    let gaps = [apart(enters), apart(leaves)];
    let is_crack =
        |gap: &DVec3| gap.length() <= within && (gap.length() <= scene.rounding || first.faces(second, *gap));
    if !gaps.iter().all(is_crack) {
        return;
    }
    let cuts = cuts(length, spacing);
    for cut in 0..=cuts {
        let share = if cut == cuts { leaves } else { enters + (leaves - enters) * f64::from(cut) / f64::from(cuts) };
        let point = first.at(share);
        let other = nearest_on_segment(point, second.ends);
        let ends = [first.place(scene, share), second.place(scene, other)];
        if ends[0] != ends[1] {
            let [start, end] = ends.map(|place| scene.point(place));
            found(Portal { ends, gap: scene.in_file_unit(start.distance(end)) });
        }
    }
}
