//! The contract as TypeScript.

use std::fmt::Write as _;

use anyhow::{Context, Result};

use crate::read::{Choice, Constant, Definitions, Field, FieldKind, Options, Value};

/// A module that exports all of it.
///
/// # Errors
/// Where the options name a choice, or `enums` an enum, that is not defined.
pub fn module(definitions: &Definitions, sources: &[&str], enums: &[&str]) -> Result<String> {
    let mut text = format!("// Made by `cargo xtask wasm` from {}.\n", sources.join(", "));
    text += "
/** Names to choose from, in the order in which they are offered. */
export interface Choice<Name extends string> {
  readonly names: readonly Name[];
  readonly default: Name;
  /** Names that were written once, and what they are called now. */
  readonly former: Readonly<Record<string, Name>>;
}
";
    for Constant { of, name, doc, value } in &definitions.constants {
        let owner = of.as_ref().map_or_else(String::new, |of| constant(of) + "_");
        text += &documented(doc, "");
        text += &format!("export const {owner}{name} = {};\n", written(value));
    }
    for choice in &definitions.choices {
        text += &choice_of(choice);
    }
    for name in enums {
        let (doc, names) = definitions.variants(name)?;
        let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
        text += &documented(doc, "");
        text += &format!("export type {name} = {};\n", names.join(" | "));
    }
    for options in &definitions.options {
        text += &interface(options, definitions)?;
    }
    Ok(text)
}

fn written(value: &Value) -> String {
    match value {
        Value::Word(word) => quoted(word),
        Value::Number(number) => number.to_string(),
        Value::Words(words) => {
            let words: Vec<String> = words.iter().map(|word| quoted(word)).collect();
            format!("[{}] as const", words.join(", "))
        }
        Value::Numbers(numbers) => {
            let numbers: Vec<String> = numbers.iter().map(f64::to_string).collect();
            format!("[{}] as const", numbers.join(", "))
        }
    }
}

fn choice_of(choice: &Choice) -> String {
    let Choice { name, doc, variants, default } = choice;
    let mut lines = doc.clone();
    lines.extend(variants.iter().map(|variant| format!("- `{}`: {}", variant.name, variant.doc.join(" "))));
    let names: Vec<String> = variants.iter().map(|variant| quoted(&variant.name)).collect();
    let former = |variant: &crate::read::Variant| {
        let name = quoted(&variant.name);
        variant.former_names.iter().map(|former| format!("{}: {name}", quoted(former))).collect::<Vec<_>>()
    };
    let former: Vec<String> = variants.iter().flat_map(former).collect();
    let former = if former.is_empty() { "{}".to_owned() } else { format!("{{ {} }}", former.join(", ")) };
    let mut text = documented(&lines, "");
    // Writing to a String cannot fail.
    let _ = writeln!(text, "export type {name} = {};", names.join(" | "));
    let _ = writeln!(
        text,
        "export const {}: Choice<{name}> = {{\n  names: [{}],\n  default: {},\n  former: {former},\n}};",
        constant(name),
        names.join(", "),
        names[*default]
    );
    text
}

fn interface(options: &Options, definitions: &Definitions) -> Result<String> {
    let Options { name, doc, fields } = options;
    let mut text = documented(doc, "");
    text += &format!("export interface {name} {{");
    for Field { name, doc, kind } in fields {
        let holds = match kind {
            FieldKind::Choice(choice) => choice,
            FieldKind::Automatic => "number | typeof AUTOMATIC",
        };
        text += &documented(doc, "  ");
        text += &format!("  {}: {holds};\n", camel(name));
    }
    text += &format!("}}\nexport const DEFAULT_{}: {name} = {{\n", constant(name));
    for Field { name, kind, .. } in fields {
        let default = match kind {
            FieldKind::Choice(choice) => {
                let choice = definitions.choices.iter().find(|known| known.name == *choice);
                let choice = choice.with_context(|| format!("{name} is of a choice that is not defined"))?;
                quoted(&choice.variants[choice.default].name)
            }
            FieldKind::Automatic => "AUTOMATIC".to_owned(),
        };
        text += &format!("  {}: {default},\n", camel(name));
    }
    Ok(text + "};\n")
}

fn quoted(text: &str) -> String {
    format!("'{}'", text.replace('\\', "\\\\").replace('\'', "\\'"))
}

/// A comment above what is exported, after an empty line.
#[must_use]
pub fn documented(lines: &[String], indent: &str) -> String {
    let lines: Vec<String> = lines.iter().map(|line| line.replace("*/", "* /")).collect();
    match &lines[..] {
        [] => "\n".to_owned(),
        [line] => format!("\n{indent}/** {line} */\n"),
        lines => {
            let lines: String = lines.iter().map(|line| format!("{indent} * {line}\n")).collect();
            format!("\n{indent}/**\n{lines}{indent} */\n")
        }
    }
}

/// `TypeName` as `TYPE_NAME`.
fn constant(name: &str) -> String {
    let mut constant = String::new();
    for (index, letter) in name.char_indices() {
        if index > 0 && letter.is_uppercase() {
            constant.push('_');
        }
        constant.extend(letter.to_uppercase());
    }
    constant
}

/// `field_name` as `fieldName`.
#[must_use]
pub fn camel(name: &str) -> String {
    let mut parts = name.split('_');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |name, part| {
        let mut letters = part.chars();
        name + &letters.next().map(|letter| letter.to_uppercase().collect::<String>()).unwrap_or_default()
            + letters.as_str()
    })
}
