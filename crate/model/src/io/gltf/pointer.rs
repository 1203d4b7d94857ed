//! `KHR_animation_pointer`: channels that name what they change by its place in the document. Those that change a node become
//! channels of that node.

use gltf::json::Value;
use serde_json::Map;

/// No node: the channel moves nothing.
const NOWHERE: u32 = u32::MAX;

/// Gives each channel of the animations that has no node the one that it points to.
pub fn resolve(document: &mut Value) {
    let channels = list_of(document, "animations").flat_map(|animation| list_of(animation, "channels"));
    for channel in channels.filter_map(Value::as_object_mut) {
        let target = channel.entry("target").or_insert_with(|| Value::Object(Map::new()));
        let Some(target) = target.as_object_mut().filter(|target| target.get("node").is_none_or(Value::is_null)) else {
            continue;
        };
        let extension = target.get("extensions").and_then(|extensions| extensions.get("KHR_animation_pointer"));
        let pointer = extension.and_then(|extension| extension.get("pointer")?.as_str());
        let (node, path) = match pointer.and_then(node_and_property) {
            Some((node, property)) => (node, property.to_owned().into()),
            None => (NOWHERE, target.get("path").cloned().unwrap_or_default()),
        };
        target.insert("node".to_owned(), node.into());
        target.insert("path".to_owned(), path);
    }
}

fn list_of<'a>(value: &'a mut Value, key: &str) -> impl Iterator<Item = &'a mut Value> {
    value.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten()
}

/// Of a pointer to a property of a node. Other places, and single numbers of these, are not read.
fn node_and_property(pointer: &str) -> Option<(u32, &str)> {
    let (node, property) = pointer.strip_prefix("/nodes/")?.split_once('/')?;
    let is_read = matches!(property, "translation" | "rotation" | "scale" | "weights");
    node.parse().ok().filter(|_| is_read).map(|node| (node, property))
}
