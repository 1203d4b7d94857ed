//! What is drawn of a file whose attributes belong to corners.

use std::sync::Arc;

use glam::DVec3;
use heatwalk::{Soup, Surface};
use heatwalk_model::appearance::Seams;
use heatwalk_model::{Appearance, Model};
use heatwalk_scene::{DrawTransform, draw_mesh};

/// A square whose second triangle is oriented the other way, with three rows of attributes at its first vertex and two at its third;
/// the texture coordinate of a row is its number.
fn square() -> Model {
    let corners = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];
    let positions = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let seams = Seams { vertices: vec![0, 1, 2, 3, 0, 2, 0], corners: vec![[4, 1, 2], [6, 3, 5]] };
    let texcoords = (0..7).map(|row| [row as f32, 0.0, 0.0, 0.0]).collect();
    let soup = Soup::single("square", positions, vec![[0, 1, 2], [0, 3, 2]]);
    Model { appearance: Arc::new(Appearance { texcoords, seams, ..Appearance::default() }), ..soup.into() }
}

#[test]
fn each_corner_is_drawn_with_its_own_row_and_stays_at_its_vertex() {
    let model = square();
    let surface = Surface::build(&model.soup).unwrap();
    assert_eq!(surface.report().flipped_faces, 1);
    let drawing = draw_mesh(&surface, &model.appearance, 1.0, &DrawTransform::IDENTITY);
    let (triangles, _) = drawing.triangles.as_chunks::<3>();
    for (triangle, drawn) in triangles.iter().enumerate() {
        let mut found = drawn.map(|vertex| drawing.texcoords[4 * vertex as usize] as u32);
        let inputs = drawn.map(|vertex| drawing.input_of_drawn[vertex as usize].0);
        assert_eq!(found.map(|row| model.appearance.seams.vertices[row as usize]), inputs, "triangle {triangle}");
        found.sort_unstable();
        let mut wanted = model.appearance.seams.corners[triangle];
        wanted.sort_unstable();
        assert_eq!(found, wanted, "triangle {triangle}");
    }
    assert_eq!(drawing.vertex_of_drawn.len(), 6, "vertices without a seam are drawn once");
}
