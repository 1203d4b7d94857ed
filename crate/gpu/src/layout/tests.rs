use glam::DVec3;
use heatwalk::Soup;
use heatwalk_shapes as shapes;

use super::*;

fn surface(soup: &Soup) -> Arc<Surface> {
    Arc::new(Surface::build(soup).expect("a surface"))
}

/// Layouts of a body, a sheet with a boundary, and triangles that are not connected, by small and by large patches.
fn layouts() -> Vec<Layout> {
    let mut apart = Soup::default();
    for triangle in 0..150 {
        let first = DVec3::new(f64::from(triangle % 13), 0.3 * f64::from(triangle), f64::from(triangle % 7));
        apart.add([first, first + DVec3::X, first + DVec3::Y], &[[0, 1, 2]]);
    }
    let soups = [shapes::torus(2.0, 0.7, 40, 20), shapes::grid(17, 23), shapes::horse(0.06), apart];
    let of_both = |soup: &Soup| {
        let surface = surface(soup);
        [PatchSize::Small, PatchSize::Large].map(|size| Layout::with_patches(&surface, size).expect("manifold"))
    };
    soups.iter().flat_map(of_both).collect()
}

#[test]
fn patches_hold_each_face_once_and_no_more_than_fits() {
    for layout in layouts() {
        let mut next = 0;
        for patch in &layout.patches {
            assert_eq!(patch.first_face, next);
            next += patch.face_count;
            let sizes = [patch.face_count, patch.edge_count, patch.vertex_count].map(|size| size as usize);
            let Capacity { faces, edges, vertices } = layout.capacity;
            assert!(sizes[0] > 0 && sizes[0] <= faces && sizes[1] <= edges && sizes[2] <= vertices, "{sizes:?}");
        }
        assert_eq!(next as usize, layout.faces.len());
        let mut places = layout.place_of_face.clone();
        places.sort_unstable();
        assert!(places.into_iter().eq(0..next));
    }
}

#[test]
fn a_capacity_of_96_faces_is_used() {
    let layout = Layout::with_patches(&surface(&shapes::grid(40, 40)), PatchSize::Large).expect("manifold");
    assert_eq!(layout.patches.iter().map(|patch| patch.face_count).max(), Some(96));
}

/// The half-edge, as patches count all of them, that lies across a side of a face of a patch.
fn across(layout: &Layout, patch: &PatchRecord, place: u32, k: usize) -> Option<u32> {
    match layout.faces[place as usize].neighbors[k] {
        NONE => None,
        local if local & LEAVING == 0 => Some(3 * patch.first_face + local),
        leaving => {
            let own = patch.edges as usize + 3 * (leaving - LEAVING) as usize;
            let [_, behind, edge] = layout.tables[own..own + 3] else { unreachable!("three numbers") };
            let behind = &layout.patches[behind as usize];
            let there = behind.edges as usize + 3 * (edge - behind.first_edge) as usize;
            Some(3 * behind.first_face + layout.tables[there])
        }
    }
}

#[test]
fn what_lies_across_a_side_has_that_side_across() {
    for layout in layouts() {
        let patch_of =
            |place: u32| layout.patches.iter().rfind(|patch| patch.first_face <= place).expect("the first begins at 0");
        let mut open = 0;
        for halfedge in 0..3 * layout.faces.len() as u32 {
            let (place, k) = (halfedge / 3, halfedge as usize % 3);
            let Some(twin) = across(&layout, patch_of(place), place, k) else {
                open += 1;
                continue;
            };
            let back = across(&layout, patch_of(twin / 3), twin / 3, twin as usize % 3);
            assert_eq!(back, Some(halfedge));
            let length = |halfedge: u32| layout.faces[halfedge as usize / 3].lengths[halfedge as usize % 3];
            assert_eq!(length(halfedge), length(twin));
            assert_eq!(ends(&layout, halfedge), ends(&layout, twin).map(|[a, b]| [b, a]));
        }
        let boundary = layout.surface.edges().representatives().filter(|&edge| layout.surface.edges().is_single(edge));
        assert_eq!(open, boundary.count());
    }
}

/// The vertices of a half-edge by the tables.
fn ends(layout: &Layout, halfedge: u32) -> Option<[u32; 2]> {
    let (place, k) = (halfedge / 3, halfedge % 3);
    let patch = layout.patches.iter().rfind(|patch| patch.first_face <= place)?;
    let corner = |k: u32| {
        let local = (layout.faces[place as usize].corners >> (CORNER_BITS * k)) & ((1 << CORNER_BITS) - 1);
        layout.tables[(patch.vertices + 2 * local) as usize]
    };
    Some([corner(k), corner((k + 1) % 3)])
}

#[test]
fn a_vertex_knows_all_patches_around_it() {
    for layout in layouts() {
        for (number, patch) in (0..).zip(&layout.patches) {
            for local in 0..patch.vertex_count {
                let at = (patch.vertices + 2 * local) as usize;
                let around = layout.patches_around(layout.tables[at]);
                assert!(around.contains(&number));
                match layout.tables[at + 1] {
                    NONE => assert_eq!(around.len(), 1),
                    list => {
                        let list = list as usize;
                        let listed = &layout.tables[list + 1..=list + layout.tables[list] as usize];
                        assert_eq!(listed, around);
                    }
                }
            }
        }
    }
}

/// Corners laid out by the records of a face have the distances of the vertices, where the sheet is flat.
#[test]
fn triangles_keep_the_metric_of_a_flat_sheet() {
    let mut sheared = shapes::grid(20, 20);
    sheared.positions.iter_mut().for_each(|position| position.x += 1.7 * position.z);
    for (soup, is_flipped) in [(shapes::grid(20, 20), false), (sheared, true)] {
        let surface = surface(&soup);
        let layout = Layout::new(&surface).expect("manifold");
        let mut flips = 0;
        for halfedge in 0..3 * layout.faces.len() as u32 {
            let [a, b] = ends(&layout, halfedge).expect("in a patch").map(heatwalk::VertexId);
            let face = &layout.faces[halfedge as usize / 3];
            let k = halfedge as usize % 3;
            let length = surface.position(a).distance(surface.position(b)) / layout.mean_edge;
            // Rounding of single precision, and of mollified lengths.
            assert!((f64::from(face.lengths[k]) - length).abs() < 1e-5, "{} for {length}", face.lengths[k]);
            let [before, opposite] = [(k + 2) % 3, (k + 1) % 3].map(|k| face.lengths[k]);
            let by_cosine = face.lengths[k].powi(2) + before.powi(2) - 2.0 * face.lengths[k] * before * face.cosines[k];
            assert!((by_cosine - opposite.powi(2)).abs() < 1e-5);
            let sine = (1.0 - face.cosines[k].powi(2)).sqrt();
            assert!((face.area - sine * face.lengths[k] * before).abs() < 1e-5);
            flips += usize::from(surface.halfedge_between(a, b).is_none());
        }
        assert_eq!(flips > 0, is_flipped);
    }
}

#[test]
fn edges_that_are_not_manifold_are_counted_once() {
    // Three triangles around one edge, and two on a Möbius strip's only edge that cannot agree.
    let [a, b] = [DVec3::ZERO, DVec3::Z];
    let tips = [DVec3::X, DVec3::Y, DVec3::NEG_X];
    let positions = [a, b].into_iter().chain(tips).collect();
    let book = Soup::single("book", positions, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
    assert_eq!(Layout::new(&surface(&book)).expect_err("three faces"), Error::NotManifold { edges: 1 });
    let mut strip = Soup::default();
    let n = 12;
    for i in 0..n {
        let turn = std::f64::consts::TAU * f64::from(i) / f64::from(n);
        let (sin, cos) = (0.5 * turn).sin_cos();
        let rim = |across: f64| {
            let radius = 2.0 + across * sin;
            DVec3::new(radius * turn.cos(), radius * turn.sin(), across * cos)
        };
        strip.positions.extend([rim(-0.5), rim(0.5)]);
    }
    let vertex = |i: u32, side: u32| 2 * (i % n) + if i == n { 1 - side } else { side };
    for i in 0..n {
        let [a, b, c, d] = [vertex(i, 0), vertex(i + 1, 0), vertex(i + 1, 1), vertex(i, 1)];
        strip.triangles.extend([[a, b, c], [a, c, d]]);
    }
    let triangles = strip.triangles.clone();
    let strip = Soup::single("strip", strip.positions, triangles);
    assert_eq!(Layout::new(&surface(&strip)).expect_err("one side"), Error::NotManifold { edges: 1 });
}

#[test]
fn lengths_beyond_single_precision_are_refused() {
    let mut soup = shapes::grid(3, 3);
    soup.positions.iter_mut().for_each(|position| *position *= 1e40);
    assert!(matches!(Layout::new(&surface(&soup)), Err(Error::UnitOutOfRange { .. })));
}
