//! What a source file defines of the contract.

use std::collections::BTreeMap;

use anyhow::{Context, Result, bail};
use syn::parse::{Parse, ParseStream};
use syn::{Attribute, Expr, Ident, Item, ItemEnum, ItemStruct, Lit, LitStr, Member, Meta, Token, Type, Visibility};

/// Everything that is defined, in the order of the sources.
#[derive(Default)]
pub struct Definitions {
    pub constants: Vec<Constant>,
    pub choices: Vec<Choice>,
    pub options: Vec<Options>,
    enums: BTreeMap<String, Enum>,
}

/// `pub const NAME`.
pub struct Constant {
    /// The type that it is of.
    pub of: Option<String>,
    pub name: String,
    pub doc: Vec<String>,
    pub value: Value,
}

/// What a constant is.
pub enum Value {
    Word(String),
    Number(f64),
    Words(Vec<String>),
    /// An array, or both ends of a range.
    Numbers(Vec<f64>),
}

/// An enum that `choice!` gives names.
pub struct Choice {
    pub name: String,
    pub doc: Vec<String>,
    pub variants: Vec<Variant>,
    /// Index of the default.
    pub default: usize,
}

/// One of a choice.
pub struct Variant {
    pub name: String,
    pub former_names: Vec<String>,
    pub doc: Vec<String>,
}

/// A struct whose fields are choices, or numbers that may be left to the solver.
pub struct Options {
    pub name: String,
    pub doc: Vec<String>,
    pub fields: Vec<Field>,
}

/// A field of options.
pub struct Field {
    pub name: String,
    pub doc: Vec<String>,
    pub kind: FieldKind,
}

/// What a field holds.
pub enum FieldKind {
    /// The choice of this name.
    Choice(String),
    /// A number, or "auto".
    Automatic,
}

struct Enum {
    doc: Vec<String>,
    variants: Vec<(Ident, Vec<String>)>,
    default: Option<usize>,
}

/// `Type, "what": Variant = "name" | "former name", ...`: the arguments of `choice!`.
struct Names {
    of: Ident,
    variants: Vec<(Ident, Vec<LitStr>)>,
}

impl Parse for Names {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let of = input.parse()?;
        input.parse::<Token![,]>()?;
        input.parse::<LitStr>()?;
        input.parse::<Token![:]>()?;
        let variant = |input: ParseStream<'_>| {
            let variant = input.parse()?;
            input.parse::<Token![=]>()?;
            let mut names = vec![input.parse()?];
            while input.parse::<Option<Token![|]>>()?.is_some() {
                names.push(input.parse()?);
            }
            Ok((variant, names))
        };
        let variants = input.parse_terminated(variant, Token![,])?.into_iter().collect();
        Ok(Self { of, variants })
    }
}

impl Definitions {
    /// Adds what a source file defines.
    ///
    /// # Errors
    /// Where that is no Rust, or a definition has a form that is not expected.
    pub fn read(&mut self, source: &str) -> Result<()> {
        for item in syn::parse_file(source)?.items {
            match item {
                Item::Enum(item) => self.read_enum(&item),
                Item::Macro(item) if item.mac.path.is_ident("choice") => {
                    let names = item.mac.parse_body()?;
                    self.read_choice(names)?;
                }
                Item::Struct(item) if is_public(&item.vis) => self.read_options(&item)?,
                Item::Const(item) if is_public(&item.vis) => {
                    if let Some(value) = value(&item.expr) {
                        let (name, doc) = (item.ident.to_string(), doc(&item.attrs));
                        self.constants.push(Constant { of: None, name, doc, value });
                    }
                }
                Item::Impl(item) if item.trait_.is_none() => {
                    let of = type_name(&item.self_ty)?;
                    for item in item.items {
                        if let syn::ImplItem::Const(item) = item
                            && is_public(&item.vis)
                            && let Some(ends) = ends(&item.expr)
                        {
                            let (name, doc) = (item.ident.to_string(), doc(&item.attrs));
                            let value = Value::Numbers(ends.to_vec());
                            self.constants.push(Constant { of: Some(of.clone()), name, doc, value });
                        }
                    }
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The documentation of an enum, and the names of its variants.
    ///
    /// # Errors
    /// Where it is not defined.
    pub fn variants(&self, name: &str) -> Result<(&[String], Vec<String>)> {
        let item = self.enums.get(name).with_context(|| format!("{name} is not defined"))?;
        Ok((&item.doc, item.variants.iter().map(|(variant, _)| variant.to_string()).collect()))
    }

    fn read_enum(&mut self, item: &ItemEnum) {
        let is_default = |variant: &syn::Variant| variant.attrs.iter().any(|part| part.path().is_ident("default"));
        let variants = item.variants.iter().map(|variant| (variant.ident.clone(), doc(&variant.attrs))).collect();
        let default = item.variants.iter().position(is_default);
        self.enums.insert(item.ident.to_string(), Enum { doc: doc(&item.attrs), variants, default });
    }

    fn read_choice(&mut self, names: Names) -> Result<()> {
        let name = names.of.to_string();
        let item = self.enums.get(&name).with_context(|| format!("{name} is no enum above its names"))?;
        let variants = names.variants.into_iter().map(|(variant, names)| {
            let (_, doc) = item.variants.iter().find(|(known, _)| *known == variant)?;
            let mut names = names.iter().map(LitStr::value);
            Some(Variant { name: names.next()?, former_names: names.collect(), doc: doc.clone() })
        });
        let variants = variants.collect::<Option<Vec<_>>>();
        let variants = variants.with_context(|| format!("{name} has not the variants that are named"))?;
        let default = item.default.with_context(|| format!("{name} has no default"))?;
        self.choices.push(Choice { name, doc: item.doc.clone(), variants, default });
        Ok(())
    }

    fn read_options(&mut self, item: &ItemStruct) -> Result<()> {
        let fields = item.fields.iter().filter(|field| is_public(&field.vis)).map(|field| {
            let name = field.ident.as_ref().context("a field has no name")?.to_string();
            let of = type_name(&field.ty)?;
            let is_automatic = |item: &Enum| item.variants.iter().any(|(variant, _)| variant == "Automatic");
            let kind = if self.choices.iter().any(|choice| choice.name == of) {
                FieldKind::Choice(of)
            } else if self.enums.get(&of).is_some_and(is_automatic) {
                FieldKind::Automatic
            } else {
                bail!("{name} is neither a choice nor a number that may be automatic")
            };
            Ok(Field { name, doc: doc(&field.attrs), kind })
        });
        let fields = fields.collect::<Result<Vec<_>>>()?;
        if !fields.is_empty() {
            self.options.push(Options { name: item.ident.to_string(), doc: doc(&item.attrs), fields });
        }
        Ok(())
    }
}

/// The extensions of files that a source file defines: the first words of its `EXTENSIONS`, and those of its `FORMAT`.
///
/// # Errors
/// Where that is no Rust.
pub fn extensions(source: &str) -> Result<Vec<String>> {
    let mut found = Vec::new();
    for item in syn::parse_file(source)?.items {
        let Item::Const(item) = item else { continue };
        match &*item.expr {
            Expr::Array(pairs) if item.ident == "EXTENSIONS" => found.extend(pairs.elems.iter().filter_map(first_word)),
            Expr::Struct(format) if item.ident == "FORMAT" => {
                let field =
                    |field: &&syn::FieldValue| matches!(&field.member, Member::Named(name) if name == "extensions");
                if let Some(Expr::Reference(list)) = format.fields.iter().find(field).map(|field| &field.expr)
                    && let Expr::Array(words) = &*list.expr
                {
                    found.extend(words.elems.iter().filter_map(word));
                }
            }
            _ => {}
        }
    }
    Ok(found)
}

/// Of a pair, or itself.
fn first_word(expression: &Expr) -> Option<String> {
    match expression {
        Expr::Tuple(pair) => word(pair.elems.first()?),
        alone => word(alone),
    }
}

fn word(expression: &Expr) -> Option<String> {
    match value(expression) {
        Some(Value::Word(word)) => Some(word),
        _ => None,
    }
}

fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

fn type_name(path: &Type) -> Result<String> {
    match path {
        Type::Path(path) => Ok(path.path.segments.last().context("a type has no name")?.ident.to_string()),
        _ => bail!("a type is no path"),
    }
}

/// Both ends of `a..=b`; None for another expression.
fn ends(expression: &Expr) -> Option<[f64; 2]> {
    let Expr::Range(range) = expression else { return None };
    let number = |end: &Option<Box<Expr>>| match end.as_deref()? {
        Expr::Lit(end) => match &end.lit {
            Lit::Float(number) => number.base10_parse().ok(),
            Lit::Int(number) => number.base10_parse().ok(),
            _ => None,
        },
        _ => None,
    };
    Some([number(&range.start)?, number(&range.end)?])
}

/// A text, a whole number, or an array of these numbers; None for another expression.
fn value(expression: &Expr) -> Option<Value> {
    let literal = |value: &Expr| match value {
        Expr::Lit(value) => match &value.lit {
            Lit::Str(word) => Some(Value::Word(word.value())),
            Lit::Int(number) => number.base10_parse().ok().map(Value::Number),
            _ => None,
        },
        _ => None,
    };
    let number = |value: &Expr| match literal(value)? {
        Value::Number(number) => Some(number),
        _ => None,
    };
    match expression {
        Expr::Array(array) => array.elems.iter().map(number).collect::<Option<_>>().map(Value::Numbers),
        single => literal(single),
    }
}

/// The lines of a documentation comment.
#[must_use]
pub fn doc(attributes: &[Attribute]) -> Vec<String> {
    let line = |attribute: &Attribute| {
        let Meta::NameValue(meta) = &attribute.meta else { return None };
        let Expr::Lit(value) = &meta.value else { return None };
        let Lit::Str(text) = &value.lit else { return None };
        meta.path.is_ident("doc").then(|| text.value().trim().to_owned())
    };
    attributes.iter().filter_map(line).collect()
}
