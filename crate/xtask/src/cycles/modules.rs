//! The modules of a crate, with what each defines, imports and names.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Macro, Meta, UseTree, Visibility};

/// A module and its own code, without that of its children.
pub struct Module {
    /// The last part of its path; `crate` for the root.
    pub name: String,
    pub file: PathBuf,
    pub parent: Option<usize>,
    pub children: BTreeMap<String, usize>,
    pub defined: BTreeSet<String>,
    pub imports: Vec<Import>,
    /// Every path in its code but those of imports.
    pub paths: Vec<Named>,
    /// Where the files of its children lie.
    folder: PathBuf,
}

/// `use path as name`.
pub struct Import {
    /// None brings in everything.
    pub name: Option<String>,
    pub path: Named,
    pub is_exported: bool,
}

/// A path of the code, and its line.
pub struct Named {
    pub segments: Vec<String>,
    pub line: usize,
}

impl Module {
    fn new(name: String, file: PathBuf, parent: Option<usize>, folder: PathBuf) -> Self {
        Self {
            name,
            file,
            parent,
            children: BTreeMap::new(),
            defined: BTreeSet::new(),
            imports: Vec::new(),
            paths: Vec::new(),
            folder,
        }
    }

    pub fn file_name(&self) -> String {
        self.file.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }

    /// Where the files of its children lie.
    pub fn folder(&self) -> &Path {
        &self.folder
    }
}

/// All modules of the crate whose `lib.rs` or `main.rs` this is, the root first.
pub fn read(root: &Path) -> Result<Vec<Module>> {
    let folder = root.parent().context("A crate's root lies in a folder")?.to_owned();
    let mut reader =
        Reader { modules: vec![Module::new("crate".into(), root.to_owned(), None, folder)], at: 0, error: None };
    reader.read_file(root)?;
    Ok(reader.modules)
}

/// Walks through the code; `at` is the module that it belongs to.
struct Reader {
    modules: Vec<Module>,
    at: usize,
    error: Option<anyhow::Error>,
}

impl Reader {
    fn read_file(&mut self, path: &Path) -> Result<()> {
        let text = fs::read_to_string(path).with_context(|| format!("{} cannot be read", path.display()))?;
        let file = syn::parse_file(&text).with_context(|| format!("{} is not Rust", path.display()))?;
        self.visit_file(&file);
        self.error.take().map_or(Ok(()), Err)
    }

    fn read_module(&mut self, item: &ItemMod) -> Result<()> {
        let (name, parent) = (item.ident.to_string(), self.at);
        let folder = self.modules[parent].folder.join(&name);
        let inline = item.content.as_ref().map(|(_, items)| items);
        let file = match inline {
            Some(_) => self.modules[parent].file.clone(),
            None => {
                let candidates = [folder.with_extension("rs"), folder.join("mod.rs")];
                let Some(file) = candidates.into_iter().find(|file| file.is_file()) else {
                    bail!("There is no file of the module {}", folder.display());
                };
                file
            }
        };
        self.at = self.modules.len();
        self.modules.push(Module::new(name.clone(), file.clone(), Some(parent), folder));
        self.modules[parent].children.insert(name, self.at);
        match inline {
            Some(items) => items.iter().for_each(|item| self.visit_item(item)),
            None => self.read_file(&file)?,
        }
        self.at = parent;
        Ok(())
    }

    fn here(&mut self) -> &mut Module {
        &mut self.modules[self.at]
    }

    fn import(&mut self, tree: &UseTree, prefix: &[String], is_exported: bool) {
        let with = |name: String| [prefix, &[name]].concat();
        let line = tree.span().start().line;
        let mut push = |name, segments| {
            self.here().imports.push(Import { name, path: Named { segments, line }, is_exported });
        };
        match tree {
            UseTree::Path(path) => self.import(&path.tree, &with(path.ident.to_string()), is_exported),
            UseTree::Group(group) => group.items.iter().for_each(|tree| self.import(tree, prefix, is_exported)),
            UseTree::Glob(_) => push(None, prefix.to_vec()),
            UseTree::Rename(rename) => push(Some(rename.rename.to_string()), with(rename.ident.to_string())),
            // `a::{self}` brings in `a`.
            UseTree::Name(name) if name.ident == "self" => push(prefix.last().cloned(), prefix.to_vec()),
            UseTree::Name(name) => push(Some(name.ident.to_string()), with(name.ident.to_string())),
        }
    }

    /// What looks like a path among the tokens of a macro call.
    fn read_tokens(&mut self, tokens: TokenStream) {
        let mut segments = Vec::new();
        let mut line = 0;
        let mut colons = 0;
        let mut is_member = false;
        for token in tokens {
            let (was_member, joined) = (is_member, colons == 2);
            is_member = false;
            match token {
                TokenTree::Punct(punct) if punct.as_char() == ':' && colons < 2 => {
                    colons += 1;
                    continue;
                }
                TokenTree::Ident(ident) if !was_member => {
                    if !joined {
                        self.name(std::mem::take(&mut segments), line);
                        line = ident.span().start().line;
                    }
                    segments.push(ident.to_string());
                }
                TokenTree::Punct(punct) => is_member = punct.as_char() == '.',
                TokenTree::Group(group) => self.read_tokens(group.stream()),
                TokenTree::Ident(_) | TokenTree::Literal(_) => {}
            }
            colons = 0;
        }
        self.name(segments, line);
    }

    fn name(&mut self, segments: Vec<String>, line: usize) {
        if !segments.is_empty() {
            self.here().paths.push(Named { segments, line });
        }
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast Item) {
        if !attributes(item).iter().any(is_for_tests) {
            visit::visit_item(self, item);
        }
    }

    fn visit_file(&mut self, file: &'ast syn::File) {
        let names: Vec<String> = file.items.iter().filter_map(defined_name).collect();
        self.here().defined.extend(names);
        visit::visit_file(self, file);
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if let Err(error) = self.read_module(item) {
            self.error.get_or_insert(error);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        if item.leading_colon.is_none() {
            self.import(&item.tree, &[], !matches!(item.vis, Visibility::Inherited));
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            let segments = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
            self.name(segments, path.span().start().line);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.visit_path(&call.path);
        self.read_tokens(call.tokens.clone());
    }

    /// `pub(super)` uses nothing.
    fn visit_visibility(&mut self, _: &'ast Visibility) {}
}

fn attributes(item: &Item) -> &[Attribute] {
    match item {
        Item::Const(item) => &item.attrs,
        Item::Enum(item) => &item.attrs,
        Item::Fn(item) => &item.attrs,
        Item::Impl(item) => &item.attrs,
        Item::Macro(item) => &item.attrs,
        Item::Mod(item) => &item.attrs,
        Item::Static(item) => &item.attrs,
        Item::Struct(item) => &item.attrs,
        Item::Trait(item) => &item.attrs,
        Item::Type(item) => &item.attrs,
        Item::Use(item) => &item.attrs,
        _ => &[],
    }
}

/// `#[cfg(test)]` or `#[cfg(all(test, ...))]`.
fn is_for_tests(attribute: &Attribute) -> bool {
    let Meta::List(list) = &attribute.meta else { return false };
    let mut is_for_tests = false;
    // What is no condition is no condition of tests.
    let _ = list.path.is_ident("cfg").then(|| {
        list.parse_nested_meta(|condition| {
            is_for_tests |= condition.path.is_ident("test");
            if condition.path.is_ident("all") {
                condition.parse_nested_meta(|each| {
                    is_for_tests |= each.path.is_ident("test");
                    Ok(())
                })?;
            }
            Ok(())
        })
    });
    is_for_tests
}

/// The name by which others call an item of a module.
fn defined_name(item: &Item) -> Option<String> {
    let name = match item {
        Item::Const(item) => &item.ident,
        Item::Enum(item) => &item.ident,
        Item::Fn(item) => &item.sig.ident,
        Item::Macro(item) => item.ident.as_ref()?,
        Item::Static(item) => &item.ident,
        Item::Struct(item) => &item.ident,
        Item::Trait(item) => &item.ident,
        Item::Type(item) => &item.ident,
        Item::Union(item) => &item.ident,
        _ => return None,
    };
    Some(name.to_string())
}
