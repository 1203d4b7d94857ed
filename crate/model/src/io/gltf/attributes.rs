//! Attributes of vertices that an application gives a meaning of its own: `_NAME` (glTF 2.0, 3.7.2.1).

use std::collections::HashMap;
use std::ops::Range;

use gltf::json::Value;
use gltf::json::deserialize::from_slice;
use heatwalk_surface::Attribute;

use super::accessor::Accessors;
use crate::error::Result;

/// The accessors of such attributes, by mesh and primitive. The JSON types of the gltf crate leave them out.
pub struct Named(HashMap<(usize, usize), Vec<(String, u32)>>);

impl Named {
    pub fn new(json: &[u8]) -> Self {
        // What has none is not parsed again.
        let has_any = json.windows(2).any(|pair| pair == b"\"_");
        let document: Value = if has_any { from_slice(json).unwrap_or_default() } else { Value::Null };
        let mut named = HashMap::new();
        for (mesh, value) in list(&document, "meshes").enumerate() {
            for (primitive, value) in list(value, "primitives").enumerate() {
                let attributes = value.get("attributes").and_then(Value::as_object).into_iter().flatten();
                let own = attributes
                    .filter(|(name, _)| name.starts_with('_'))
                    .filter_map(|(name, accessor)| Some((name.clone(), u32::try_from(accessor.as_u64()?).ok()?)));
                let own: Vec<(String, u32)> = own.collect();
                if !own.is_empty() {
                    named.insert((mesh, primitive), own);
                }
            }
        }
        Self(named)
    }

    /// Adds the values of these vertices. What is no list of numbers, one a vertex, is left out.
    ///
    /// # Errors
    /// Where the budget has no room for them.
    pub fn add(
        &self,
        accessors: Accessors,
        (mesh, primitive): (usize, usize),
        vertices: &Range<usize>,
        attributes: &mut Vec<Attribute>,
    ) -> Result<()> {
        let budget = accessors.buffers.budget;
        for (name, accessor) in self.0.get(&(mesh, primitive)).into_iter().flatten() {
            let Ok(values) = accessors.numbers(*accessor) else { continue };
            if values.len() != vertices.len() {
                continue;
            }
            let index = attributes.iter().position(|attribute| attribute.name == *name).unwrap_or_else(|| {
                attributes.push(Attribute { name: name.clone(), values: Vec::new() });
                attributes.len() - 1
            });
            let all = &mut attributes[index].values;
            budget.resize(all, vertices.start, f64::NAN)?;
            budget.reserve(all, values.len())?;
            all.extend(values);
        }
        Ok(())
    }
}

fn list<'a>(value: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    value.get(key).and_then(Value::as_array).into_iter().flatten()
}
