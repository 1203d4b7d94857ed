//! The types of elements.

use crate::io::cells::{Kind, Shape};

/// What is known of a type.
#[derive(Debug, Clone, Copy)]
pub struct Element {
    pub kind: Kind,
    /// The corners come first.
    pub nodes: usize,
}

/// By its number (Gmsh reference manual, "MSH file format"; those of higher order in its file `GmshDefines.h`).
pub fn element(kind: i64) -> Option<Element> {
    let thin = |nodes| Element { kind: Kind::Thin, nodes };
    let triangle = |nodes| Element { kind: Kind::Face(3), nodes };
    let quadrilateral = |nodes| Element { kind: Kind::Face(4), nodes };
    let solid = |shape, nodes| Element { kind: Kind::Solid(shape), nodes };
    Some(match kind {
        15 => thin(1),
        1 => thin(2),
        8 => thin(3),
        26 => thin(4),
        27 => thin(5),
        28 => thin(6),
        2 => triangle(3),
        9 => triangle(6),
        20 => triangle(9),
        21 => triangle(10),
        22 => triangle(12),
        23 | 24 => triangle(15),
        25 => triangle(21),
        3 => quadrilateral(4),
        10 => quadrilateral(9),
        16 => quadrilateral(8),
        36 => quadrilateral(16),
        37 => quadrilateral(25),
        38 => quadrilateral(36),
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
