//! Accessors: any component type, stride, normalisation, compression and sparse substitution, every offset checked.

use glam::DVec3;
use gltf::json::accessor::{Accessor, ComponentType, Type, sparse::Sparse};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};

use super::container::Buffers;
use super::draco::Compressed;
use super::format::GLTF;
use crate::error::{Error, Result};

/// How integers are to be taken.
#[derive(Clone, Copy, PartialEq)]
enum Meaning {
    /// As the accessor says: positions and weights may be normalised.
    Quantity,
    /// As they are: vertex and joint indices.
    Index,
}

/// Elements that are zero without data for them in however small a file: a sparse accessor without a view has few bytes. What they
/// take is some hundred times their JSON.
const MOST_IMPLIED: usize = 1024;

#[derive(Clone, Copy)]
pub struct Accessors<'a> {
    pub root: &'a Root,
    pub buffers: &'a Buffers<'a>,
    /// The primitive that is being read, if it is compressed: its accessors have no data of their own.
    pub compressed: Option<&'a Compressed<'a>>,
}

impl<'a> Accessors<'a> {
    /// The same accessors as a primitive sees them, all of its attributes decoded.
    pub fn of<'b>(self, primitive: Option<&'b Compressed<'b>>) -> Accessors<'b>
    where
        'a: 'b,
    {
        Accessors { compressed: primitive, ..self }
    }

    /// Number of elements of an accessor.
    pub fn count(self, index: u32) -> Result<usize> {
        let (accessor, _) = self.find(index)?;
        if let Some(primitive) = self.compressed.filter(|primitive| primitive.holds(index)) {
            return Ok(primitive.vertices());
        }
        usize::try_from(accessor.count.0).map_err(|_| error(index, "its count is too large"))
    }

    /// `count × 3`: positions, or displacements of a morph target.
    pub fn vectors(self, index: u32) -> Result<Vec<DVec3>> {
        Ok(self.rows::<3>(index, Type::Vec3, Meaning::Quantity)?.into_iter().map(DVec3::from).collect())
    }

    /// `count × 2`: texture coordinates.
    pub fn texcoords(self, index: u32) -> Result<Vec<[f64; 2]>> {
        self.rows(index, Type::Vec2, Meaning::Quantity)
    }

    /// `count × 4`: colors, with an alpha of 1 where the accessor has none.
    pub fn colors(self, index: u32) -> Result<Vec<[f64; 4]>> {
        if matches!(self.find(index)?.0.type_, Checked::Valid(Type::Vec3)) {
            let opaque = |[red, green, blue]: [f64; 3]| [red, green, blue, 1.0];
            return Ok(self.rows(index, Type::Vec3, Meaning::Quantity)?.into_iter().map(opaque).collect());
        }
        self.rows(index, Type::Vec4, Meaning::Quantity)
    }

    /// `count × 4`: skinning weights.
    pub fn weights(self, index: u32) -> Result<Vec<[f64; 4]>> {
        self.rows(index, Type::Vec4, Meaning::Quantity)
    }

    /// `count × 4`: joint indices.
    pub fn joints(self, index: u32) -> Result<Vec<[f64; 4]>> {
        self.rows(index, Type::Vec4, Meaning::Index)
    }

    /// `count × 16`: column-major matrices.
    pub fn matrices(self, index: u32) -> Result<Vec<[f64; 16]>> {
        self.rows(index, Type::Mat4, Meaning::Quantity)
    }

    /// `count × 4`: rotations of an animation, quaternions (x, y, z, w).
    pub fn rotations(self, index: u32) -> Result<Vec<[f64; 4]>> {
        self.rows(index, Type::Vec4, Meaning::Quantity)
    }

    /// Times and weights of an animation.
    pub fn numbers(self, index: u32) -> Result<Vec<f64>> {
        Ok(self.rows::<1>(index, Type::Scalar, Meaning::Quantity)?.into_iter().map(|[value]| value).collect())
    }

    /// Vertex indices. They come from unsigned integers of at most 32 bits.
    pub fn indices(self, index: u32) -> Result<Vec<u32>> {
        let (_, component) = self.find(index)?;
        if !matches!(component, ComponentType::U8 | ComponentType::U16 | ComponentType::U32) {
            return Err(error(index, "vertex indices must be unsigned integers"));
        }
        Ok(self.rows::<1>(index, Type::Scalar, Meaning::Index)?.into_iter().map(|[value]| value as u32).collect())
    }

    fn find(&self, index: u32) -> Result<(&Accessor, ComponentType)> {
        let accessor = self.root.accessors.get(index as usize).ok_or_else(|| error(index, "it does not exist"))?;
        match accessor.component_type {
            Checked::Valid(component) => Ok((accessor, component.0)),
            Checked::Invalid => Err(error(index, "its component type is unknown")),
        }
    }

    fn rows<const N: usize>(self, index: u32, shape: Type, meaning: Meaning) -> Result<Vec<[f64; N]>> {
        let (accessor, component) = self.find(index)?;
        let count = self.count(index)?;
        if !matches!(accessor.type_, Checked::Valid(found) if found == shape) {
            return Err(error(index, &format!("its type is not {shape:?}")));
        }
        self.buffers.budget.lend(bytes_of::<N>(count))?;
        let layout =
            Layout { component, normalized: accessor.normalized && meaning == Meaning::Quantity, accessor: index };
        let compressed = self.compressed.map_or(Ok(None), |primitive| primitive.values(index))?;
        let mut rows = if let Some(values) = compressed {
            if values.components != N {
                return Err(error(index, "its compressed values have another type; export the file again"));
            }
            Layout { component: values.component, ..layout }.read::<N>(&values.bytes, 0, None, count)?
        } else if let Some(view) = accessor.buffer_view {
            let (bytes, stride) = self.buffers.view(view)?;
            layout.read::<N>(bytes, offset(accessor.byte_offset), stride, count)?
        } else {
            Vec::new()
        };
        if let Some(sparse) = &accessor.sparse {
            self.substitute(&layout, sparse, count, &mut rows)?;
        }
        // Without a view all elements are zero; a real file has bytes for something of that count elsewhere.
        if rows.len() < count {
            if !self.plausible(count) {
                return Err(error(index, "it has no data; export the file again"));
            }
            rows.resize(count, [0.0; N]);
        }
        Ok(rows)
    }

    /// Whether the file has enough data for an accessor without any of its own to be so long.
    fn plausible(&self, count: usize) -> bool {
        count <= MOST_IMPLIED
            || count <= self.buffers.resolved_bytes() + self.compressed.map_or(0, |primitive| primitive.vertices())
    }

    /// Replaces the elements that a sparse accessor lists.
    fn substitute<const N: usize>(
        self,
        layout: &Layout,
        sparse: &Sparse,
        count: usize,
        rows: &mut Vec<[f64; N]>,
    ) -> Result<()> {
        let index = layout.accessor;
        let Checked::Valid(component) = sparse.indices.component_type else {
            return Err(error(index, "its sparse indices have an unknown type"));
        };
        let replaced = usize::try_from(sparse.count.0).map_err(|_| error(index, "its sparse count is too large"))?;
        self.buffers.budget.lend(bytes_of::<1>(replaced).saturating_add(bytes_of::<N>(replaced)))?;
        let (bytes, _) = self.buffers.view(sparse.indices.buffer_view)?;
        let index_layout = Layout { component: component.0, normalized: false, accessor: index };
        let targets = index_layout.read::<1>(bytes, offset(Some(sparse.indices.byte_offset)), None, replaced)?;
        let (bytes, _) = self.buffers.view(sparse.values.buffer_view)?;
        let values = layout.read::<N>(bytes, offset(Some(sparse.values.byte_offset)), None, replaced)?;
        if rows.is_empty() && self.plausible(count) {
            rows.resize(count, [0.0; N]);
        }
        for ([target], value) in targets.into_iter().zip(values) {
            *rows
                .get_mut(target as usize)
                .ok_or_else(|| error(index, &format!("its sparse index {target} is out of range")))? = value;
        }
        Ok(())
    }
}

fn bytes_of<const N: usize>(rows: usize) -> u64 {
    (rows as u64).saturating_mul(size_of::<[f64; N]>() as u64)
}

fn offset(offset: Option<gltf::json::validation::USize64>) -> u64 {
    offset.map_or(0, |offset| offset.0)
}

fn error(accessor: u32, problem: &str) -> Error {
    GLTF.at(format!("accessor {accessor}"), problem)
}

/// The index of an accessor, without its type.
pub fn number(index: Index<Accessor>) -> u32 {
    index.value() as u32
}

struct Layout {
    component: ComponentType,
    normalized: bool,
    accessor: u32,
}

impl Layout {
    /// `count × N` from a view. The count is checked against the bytes before anything is reserved.
    fn read<const N: usize>(
        &self,
        bytes: &[u8],
        offset: u64,
        stride: Option<usize>,
        count: usize,
    ) -> Result<Vec<[f64; N]>> {
        let size = self.component.size();
        let element = N * size;
        let stride = stride.unwrap_or(element);
        if stride < element {
            return Err(error(self.accessor, "its elements overlap: the byte stride is too small"));
        }
        let bytes = usize::try_from(offset).ok().and_then(|offset| bytes.get(offset..));
        let bytes = bytes.filter(|bytes| {
            let last = count.saturating_sub(1).checked_mul(stride);
            count == 0 || last.and_then(|last| last.checked_add(element)).is_some_and(|end| end <= bytes.len())
        });
        let bytes = bytes.ok_or_else(|| {
            error(self.accessor, "it reaches beyond its buffer view; the file is cut short or damaged")
        })?;
        let row = |index: usize| std::array::from_fn(|i| self.component(&bytes[index * stride + i * size..]));
        Ok((0..count).map(row).collect())
    }

    fn component(&self, bytes: &[u8]) -> f64 {
        let (value, largest) = match self.component {
            ComponentType::I8 => (f64::from(bytes[0] as i8), f64::from(i8::MAX)),
            ComponentType::U8 => (f64::from(bytes[0]), f64::from(u8::MAX)),
            ComponentType::I16 => (f64::from(i16::from_le_bytes([bytes[0], bytes[1]])), f64::from(i16::MAX)),
            ComponentType::U16 => (f64::from(u16::from_le_bytes([bytes[0], bytes[1]])), f64::from(u16::MAX)),
            ComponentType::U32 => (f64::from(u32::from_le_bytes(first_four(bytes))), f64::from(u32::MAX)),
            ComponentType::F32 => return f32::from_le_bytes(first_four(bytes)).into(),
        };
        // −1 has two encodings (glTF 2.0, 3.11).
        if self.normalized { (value / largest).max(-1.0) } else { value }
    }
}

fn first_four(bytes: &[u8]) -> [u8; 4] {
    [bytes[0], bytes[1], bytes[2], bytes[3]]
}
