//! The types of elements.

use crate::io::cells::Shape;

/// What is known of a type.
#[derive(Debug, Clone, Copy)]
pub struct Element {
    /// None of points, lines and faces.
    pub shape: Option<Shape>,
    pub is_face: bool,
    /// The corners come first.
    pub nodes: usize,
}

/// By its number (Gmsh reference manual, "MSH file format"; those of higher order in its file `GmshDefines.h`).
pub fn element(kind: i64) -> Option<Element> {
    let thin = |nodes| Element { shape: None, is_face: false, nodes };
    let face = |nodes| Element { shape: None, is_face: true, nodes };
    let solid = |shape, nodes| Element { shape: Some(shape), is_face: false, nodes };
    Some(match kind {
        15 => thin(1),
        1 => thin(2),
        8 => thin(3),
        26 => thin(4),
        27 => thin(5),
        28 => thin(6),
        2 => face(3),
        9 => face(6),
        20 => face(9),
        21 => face(10),
        22 => face(12),
        23 | 24 => face(15),
        25 => face(21),
        3 => face(4),
        10 => face(9),
        16 => face(8),
        36 => face(16),
        37 => face(25),
        38 => face(36),
        4 => solid(Shape::Tetrahedron, 4),
        11 => solid(Shape::Tetrahedron, 10),
        29 => solid(Shape::Tetrahedron, 20),
        30 => solid(Shape::Tetrahedron, 35),
        31 => solid(Shape::Tetrahedron, 56),
        5 => solid(Shape::Hexahedron, 8),
        12 => solid(Shape::Hexahedron, 27),
        17 => solid(Shape::Hexahedron, 20),
        92 => solid(Shape::Hexahedron, 64),
        93 => solid(Shape::Hexahedron, 125),
        6 => solid(Shape::Prism, 6),
        13 => solid(Shape::Prism, 18),
        18 => solid(Shape::Prism, 15),
        90 => solid(Shape::Prism, 40),
        91 => solid(Shape::Prism, 75),
        7 => solid(Shape::Pyramid, 5),
        14 => solid(Shape::Pyramid, 14),
        19 => solid(Shape::Pyramid, 13),
        118 => solid(Shape::Pyramid, 30),
        119 => solid(Shape::Pyramid, 55),
        _ => return None,
    })
}
