//! Values of vertices as programs for brains take them, in 32 bits, beside a surface that is a file of its own.

use std::fmt::Write as _;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;

/// A format of values of vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlay {
    /// GIFTI (`.shape.gii`): numbers of the surface itself.
    Shape,
    /// GIFTI (`.func.gii`): numbers of nothing in particular.
    Func,
    /// A volume of FreeSurfer (`.mgh`), one voxel a vertex.
    Mgh,
    /// A curvature file of FreeSurfer (`.curv`), which has one column.
    Curvature,
}

impl Overlay {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Shape, Self::Func, Self::Mgh, Self::Curvature];

    /// How the names of its files end, without the first dot.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Shape => "shape.gii",
            Self::Func => "func.gii",
            Self::Mgh => "mgh",
            Self::Curvature => "curv",
        }
    }

    /// Whether a file has more than one column.
    #[must_use]
    pub const fn has_columns(self) -> bool {
        !matches!(self, Self::Curvature)
    }

    /// Columns of values by their names, one a vertex, `inf` where nothing leads. `faces`: how many triangles the surface has.
    ///
    /// # Panics
    /// If there is no column, if columns are not equally long, or if there are several in a format that has one.
    #[must_use]
    pub fn bytes(self, columns: &[(&str, &[f64])], faces: usize) -> Vec<u8> {
        let vertices = columns[0].1.len();
        assert!(columns.iter().all(|(_, values)| values.len() == vertices), "one value for each vertex");
        assert!(self.has_columns() || columns.len() == 1, "one column");
        match self {
            Self::Shape => gifti(columns, "NIFTI_INTENT_SHAPE"),
            Self::Func => gifti(columns, "NIFTI_INTENT_NONE"),
            Self::Mgh => mgh(columns, vertices),
            Self::Curvature => curvature(columns[0].1, faces),
        }
    }
}

/// Where the numbers of an MGH file begin.
const MGH_HEADER: usize = 284;
/// The type of such numbers: floats of 32 bits.
const MGH_FLOAT: i32 = 3;
/// First bytes of a curvature file of FreeSurfer.
const CURVATURE: [u8; 3] = [0xFF; 3];

/// An array for each column, in base64.
fn gifti(columns: &[(&str, &[f64])], intent: &str) -> Vec<u8> {
    let mut text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n\
         <GIFTI Version=\"1.0\" NumberOfDataArrays=\"{}\">\n<MetaData/>\n<LabelTable/>\n",
        columns.len()
    );
    for (name, values) in columns {
        let bytes: Vec<u8> = values.iter().flat_map(|&value| (value as f32).to_le_bytes()).collect();
        // Writing to a String cannot fail.
        let _ = write!(
            text,
            "<DataArray Intent=\"{intent}\" DataType=\"NIFTI_TYPE_FLOAT32\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"1\" Dim0=\"{}\" \
             Encoding=\"Base64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n\
             <MetaData><MD><Name>Name</Name><Value>{name}</Value></MD></MetaData>\n<Data>{}</Data>\n</DataArray>\n",
            values.len(),
            BASE64_STANDARD.encode(bytes)
        );
    }
    text.push_str("</GIFTI>\n");
    text.into_bytes()
}

/// As `MRISwriteCurvature` has it.
fn curvature(values: &[f64], faces: usize) -> Vec<u8> {
    let mut bytes = CURVATURE.to_vec();
    let counts = [values.len() as u32, faces as u32, 1];
    bytes.extend(counts.iter().flat_map(|count| count.to_be_bytes()));
    push_values(&mut bytes, values);
    bytes
}

/// Version 1, a frame for each column.
fn mgh(columns: &[(&str, &[f64])], vertices: usize) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(MGH_HEADER + 4 * vertices * columns.len());
    // Version; width, height, depth and frames; the type of numbers; degrees of freedom.
    for number in [1, vertices as i32, 1, 1, columns.len() as i32, MGH_FLOAT, 0] {
        bytes.extend(number.to_be_bytes());
    }
    // That what follows counts: sizes of a voxel, the axes of the volume in columns, and its center.
    bytes.extend(1_i16.to_be_bytes());
    for number in [1.0, 1.0, 1.0, -1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0_f32] {
        bytes.extend(number.to_be_bytes());
    }
    bytes.resize(MGH_HEADER, 0);
    for (_, values) in columns {
        push_values(&mut bytes, values);
    }
    bytes
}

fn push_values(bytes: &mut Vec<u8>, values: &[f64]) {
    bytes.extend(values.iter().flat_map(|&value| (value as f32).to_be_bytes()));
}
