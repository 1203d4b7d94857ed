//! What a scene keeps off the light around it, ready for textures.

use glam::Vec3;

use crate::bounding_sphere::BoundingSphere;
use crate::contact::{CONTACT_SIZE, Contact, Floor};
use crate::occlusion::{Cube, OCCLUSION_SIZE, Occlusion};

/// Contact shadow and ambient occlusion of a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shade {
    contact: Vec<u8>,
    occlusion: Vec<u8>,
}

impl Shade {
    /// Of the meshes of a scene with these bounds: `#V × 3` positions and `#F × 3` indices of each.
    pub fn new<'a>(scene: BoundingSphere, meshes: impl Iterator<Item = (&'a [Vec3], &'a [[u32; 3]])>) -> Self {
        let mut contact = Contact::new(Floor::new(scene), scene);
        let mut occlusion = Occlusion::new(Cube::around(scene));
        for (positions, triangles) in meshes {
            contact.add(positions, triangles);
            occlusion.add(positions, triangles);
        }
        Self { contact: contact.into_texels(), occlusion: occlusion.into_texels() }
    }

    /// Of the arrays of another one, where they have its sizes.
    #[must_use]
    pub fn from_arrays(contact: Vec<u8>, occlusion: Vec<u8>) -> Option<Self> {
        let fits = contact.len() == CONTACT_SIZE.pow(2) && occlusion.len() == 4 * OCCLUSION_SIZE.pow(3);
        fits.then_some(Self { contact, occlusion })
    }

    /// Darkness of the [floor](Floor)'s cells, row by row along +z, 0 to 255.
    #[must_use]
    pub fn contact(&self) -> &[u8] {
        &self.contact
    }

    /// Four bytes a cell of the [cube](Cube), x fastest: the mean direction from which light comes, shifted and scaled from
    /// ±1/4 to 0..255, and the mean share of light that comes.
    #[must_use]
    pub fn occlusion(&self) -> &[u8] {
        &self.occlusion
    }
}
