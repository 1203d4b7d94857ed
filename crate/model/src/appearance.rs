//! How a file wants its triangles to look: attributes of vertices, materials, images. Nothing here changes a distance.

use std::ops::Range;

use glam::Vec3;
use heatwalk_surface::{Element, InputTriangle, InputVertex};

/// Attributes have one row an input vertex, or none at all where no vertex has that attribute. Where [`seams`](Self::seams)
/// says that vertices have several, their further rows come after those of all vertices.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Appearance {
    /// `#R`, two sets of texture coordinates: u and v of the first, then of the second; (0, 0) is an image's upper left corner.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::plain"))]
    pub texcoords: Vec<[f32; 4]>,
    /// `#R`, linear red, green, blue and alpha, 65535 for 1.
    pub colors: Vec<[u16; 4]>,
    /// `#R`, unit vectors; zero at vertices that have none.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::plain"))]
    pub normals: Vec<Vec3>,
    /// Which rows corners have.
    pub seams: Seams,
    /// Consecutive triangles of one material, in the order of the triangles, which they cover without gap or overlap; none where
    /// no triangle has a material.
    pub runs: Vec<Run>,
    /// In the order of the file.
    pub materials: Vec<Material>,
    /// Those that materials use.
    pub images: Vec<Image>,
    /// What the file refers to and was not given, as the file calls it.
    pub missing: Vec<String>,
}

/// Vertices with several rows of attributes: in some formats, corners at one vertex may have different ones. Empty where each
/// vertex has one row, of its own number.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Seams {
    /// `#R`, the input vertex of each row; the first `#V` rows are the vertices in their order.
    pub vertices: Vec<u32>,
    /// `#F × 3`, the row at each corner of the soup's triangles.
    pub corners: Vec<[u32; 3]>,
}

/// Consecutive triangles of one material.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Run {
    /// A range of the triangles.
    pub triangles: Range<usize>,
    /// Index of its material; None for the default one.
    pub material: Option<usize>,
}

/// A material in the metallic-roughness model of glTF 2.0 (3.9). Each texture is a factor on the number beside it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Material {
    /// Linear red, green, blue and alpha.
    pub base_color: [f32; 4],
    /// 0 is a dielectric, 1 a metal.
    pub metalness: f32,
    /// 0 is a mirror, 1 is matt.
    pub roughness: f32,
    /// Linear red, green and blue of the light given off; may be above 1.
    pub emission: [f32; 3],
    /// Factor on the slope of the normal texture.
    pub normal_scale: f32,
    /// How much of the occlusion texture is applied, 0 to 1.
    pub occlusion_strength: f32,
    /// What alpha means.
    pub alpha: Alpha,
    /// Shown in its base color, whatever the light.
    pub is_unlit: bool,
    /// Seen from behind as well.
    pub is_double_sided: bool,
    /// Where a channel has one, in the order of [`Channel`].
    pub textures: [Option<Texture>; Channel::COUNT],
    /// What is not shown but written again: the name and the JSON of each further extension of the glTF material (`KHR_materials_…`),
    /// where it has no texture of its own.
    pub further: Vec<(String, String)>,
}

impl Default for Material {
    fn default() -> Self {
        Self {
            base_color: [1.0; 4],
            metalness: 1.0,
            roughness: 1.0,
            emission: [0.0; 3],
            normal_scale: 1.0,
            occlusion_strength: 1.0,
            alpha: Alpha::Opaque,
            is_unlit: false,
            is_double_sided: false,
            textures: Default::default(),
            further: Vec::new(),
        }
    }
}

/// What a texture of a material says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Channel {
    /// sRGB color and linear alpha.
    BaseColor,
    /// Roughness in green, metalness in blue.
    MetallicRoughness,
    /// Tangent-space normal.
    Normal,
    /// Share of the indirect light that arrives, in red.
    Occlusion,
    /// sRGB color of the light given off.
    Emission,
}

impl Channel {
    /// How many there are.
    pub const COUNT: usize = 5;
}

/// What the alpha of the base color means.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Alpha {
    /// Nothing.
    Opaque,
    /// Below this value nothing is drawn, elsewhere the surface is opaque.
    Mask(f32),
    /// The share of the light that the surface keeps from what is behind it.
    Blend,
}

/// How a channel of a material uses an image.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Texture {
    /// Index of the image.
    pub image: usize,
    /// Which set of texture coordinates, 0 or 1.
    pub set: usize,
    /// Rows of the affine map from (u, v, 1) of the vertices to the image.
    pub transform: [[f32; 3]; 2],
    /// Beyond the image along u and v.
    pub wrap: [Wrap; 2],
    /// Whether magnified texels keep sharp edges.
    pub is_sharp: bool,
}

impl Texture {
    /// The transform that changes nothing.
    pub const IDENTITY: [[f32; 3]; 2] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
}

/// What is beyond an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Wrap {
    /// The image again.
    Repeat,
    /// The image again, mirrored each time.
    Mirror,
    /// Its border.
    Clamp,
}

/// An image, encoded as in the file, or made of such.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Image {
    /// What the file calls it; empty where it does not say.
    pub name: String,
    /// Media type, `image/png`; empty where the file does not say.
    pub media_type: String,
    /// The encoded image; empty where it could not be found, or is made of others.
    #[cfg_attr(feature = "packed", serde(with = "heatwalk_base::packed::plain"))]
    pub bytes: Vec<u8>,
    /// How its texels are found.
    pub texels: Texels,
}

/// How the texels of an image are found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub enum Texels {
    /// By decoding its bytes.
    #[default]
    Encoded,
    /// By decoding its bytes; where these are shades of gray they are heights, and the texels the normals of them.
    Heights,
    /// Red, green, blue and alpha are each a channel, 0 to 3, of an image of this index; 1 where there is none.
    Channels([Option<(usize, usize)>; 4]),
}

impl Appearance {
    /// Whether the file says nothing.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.colors.is_empty() && self.normals.is_empty() && self.runs.is_empty()
    }

    /// The input vertex that a row of attributes is of.
    #[must_use]
    pub fn vertex_of_row(&self, row: u32) -> InputVertex {
        InputVertex(self.seams.vertices.get(row as usize).copied().unwrap_or(row))
    }

    /// The row of attributes that a triangle has at one of its vertices.
    #[must_use]
    pub fn row(&self, triangle: InputTriangle, vertex: InputVertex) -> usize {
        let rows = self.seams.corners.get(triangle.index()).into_iter().flatten();
        let mut rows = rows.map(|&row| row as usize);
        rows.find(|&row| self.seams.vertices[row] == vertex.0).unwrap_or(vertex.index())
    }

    /// The appearance of the triangles and vertices that are kept: triangles in ascending order, vertices by a flag each.
    #[must_use]
    pub fn select(&self, triangles: impl Iterator<Item = usize> + Clone, is_kept: &[bool]) -> Self {
        fn chosen<T: Copy>(values: &[T], rows: &[usize]) -> Vec<T> {
            if values.is_empty() { Vec::new() } else { rows.iter().map(|&row| values[row]).collect() }
        }
        let (seams, rows) = self.seams.select(triangles.clone(), is_kept);
        Self {
            texcoords: chosen(&self.texcoords, &rows),
            colors: chosen(&self.colors, &rows),
            normals: chosen(&self.normals, &rows),
            seams,
            runs: self.runs_of(triangles),
            materials: self.materials.clone(),
            images: self.images.clone(),
            missing: self.missing.clone(),
        }
    }

    /// The runs of some triangles, in ascending order, which are counted from 0 in turn.
    pub fn runs_of(&self, triangles: impl Iterator<Item = usize>) -> Vec<Run> {
        let mut runs: Vec<Run> = Vec::new();
        let mut here = 0;
        if self.runs.is_empty() {
            return runs;
        }
        for (index, triangle) in triangles.enumerate() {
            while self.runs.get(here).is_some_and(|run| run.triangles.end <= triangle) {
                here += 1;
            }
            let material = self.runs.get(here).and_then(|run| run.material);
            match runs.last_mut().filter(|run| run.material == material) {
                Some(run) => run.triangles.end = index + 1,
                None => runs.push(Run { triangles: index..index + 1, material }),
            }
        }
        runs
    }
}

impl Seams {
    /// The seams of the triangles and vertices that are kept, and their rows among those of before, ascending.
    fn select(&self, triangles: impl Iterator<Item = usize>, is_kept: &[bool]) -> (Self, Vec<usize>) {
        let vertices = || is_kept.iter().enumerate().filter(|&(_, &is_kept)| is_kept).map(|(vertex, _)| vertex);
        if self.corners.is_empty() {
            return (Self::default(), vertices().collect());
        }
        let mut is_row_kept = vec![false; self.vertices.len()];
        vertices().for_each(|vertex| is_row_kept[vertex] = true);
        let mut corners: Vec<[u32; 3]> = triangles.map(|triangle| self.corners[triangle]).collect();
        corners.iter().flatten().for_each(|&row| is_row_kept[row as usize] = true);
        let mut number = vec![0; self.vertices.len()];
        let mut rows = Vec::new();
        for (row, _) in is_row_kept.iter().enumerate().filter(|&(_, &is_kept)| is_kept) {
            number[row] = rows.len() as u32;
            rows.push(row);
        }
        if rows.last().is_none_or(|&last| last < is_kept.len()) {
            return (Self::default(), rows);
        }
        corners.iter_mut().flatten().for_each(|row| *row = number[*row as usize]);
        let vertices = rows.iter().map(|&row| number[self.vertices[row] as usize]).collect();
        (Self { vertices, corners }, rows)
    }
}
