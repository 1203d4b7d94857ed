/// Why an image cannot be decoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// The file is none of KTX 2.0, or damaged where it says what it holds.
    #[error("it is no intact KTX 2.0 file of a Basis Universal image")]
    Header,
    /// The file holds a cube, an array, or colors of a wider range than textures of glTF have.
    #[error("it is not one image in ETC1S or UASTC, as textures of glTF are")]
    Kind,
    /// Neither the image nor a smaller copy of it in the file can be decoded.
    #[error("it has {0} × {1} texels; 8192 either way are the most")]
    TooLarge(u32, u32),
    /// The texels are damaged or end early.
    #[error("its texels are damaged")]
    Texels,
}
