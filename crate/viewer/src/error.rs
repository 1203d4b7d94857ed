use thiserror::Error;

/// Why the viewer cannot do what it was asked; each message is a sentence fit for the page.
#[derive(Debug, Error)]
pub enum Error {
    /// Neither WebGPU nor WebGL2 gave a usable adapter.
    #[error(
        "This browser offers neither WebGPU nor WebGL2. Turn on hardware acceleration or try another browser. ({reason})"
    )]
    NoAdapter {
        /// What the last attempt answered.
        reason: String,
    },
    /// The adapter was found, but gave no device.
    #[error("The graphics device could not be opened. Close other 3D pages and reload this one. ({reason})")]
    NoDevice {
        /// What the adapter answered.
        reason: String,
    },
    /// The canvas cannot be drawn to.
    #[error("The canvas cannot be used for drawing. Reload the page. ({reason})")]
    NoCanvas {
        /// What the canvas answered.
        reason: String,
    },
    /// One buffer of a mesh is larger than the device allows.
    #[error(
        "The mesh is too large for this graphics device: its {what} need {} MB in one buffer, {} MB are allowed. \
         Simplify the mesh or switch the backend.",
        .bytes.div_ceil(1_000_000),
        .limit / 1_000_000
    )]
    MeshTooLarge {
        /// Which array.
        what: &'static str,
        /// Bytes needed.
        bytes: u64,
        /// Bytes allowed in one buffer.
        limit: u64,
    },
    /// A picture is larger than the device can draw.
    #[error(
        "A picture of {width} × {height} pixels is too large for this graphics device: {limit} along a side are allowed. Choose a smaller one."
    )]
    PictureTooLarge {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
        /// Pixels allowed along a side.
        limit: u32,
    },
    /// Arrays that belong together differ in length.
    #[error("The {what} hold {found} numbers where {expected} were expected.")]
    WrongLength {
        /// Which array.
        what: &'static str,
        /// Numbers expected.
        expected: usize,
        /// Numbers given.
        found: usize,
    },
    /// A triangle names a vertex that does not exist.
    #[error("Triangle {triangle} refers to vertex {vertex}, but there are only {vertex_count} vertices.")]
    VertexOutOfRange {
        /// The offending triangle.
        triangle: usize,
        /// The vertex it names.
        vertex: u32,
        /// Vertices present.
        vertex_count: usize,
    },
    /// A component is infinite or not a number.
    #[error("The {what} hold a vector, number {index}, that is not finite.")]
    NotFinite {
        /// Which array.
        what: &'static str,
        /// The offending vector.
        index: usize,
    },
    /// A coordinate is too large to be drawn in single precision.
    #[error("The {what} hold a place, number {index}, with a coordinate too large to be drawn. Centre and scale them.")]
    OutOfRange {
        /// Which array.
        what: &'static str,
        /// The offending place.
        index: usize,
    },
    /// A number is infinite, negative or not a number.
    #[error("The {what} is not a finite number of 0 or more.")]
    NoNumber {
        /// Which number.
        what: &'static str,
    },
    /// The device has no memory left.
    #[error(
        "The graphics device is out of memory, so the picture is incomplete. Close other 3D pages or open a smaller mesh."
    )]
    OutOfMemory,
    /// The device refused a step of drawing.
    #[error(
        "The graphics device refused a step, so the picture may be incomplete. Reload the page if it stays so. ({reason})"
    )]
    Refused {
        /// What the device says.
        reason: String,
    },
}
