//! Bridges of a surface that walls part.

use std::collections::BTreeMap;

use super::{Bridges, Portal};
use crate::surface::Surface;

impl Bridges {
    /// The same portals on a surface after it was [parted](Surface::walled), without those that end in a wall. Contacts are
    /// those of the components that walls make.
    #[must_use]
    pub fn across_walls(&self, before: &Surface, walled: &Surface) -> Self {
        let mut contacts: BTreeMap<[u32; 2], Vec<Portal>> = BTreeMap::new();
        for portal in &self.portals {
            let ends = portal.ends.map(|place| walled.place_across_walls(before, place));
            if ends.iter().any(|&place| walled.is_in_wall(place)) {
                continue;
            }
            let [a, b] = ends.map(|place| place.component(walled));
            let kept = contacts.entry([a.min(b), a.max(b)]).or_default();
            kept.push(Portal { ends: if a <= b { ends } else { [ends[1], ends[0]] }, gap: portal.gap });
        }
        Self { is_complete: self.is_complete, ..Self::new(walled, contacts.into_iter().collect()) }
    }
}

#[cfg(test)]
mod tests {
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test as test;

    use super::super::tests::{assembled, cuboid};
    use super::*;
    use crate::bridges::BridgeRule;
    use crate::element::{FaceId, VertexId};
    use crate::surface::Walls;

    #[test]
    fn portals_in_walls_are_dropped_and_components_regrouped() {
        let whole = assembled(&[cuboid([0.0; 3], [1.0; 3]), cuboid([0.5, 0.5, 1.0], [1.5, 1.5, 2.0])]);
        let bridges = Bridges::find(&whole, BridgeRule::Automatic);
        assert_eq!(bridges.group_count(), 1);

        let none = whole.walled(&Walls::default()).expect("no walls");
        assert_eq!(bridges.across_walls(&whole, &none).portals().len(), bridges.portals().len());

        // A wall of one face elsewhere is a component, and a group, of its own.
        let away = (0..whole.face_count() as u32).map(FaceId).find(|&face| {
            let has_portal = |portal: &Portal| portal.ends.iter().any(|end| end.faces(&whole).contains(&face));
            !bridges.portals().iter().any(has_portal)
        });
        let walled = whole.walled(&Walls { faces: vec![away.expect("a face")], edges: Vec::new() }).expect("a face");
        let carried = bridges.across_walls(&whole, &walled);
        assert_eq!(carried.portals().len(), bridges.portals().len());
        assert_eq!(carried.group_count(), 2);

        // Where all of one cuboid is a wall, nothing leads there.
        let second = whole.component(VertexId(8));
        let is_second = |&face: &FaceId| whole.component(whole.faces()[face][0]) == second;
        let faces = (0..whole.face_count() as u32).map(FaceId).filter(is_second).collect();
        let walled = whole.walled(&Walls { faces, edges: Vec::new() }).expect("faces");
        assert!(bridges.across_walls(&whole, &walled).portals().is_empty());
    }
}
