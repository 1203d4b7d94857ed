//! Which module uses an item of which.

use super::modules::{Module, Named};

/// Re-exports that are followed one after another. More of them are a cycle of their own.
const LONGEST_CHAIN: usize = 16;

/// Code of the module `from` names `path`, which the module `to` defines or re-exports.
#[derive(PartialEq)]
pub struct Arrow {
    pub from: usize,
    pub to: usize,
    pub line: usize,
    pub path: String,
}

pub fn arrows(modules: &[Module]) -> Vec<Arrow> {
    let mut arrows = Vec::new();
    for (from, module) in modules.iter().enumerate() {
        for import in &module.imports {
            let re_exported = |to| import.is_exported && is_below(modules, to, from);
            push(modules, from, &import.path, re_exported, &mut arrows);
        }
        for path in &module.paths {
            // A single name that is a module's is a variable's, too: modules are no values.
            let variable = |to: usize| path.segments.len() == 1 && modules[to].name == path.segments[0];
            push(modules, from, path, variable, &mut arrows);
        }
    }
    arrows.dedup();
    arrows
}

fn push(modules: &[Module], from: usize, path: &Named, is_none: impl Fn(usize) -> bool, arrows: &mut Vec<Arrow>) {
    let mut search = Search { modules, through: Vec::new() };
    let to = match search.resolve(from, &path.segments, 0) {
        Some(Found::Item(to)) if !is_none(to) => Some(to),
        // To name a parent on the way to something else is not to use it.
        Some(Found::Module(to)) if !is_none(to) && !is_below(modules, from, to) => Some(to),
        _ => None,
    };
    let Some(to) = to else { return };
    let mut ends = vec![to];
    ends.extend(search.through.into_iter().filter(|&end| !is_below(modules, from, end)));
    ends.retain(|&end| end != from);
    ends.sort_unstable();
    ends.dedup();
    arrows.extend(ends.into_iter().map(|to| Arrow { from, to, line: path.line, path: path.segments.join("::") }));
}

/// Whether `module` is `above` or inside of it.
fn is_below(modules: &[Module], module: usize, above: usize) -> bool {
    std::iter::successors(Some(module), |&at| modules[at].parent).any(|at| at == above)
}

/// What a path leads to.
enum Found {
    /// An item of this module.
    Item(usize),
    Module(usize),
    /// Something of another crate.
    Foreign,
}

/// Follows paths, noting the modules that re-export what is looked for.
struct Search<'a> {
    modules: &'a [Module],
    through: Vec<usize>,
}

impl Search<'_> {
    /// What `path` means in the module `at`; None for a name that it does not know, such as that of a variable.
    fn resolve(&mut self, mut at: usize, mut path: &[String], depth: usize) -> Option<Found> {
        let start = path;
        while let [first, rest @ ..] = path {
            at = match first.as_str() {
                "crate" => 0,
                "self" => at,
                "super" => self.modules[at].parent?,
                _ => break,
            };
            path = rest;
        }
        match self.find(at, path, depth) {
            // What a macro defines is not seen, but can only be here.
            None if path.len() < start.len() => Some(Found::Item(at)),
            found => found,
        }
    }

    fn find(&mut self, at: usize, path: &[String], depth: usize) -> Option<Found> {
        let modules = self.modules;
        let [name, rest @ ..] = path else { return Some(Found::Module(at)) };
        let child = modules[at].children.get(name).copied();
        match child {
            // Functions are called as their module is.
            Some(child) if !rest.is_empty() => {
                return Some(self.find(child, rest, depth).unwrap_or(Found::Item(child)));
            }
            _ if modules[at].defined.contains(name) => return Some(Found::Item(at)),
            _ => {}
        }
        if depth == LONGEST_CHAIN {
            return None;
        }
        for import in &modules[at].imports {
            let target = match &import.name {
                Some(imported) if imported == name => [&import.path.segments, rest].concat(),
                None => [&import.path.segments, path].concat(),
                Some(_) => continue,
            };
            // `use name::...` of another crate would find itself.
            if target.first() == Some(name) && child.is_none() {
                return Some(Found::Foreign);
            }
            match self.resolve(at, &target, depth + 1) {
                Some(Found::Item(to)) if import.name.is_none() && !self.defines(to, name) => {}
                None if import.name.is_none() => {}
                found => {
                    self.through.push(at);
                    return Some(found.unwrap_or(Found::Foreign));
                }
            }
        }
        child.map(Found::Module)
    }

    fn defines(&self, module: usize, name: &str) -> bool {
        self.modules[module].defined.contains(name)
    }
}
