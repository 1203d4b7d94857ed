//! Material libraries (`.mtl`) and which of their materials are used.

use std::collections::HashMap;
use std::rc::Rc;

use super::material::Definition;
use super::texture::{Images, find};
use crate::appearance::{Appearance, Run};
use crate::io::reader::Resources;
use crate::io::text;

/// The materials that libraries define, and those that triangles have.
pub struct Library<'a> {
    resources: Resources<'a>,
    opened: Vec<String>,
    missing: Vec<String>,
    definitions: HashMap<String, Definition>,
    /// Names in the order of their first use.
    used: Vec<String>,
    index_of_used: HashMap<String, usize>,
}

impl<'a> Library<'a> {
    pub fn new(resources: Resources<'a>) -> Self {
        Self {
            resources,
            opened: Vec::new(),
            missing: Vec::new(),
            definitions: HashMap::new(),
            used: Vec::new(),
            index_of_used: HashMap::new(),
        }
    }

    /// Reads the libraries of a statement: a file whose name may have spaces, or several files.
    pub fn open(&mut self, names: &str) {
        if self.opened.iter().any(|opened| opened == names) {
            return;
        }
        self.opened.push(names.to_owned());
        if let Some(bytes) = find(self.resources, "", names) {
            return self.add(names, &bytes);
        }
        let several = names.split_whitespace().filter(|_| names.contains(".mtl ")).collect::<Vec<_>>();
        for name in if several.is_empty() { vec![names] } else { several } {
            match find(self.resources, "", name) {
                Some(bytes) => self.add(name, &bytes),
                None if name.is_empty() => {}
                None => self.missing.push(name.to_owned()),
            }
        }
    }

    fn add(&mut self, name: &str, bytes: &[u8]) {
        let folder = name.rfind(['/', '\\']).map_or(String::new(), |end| name[..=end].replace('\\', "/"));
        let folder: Rc<str> = folder.into();
        let mut definition: Option<&mut Definition> = None;
        let text = String::from_utf8_lossy(bytes);
        for (_, line) in text::lines(text.strip_prefix('\u{feff}').unwrap_or(&text)) {
            let (keyword, arguments) = line.trim().split_once(char::is_whitespace).unwrap_or((line.trim(), ""));
            if keyword.eq_ignore_ascii_case("newmtl") {
                let started = Definition::new(Rc::clone(&folder));
                // As statements lose the backslash at their end, which would join lines.
                let name = arguments.trim().trim_end_matches('\\').trim_end();
                let place = self.definitions.entry(name.to_owned());
                definition = Some(place.insert_entry(started).into_mut());
            } else if let Some(definition) = &mut definition {
                definition.add(&keyword.to_ascii_lowercase(), arguments);
            }
        }
    }

    /// The index of a material among those in use.
    pub fn use_material(&mut self, name: &str) -> usize {
        *self.index_of_used.entry(name.to_owned()).or_insert_with(|| {
            self.used.push(name.to_owned());
            self.used.len() - 1
        })
    }

    /// The materials of `runs`, which name them by their index among those in use.
    pub fn finish(self, runs: Vec<Run>) -> Appearance {
        let mut appearance = Appearance::default();
        let mut images = Images::new(self.resources);
        let mut is_used = vec![false; self.used.len()];
        runs.iter().filter_map(|run| run.material).for_each(|material| is_used[material] = true);
        let mut index_of_used = vec![None; self.used.len()];
        for (used, name) in self.used.iter().enumerate().filter(|&(used, _)| is_used[used]) {
            if let Some(definition) = self.definitions.get(name) {
                index_of_used[used] = Some(appearance.materials.len());
                appearance.materials.push(definition.material(&mut images));
            }
        }
        if !appearance.materials.is_empty() {
            for run in runs {
                let material = run.material.and_then(|used| index_of_used[used]);
                match appearance.runs.last_mut().filter(|last| last.material == material) {
                    Some(last) => last.triangles.end = run.triangles.end,
                    None => appearance.runs.push(Run { material, ..run }),
                }
            }
        }
        appearance.images = images.images;
        appearance.missing = self.missing;
        appearance.missing.extend(images.missing);
        appearance
    }
}
