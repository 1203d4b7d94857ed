//! What moves the vertices of a soup over time: a hierarchy of nodes, skins, morph targets, and clips that change them.
//!
//! As glTF 2.0 defines them: morph targets (3.7.2.2), skins (3.7.3), animations (3.11 and appendix C).

mod clip;
mod deformer;
mod hierarchy;
mod state;

use glam::{DVec3, Vec3};
use heatwalk_base::sort;
use heatwalk_surface::{Error as SurfaceError, Result as SurfaceResult};

use crate::error::{Error, Result};
pub use clip::{Channel, Clip, Interpolation, Target, Track};
pub use deformer::{Deformer, Influences, MorphTarget, Skin};
pub use hierarchy::{Node, NodeTree, Placement};
use state::State;

/// How the vertices of a soup move.
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "packed", derive(serde::Serialize, serde::Deserialize))]
pub struct Motion {
    hierarchy: NodeTree,
    skins: Vec<Skin>,
    /// Those that a clip moves, each of other vertices.
    deformers: Vec<Deformer>,
    clips: Vec<Clip>,
}

/// Where the vertices of a soup are at a moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Pose {
    /// `#V × 3`, in the file's unit.
    pub positions: Vec<DVec3>,
    /// `#V × 3`, unit vectors; zero at vertices that have none. Empty where the soup has none.
    pub normals: Vec<Vec3>,
}

impl Motion {
    /// Keeps of the deformers those that a clip moves, and of the clips those that move anything.
    ///
    /// # Errors
    /// [`Error::Motion`] for a node, a joint or a channel that names what does not exist, and for a deformer whose arrays have
    /// other lengths than its vertices.
    pub fn new(hierarchy: NodeTree, skins: Vec<Skin>, deformers: Vec<Deformer>, clips: Vec<Clip>) -> Result<Self> {
        let nodes = hierarchy.nodes().len();
        let bad = |thing: &str| Err(Error::Motion { problem: format!("{thing} does not exist") });
        for clip in &clips {
            if let Some(channel) = clip.channels.iter().find(|channel| channel.node >= nodes) {
                return bad(&format!("node {} of clip {}", channel.node, clip.name));
            }
        }
        if let Some(joint) = skins.iter().flat_map(|skin| &skin.joints).find(|&&joint| joint >= nodes) {
            return bad(&format!("node {joint} of a skin"));
        }
        for deformer in &deformers {
            deformer.check(nodes, &skins)?;
        }
        let mut motion = Self { hierarchy, skins, deformers, clips };
        let moves = |clip: &Clip| {
            let is_moved = motion.moved_by(std::slice::from_ref(clip));
            motion.deformers.iter().any(is_moved)
        };
        let moving: Vec<bool> = motion.clips.iter().map(moves).collect();
        let mut moving = moving.into_iter();
        motion.clips.retain(|_| moving.next() == Some(true));
        let is_moved = motion.moved_by(&motion.clips);
        let kept: Vec<bool> = motion.deformers.iter().map(is_moved).collect();
        let mut kept = kept.into_iter();
        motion.deformers.retain(|_| kept.next() == Some(true));
        Ok(motion)
    }

    /// Whether nothing ever moves.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.clips.is_empty()
    }

    /// Whether a clip moves any vertex; not always so after [`Self::select`].
    #[must_use]
    pub fn moves(&self) -> bool {
        !self.deformers.is_empty()
    }

    /// In the order of the file.
    #[must_use]
    pub fn clips(&self) -> &[Clip] {
        &self.clips
    }

    /// The clip of that name; or else that of that number, counted from 0.
    ///
    /// # Errors
    /// [`Error::NoSuchClip`], with the names that there are.
    pub fn clip_named(&self, name: &str) -> Result<usize> {
        let named = self.clips.iter().position(|clip| clip.name == name);
        let numbered = || name.parse().ok().filter(|&number: &usize| number < self.clips.len());
        named.or_else(numbered).ok_or_else(|| {
            let names: Vec<&str> = self.clips.iter().map(|clip| clip.name.as_str()).collect();
            Error::NoSuchClip { clip: name.to_owned(), clips: names.join(", ") }
        })
    }

    /// Moves any pose of its soup to that of so many seconds after the beginning of a clip, at whose end it stops.
    ///
    /// # Errors
    /// [`BadParameter`](SurfaceError::BadParameter) for a clip that there is not, and for a time that is negative or not finite.
    ///
    /// # Panics
    /// For a pose with fewer vertices than the soup.
    pub fn apply(&self, clip: usize, seconds: f64, pose: &mut Pose) -> SurfaceResult<()> {
        let bad = |name, value: String, range| Err(SurfaceError::BadParameter { name, value, range });
        let Some(clip) = self.clips.get(clip) else {
            return bad("animation", clip.to_string(), "the number of one of the model, counted from 0");
        };
        if !(seconds >= 0.0 && seconds.is_finite()) {
            return bad("time", seconds.to_string(), "0 s or more, and finite");
        }
        let nodes = self.hierarchy.nodes();
        let mut state =
            State { placements: nodes.iter().map(|node| node.placement).collect(), weights: vec![None; nodes.len()] };
        for channel in &clip.channels {
            channel.apply(seconds, &mut state);
        }
        let world_from_node = self.hierarchy.world_from_nodes(&state.placements);
        let matrices: Vec<_> = self.skins.iter().map(|skin| skin.world_from_mesh(&world_from_node)).collect();
        for deformer in &self.deformers {
            let weights = state.weights[deformer.node].as_deref().unwrap_or(&deformer.weights);
            deformer.place(&world_from_node, &matrices, weights, &mut pose.positions, &mut pose.normals);
        }
        Ok(())
    }

    /// That of the vertices that are kept, ascending, which are counted from 0 in turn.
    #[must_use]
    pub fn select(&self, vertices: impl Iterator<Item = usize>) -> Self {
        let mut kept = vertices.peekable();
        let mut deformers = Vec::with_capacity(self.deformers.len());
        let mut count = 0;
        let mut by_vertices: Vec<&Deformer> = self.deformers.iter().collect();
        sort::sort_by_key(&mut by_vertices, |deformer| deformer.vertices.start);
        for deformer in by_vertices {
            while kept.next_if(|&vertex| vertex < deformer.vertices.start).is_some() {
                count += 1;
            }
            let mut own = Vec::new();
            while let Some(vertex) = kept.next_if(|&vertex| vertex < deformer.vertices.end) {
                own.push(vertex - deformer.vertices.start);
            }
            if !own.is_empty() {
                deformers.push(deformer.select(&own, count));
                count += own.len();
            }
        }
        // Clips keep their numbers, though some may move nothing any more.
        Self { hierarchy: self.hierarchy.clone(), skins: self.skins.clone(), deformers, clips: self.clips.clone() }
    }

    /// Whether clips move a deformer.
    fn moved_by(&self, clips: &[Clip]) -> impl Fn(&Deformer) -> bool + use<'_> {
        let nodes = self.hierarchy.nodes().len();
        let (mut is_placed, mut is_weighted) = (vec![false; nodes], vec![false; nodes]);
        for channel in clips.iter().flat_map(|clip| &clip.channels) {
            match channel.target {
                Target::Weights(_) => is_weighted[channel.node] = true,
                _ => is_placed[channel.node] = true,
            }
        }
        self.hierarchy.inherit(&mut is_placed);
        move |deformer| {
            let is_moved = match deformer.skin {
                Some(skin) => self.skins[skin].joints.iter().any(|&joint| is_placed[joint]),
                None => is_placed[deformer.node],
            };
            is_moved || is_weighted[deformer.node] && !deformer.targets.is_empty()
        }
    }
}
