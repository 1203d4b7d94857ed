//! What joins the components of a surface, kept so that another number of links is not searched anew.

use std::num::NonZeroUsize;
use std::sync::Arc;

use heatwalk_surface::{BridgeRule, Bridges, Link, Surface};

/// Bridges by a rule, and links between the groups that these leave apart.
#[derive(Debug, Clone, Default)]
pub struct Joined {
    /// The rule, and the surface in the pose that was searched; none before the first search.
    searched: Option<(BridgeRule, Arc<Surface>)>,
    /// By the rule alone.
    found: Bridges,
    /// What links its groups; none before links were asked for.
    links: Option<Vec<Link>>,
    /// How many of them are taken.
    linked: usize,
    /// With the links that are taken.
    bridges: Bridges,
}

/// By no rule, and without links.
impl From<Bridges> for Joined {
    fn from(bridges: Bridges) -> Self {
        Self { found: bridges.clone(), bridges, ..Self::default() }
    }
}

impl Joined {
    /// Joins components where they meet on a surface, by a rule, and so many pairs of groups beyond that as are nearest; searches on
    /// so many threads.
    pub fn join(&mut self, surface: &Arc<Surface>, rule: BridgeRule, links: usize, threads: NonZeroUsize) {
        let is_found = |(by, on): &(BridgeRule, Arc<Surface>)| *by == rule && on.id() == surface.id();
        if !self.searched.as_ref().is_some_and(is_found) {
            self.searched = Some((rule, Arc::clone(surface)));
            self.found = Bridges::find_on_threads(surface, rule, threads);
            self.links = None;
        }
        self.linked = 0;
        if links > 0 {
            self.linked = self.links.get_or_insert_with(|| self.found.links(surface)).len().min(links);
        }
        self.bridges = self.found.linked(surface, self.linked());
    }

    /// All that is joined, links too.
    pub fn bridges(&self) -> &Bridges {
        &self.bridges
    }

    /// The surface in the pose that was searched; none where nothing was.
    pub fn surface(&self) -> Option<&Arc<Surface>> {
        self.searched.as_ref().map(|(_, surface)| surface)
    }

    /// Pairs of components that meet by the rule alone.
    pub fn contact_count(&self) -> usize {
        self.found.contacts().len()
    }

    /// The links that are taken, from the narrowest gap to the widest.
    pub fn linked(&self) -> &[Link] {
        self.links.as_ref().map_or(&[], |links| &links[..self.linked])
    }

    /// The least number of links with which more is reached from these components than now; the number of now where there is none.
    pub(super) fn links_to_reach_more(&mut self, components: &[u32]) -> usize {
        let Some((_, surface)) = &self.searched else { return 0 };
        let bridges = &self.bridges;
        let links = self.links.get_or_insert_with(|| self.found.links(surface));
        let is_reached =
            |component: u32| components.iter().any(|&reached| bridges.group(reached) == bridges.group(component));
        let leads_on = |link: &Link| is_reached(link.components[0]) != is_reached(link.components[1]);
        let next = links[self.linked..].iter().position(leads_on);
        next.map_or(self.linked, |next| self.linked + next + 1)
    }
}
