//! `KHR_animation_pointer`: channels that name what they change by its place in the document. Those that change a node become
//! channels of that node.

use gltf::json::Value;

/// No node: the channel moves nothing.
const NOWHERE: u32 = u32::MAX;

/// Gives each channel of the animations that has no node the one that it points to.
pub fn resolve(document: &mut Value) {
    let animations = document["animations"].as_array_mut().into_iter().flatten();
    let channels = animations.filter_map(|animation| animation["channels"].as_array_mut()).flatten();
    for target in channels.map(|channel| &mut channel["target"]).filter(|target| target["node"].is_null()) {
        let pointer = target["extensions"]["KHR_animation_pointer"]["pointer"].as_str();
        let (node, path) = match pointer.and_then(node_and_property) {
            Some((node, property)) => (node, property.to_owned().into()),
            None => (NOWHERE, target["path"].clone()),
        };
        target["node"] = node.into();
        target["path"] = path;
    }
}

/// Of a pointer to a property of a node. Other places, and single numbers of these, are not read.
fn node_and_property(pointer: &str) -> Option<(u32, &str)> {
    let (node, property) = pointer.strip_prefix("/nodes/")?.split_once('/')?;
    let is_read = matches!(property, "translation" | "rotation" | "scale" | "weights");
    node.parse().ok().filter(|_| is_read).map(|node| (node, property))
}
