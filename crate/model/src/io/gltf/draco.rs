//! Primitives compressed by `KHR_draco_mesh_compression`. The draco-core crate decodes the stream; the extension says
//! which of its attributes stands for which accessor.

use std::borrow::Cow;

use draco_core::{DataType, DecodeLimits, DecoderBuffer, ErrorKind, Mesh, MeshDecoder, PointAttribute, PointIndex};
use gltf::json::accessor::ComponentType;
use gltf::json::mesh::Primitive;
use gltf::json::{Index, Value};

use super::container::Buffers;
use super::format::GLTF;
use crate::error::Result;
use crate::io::budget::Budget;

/// The extension read here.
pub const DRACO: &str = "KHR_draco_mesh_compression";

/// Bytes of a face, and of a point beside its attributes, while they are decoded: corners, what is opposite to them, where each vertex is.
const BYTES_OF_FACE: u64 = 64;
const BYTES_OF_POINT: u64 = 16;

/// A primitive whose triangles and vertices are compressed.
pub struct Compressed<'a> {
    mesh: &'a Mesh,
    /// Accessors, and the unique identifiers of the attributes that they stand for.
    attributes: Vec<(u32, u32)>,
    place: String,
}

/// The values of an accessor, one after the other.
pub struct Values<'a> {
    pub bytes: Cow<'a, [u8]>,
    pub component: ComponentType,
    /// Number of components of a value.
    pub components: usize,
}

/// The buffer view that a primitive is compressed in, if it is.
pub fn view(primitive: &Primitive) -> Option<u32> {
    u32::try_from(extension(primitive)?.get("bufferView")?.as_u64()?).ok()
}

fn extension(primitive: &Primitive) -> Option<&Value> {
    primitive.extensions.as_ref()?.others.get(DRACO)
}

impl<'a> Compressed<'a> {
    /// Decodes a primitive, if it is compressed.
    pub fn of(primitive: &Primitive, buffers: &'a Buffers) -> Result<Option<Self>> {
        if extension(primitive).is_none() {
            return Ok(None);
        }
        let view = view(primitive)
            .ok_or_else(|| GLTF.at("primitive", format!("its {DRACO} names no buffer view; export the file again")))?;
        let place = format!("buffer view {view}");
        let mesh = buffers.mesh(Index::new(view), |bytes| decode(bytes, buffers.budget, &place))?;
        let ids = extension(primitive).and_then(|extension| extension.get("attributes"));
        let id = |semantic: &str| u32::try_from(ids?.get(semantic)?.as_u64()?).ok();
        let accessors = primitive.attributes.iter();
        let attributes =
            accessors.filter_map(|(name, accessor)| Some((accessor.value() as u32, id(&name.to_string())?))).collect();
        Ok(Some(Self { mesh, attributes, place }))
    }

    /// Number of vertices.
    pub fn vertices(&self) -> usize {
        self.mesh.num_points()
    }

    /// The triangles, which are a list whatever the mode of the primitive.
    pub fn triangles(&self) -> impl ExactSizeIterator<Item = [u32; 3]> {
        self.mesh.faces().iter().map(|face| face.map(|corner| corner.0))
    }

    /// Whether the values of an accessor are compressed here.
    pub fn holds(&self, accessor: u32) -> bool {
        self.attributes.iter().any(|&(held, _)| held == accessor)
    }

    /// The values of an accessor, one per vertex, if they are compressed here.
    pub fn values(&self, accessor: u32) -> Result<Option<Values<'_>>> {
        let Some(&(_, id)) = self.attributes.iter().find(|&&(held, _)| held == accessor) else { return Ok(None) };
        let error = |problem: &str| GLTF.at(&self.place, format!("{problem}; export the file again"));
        let attribute = self.mesh.attribute_by_unique_id(id).ok_or_else(|| {
            error(&format!("its Draco data has no attribute {id}, which accessor {accessor} stands for"))
        })?;
        let component = match attribute.data_type() {
            DataType::Int8 => ComponentType::I8,
            DataType::Uint8 => ComponentType::U8,
            DataType::Int16 => ComponentType::I16,
            DataType::Uint16 => ComponentType::U16,
            DataType::Uint32 => ComponentType::U32,
            DataType::Float32 => ComponentType::F32,
            _ => {
                return Err(error(&format!("attribute {id} of its Draco data has a component type that glTF has not")));
            }
        };
        let components = usize::from(attribute.num_components());
        let bytes = gather(attribute, self.vertices(), components * component.size())
            .ok_or_else(|| error(&format!("attribute {id} of its Draco data is damaged")))?;
        Ok(Some(Values { bytes, component, components }))
    }
}

fn decode(bytes: &[u8], budget: &Budget, place: &str) -> Result<Mesh> {
    let left = budget.left();
    let limits = DecodeLimits::default()
        .with_max_points(left / BYTES_OF_POINT)
        .with_max_faces(left / BYTES_OF_FACE)
        .with_max_decoded_bytes(left);
    let mut mesh = Mesh::new();
    MeshDecoder::new().decode(&mut DecoderBuffer::new(bytes).with_limits(limits), &mut mesh).map_err(|error| {
        match error.kind() {
            // More than is left.
            ErrorKind::LimitExceeded => budget.take(left + 1).err(),
            _ => None,
        }
        .unwrap_or_else(|| GLTF.at(place, "its Draco data is damaged or of an unknown version; export the file again"))
    })?;
    let attributes = (0..mesh.num_attributes()).map(|id| mesh.attribute(id).buffer().data().len() as u64);
    let points = BYTES_OF_POINT.saturating_mul(mesh.num_points() as u64);
    let faces = (size_of::<[u32; 3]>() as u64).saturating_mul(mesh.num_faces() as u64);
    budget.take(attributes.sum::<u64>().saturating_add(points).saturating_add(faces))?;
    Ok(mesh)
}

/// The values of `count` vertices of `size` bytes each, which several vertices may share in the stream.
fn gather(attribute: &PointAttribute, count: usize, size: usize) -> Option<Cow<'_, [u8]>> {
    let data = attribute.buffer().data();
    let stride = usize::try_from(attribute.byte_stride()).ok()?;
    if attribute.is_mapping_identity() && stride == size {
        return data.get(..count.checked_mul(size)?).map(Cow::Borrowed);
    }
    let mut bytes = Vec::with_capacity(count.checked_mul(size)?);
    for vertex in 0..count {
        let start = (attribute.mapped_index(PointIndex(vertex as u32)).0 as usize).checked_mul(stride)?;
        bytes.extend(data.get(start..start.checked_add(size)?)?);
    }
    Some(bytes.into())
}
