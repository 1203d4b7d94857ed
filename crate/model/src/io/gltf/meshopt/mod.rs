//! Buffer views compressed by `EXT_meshopt_compression` and `KHR_meshopt_compression`. "The specification" here is the
//! text of the latter (glTF extensions 2.0, Khronos), whose streams and filters include those of the former.

mod attributes;
mod filter;
mod indices;
mod input;
#[cfg(test)]
mod tests;

use gltf::json::buffer::View;
use gltf::json::{Value, deserialize};

use input::Decoded;

/// The extensions read here.
pub const MESHOPT: [&str; 2] = ["EXT_meshopt_compression", "KHR_meshopt_compression"];

/// How a view is compressed.
pub struct Compression {
    /// The compressed bytes, as a view of their own.
    pub source: View,
    /// Number of elements.
    count: usize,
    /// Bytes of an element.
    stride: usize,
    mode: Mode,
    filter: fn(&mut [u8], usize),
}

enum Mode {
    Attributes,
    Triangles,
    Indices,
}

impl Compression {
    /// What the extension says of the view, if the view has it ("JSON schema updates").
    pub fn of(view: &View) -> Decoded<Option<Self>> {
        let extensions = view.extensions.as_ref();
        let extension = extensions.and_then(|all| MESHOPT.iter().find_map(|&name| all.others.get(name)));
        extension.map(Self::parse).transpose()
    }

    fn parse(extension: &Value) -> Decoded<Self> {
        let source: View = deserialize::from_slice(extension.to_string().as_bytes())
            .map_err(|_| "it does not say where its bytes are")?;
        let stride = source.byte_stride.map_or(0, |stride| stride.0);
        let count = extension.get("count").and_then(Value::as_u64).and_then(|count| usize::try_from(count).ok());
        let text = |key| extension.get(key).and_then(Value::as_str);
        let mode = match text("mode") {
            Some("ATTRIBUTES") if stride > 0 && stride <= 256 && stride.is_multiple_of(4) => Mode::Attributes,
            Some("TRIANGLES") if stride == 2 || stride == 4 => Mode::Triangles,
            Some("INDICES") if stride == 2 || stride == 4 => Mode::Indices,
            Some("ATTRIBUTES" | "TRIANGLES" | "INDICES") => return Err("its elements have an impossible size"),
            _ => return Err("its compression mode is unknown"),
        };
        let filter = match text("filter") {
            None | Some("NONE") => |_: &mut [u8], _| {},
            Some("OCTAHEDRAL") if stride == 4 || stride == 8 => filter::octahedral,
            Some("QUATERNION") if stride == 8 => filter::quaternion,
            Some("EXPONENTIAL") => filter::exponential,
            Some("COLOR") if stride == 4 || stride == 8 => filter::color,
            Some("OCTAHEDRAL" | "QUATERNION" | "COLOR") => {
                return Err("its filter does not fit the size of its elements");
            }
            Some(_) => return Err("its compression filter is unknown"),
        };
        Ok(Self { count: count.ok_or("it does not say how many elements it has")?, source, stride, mode, filter })
    }

    /// How many bytes are needed at once while the view is decoded.
    pub fn bytes(&self) -> u64 {
        let size = match self.mode {
            Mode::Attributes => self.stride,
            Mode::Triangles | Mode::Indices => self.stride + size_of::<u32>(),
        };
        (self.count as u64).saturating_mul(size as u64)
    }

    /// The bytes of the view, `count × stride`.
    pub fn decode(&self, stream: &[u8]) -> Decoded<Vec<u8>> {
        let mut bytes = match self.mode {
            Mode::Attributes => attributes::decode(stream, self.count, self.stride)?,
            Mode::Triangles => pack(&indices::triangles(stream, self.count)?, self.stride)?,
            Mode::Indices => pack(&indices::sequence(stream, self.count)?, self.stride)?,
        };
        (self.filter)(&mut bytes, self.stride);
        Ok(bytes)
    }
}

/// Indices as little-endian integers of 2 or 4 bytes.
fn pack(indices: &[u32], size: usize) -> Decoded<Vec<u8>> {
    if size == 4 {
        return Ok(indices.iter().flat_map(|index| index.to_le_bytes()).collect());
    }
    let mut bytes = Vec::with_capacity(2 * indices.len());
    for &index in indices {
        bytes.extend(u16::try_from(index).map_err(|_| "an index has more than 16 bits")?.to_le_bytes());
    }
    Ok(bytes)
}
