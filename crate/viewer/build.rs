//! Puts the shaders together, and parses them where the feature `parsed` is on: what is wrong with one fails the build.

use std::path::PathBuf;
use std::{env, fs};

/// The shaders and the files of `src` that each is put together from.
const SHADERS: [(&str, &[&str]); 13] = [
    ("arrow", &["shared", "arrow"]),
    ("background", &["shared", "background"]),
    ("curve", &["shared", "curve"]),
    ("cut", &["shared", "surface", "cut"]),
    ("ground", &["shared", "ground"]),
    ("mipmap", &["mipmap"]),
    ("model", &["shared", "surface", "model"]),
    ("pin", &["shared", "pin"]),
    ("section", &["shared", "surface", "section"]),
    ("shell", &["shared", "surface", "shell"]),
    ("surface", &["shared", "surface"]),
    ("walker", &["shared", "walker"]),
    ("wire", &["shared", "wire"]),
];

fn main() {
    let folder = PathBuf::from(env::var_os("OUT_DIR").expect("cargo sets OUT_DIR"));
    for (name, files) in SHADERS {
        let source: String = files.iter().map(|file| read(file)).collect();
        fs::write(folder.join(name), built(name, &source)).expect("OUT_DIR can be written to");
    }
}

fn read(file: &str) -> String {
    let path = format!("src/{file}.wgsl");
    println!("cargo::rerun-if-changed={path}");
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// The text without its comments, which nobody reads on a page.
#[cfg(not(feature = "parsed"))]
fn built(_name: &str, source: &str) -> Vec<u8> {
    let lines = source.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.flat_map(|line| [line, "\n"]).collect::<String>().into_bytes()
}

/// The shader as naga has it, without what no entry point uses.
#[cfg(feature = "parsed")]
fn built(name: &str, source: &str) -> Vec<u8> {
    use naga::compact::{KeepUnused, compact};
    use naga::front::wgsl;
    use naga::valid::{Capabilities, ValidationFlags, Validator};

    let mut module =
        wgsl::parse_str(source).unwrap_or_else(|error| panic!("the shader {name}: {}", error.emit_to_string(source)));
    // WebGL2 has none of the optional capabilities.
    Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .unwrap_or_else(|error| panic!("the shader {name}: {}", error.emit_to_string(source)));
    compact(&mut module, KeepUnused::No);
    postcard::to_allocvec(&module).expect("a module has nothing that postcard cannot write")
}
