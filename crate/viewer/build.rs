//! Puts the shaders together, and translates them where the feature `webgl2` is on: what is wrong with one fails the build then.

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
        fs::write(folder.join(name), text(name, &source)).expect("OUT_DIR can be written to");
    }
}

fn read(file: &str) -> String {
    let path = format!("src/{file}.wgsl");
    println!("cargo::rerun-if-changed={path}");
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// WGSL without its comments, which nobody reads on a page.
#[cfg(not(feature = "webgl2"))]
fn text(_name: &str, source: &str) -> String {
    let lines = source.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("//"));
    lines.flat_map(|line| [line, "\n"]).collect()
}

/// The entry points in GLSL, as `heatwalk-webgl` takes them.
#[cfg(feature = "webgl2")]
fn text(name: &str, source: &str) -> String {
    let module = naga::front::wgsl::parse_str(source)
        .unwrap_or_else(|error| panic!("the shader {name}: {}", error.emit_to_string(source)));
    glsl::validated(&module).unwrap_or_else(|error| panic!("the shader {name}: {}", error.emit_to_string(source)));
    module.entry_points.iter().map(|entry| glsl::entry(&module, entry)).collect()
}

#[cfg(feature = "webgl2")]
mod glsl {
    use naga::back::glsl::{Options, PipelineOptions, ReflectionInfo, Version, Writer, WriterFlags};
    use naga::compact::{KeepUnused, compact};
    use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
    use naga::valid::{Capabilities, ModuleInfo, ValidationError, ValidationFlags, Validator};
    use naga::{EntryPoint, Handle, Module, ShaderStage, WithSpan};

    pub fn validated(module: &Module) -> Result<ModuleInfo, Box<WithSpan<ValidationError>>> {
        // WebGL2 has none of the optional capabilities.
        Validator::new(ValidationFlags::all(), Capabilities::empty()).validate(module).map_err(Box::new)
    }

    /// One of the entry points of a module, below the line that tells what it uses.
    pub fn entry(module: &Module, entry: &EntryPoint) -> String {
        let mut module = module.clone();
        module.entry_points.retain(|other| other.name == entry.name);
        compact(&mut module, KeepUnused::No);
        let info = validated(&module).expect("a part of a module is valid where all of it is");
        let options = Options {
            version: Version::Embedded { version: 300, is_webgl: true },
            // As wgpu has them, but for the size of points, of which none are drawn.
            writer_flags: WriterFlags::ADJUST_COORDINATE_SPACE,
            ..Options::default()
        };
        let pipeline = PipelineOptions { shader_stage: entry.stage, entry_point: entry.name.clone(), multiview: None };
        let unchecked = BoundsCheckPolicies {
            index: BoundsCheckPolicy::Unchecked,
            buffer: BoundsCheckPolicy::Unchecked,
            image_load: BoundsCheckPolicy::Unchecked,
            binding_array: BoundsCheckPolicy::Unchecked,
        };
        let mut text = String::new();
        let written = Writer::new(&mut text, &module, &info, &options, &pipeline, unchecked)
            .and_then(|mut writer| writer.write())
            .unwrap_or_else(|error| panic!("the entry point {}: {error}", entry.name));
        let mut words = format!("//{}", entry.name);
        for (old, new) in places(&module, &written, entry.stage) {
            text = text.replace(&old, &new);
            words = format!("{words} {new}");
        }
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
        std::iter::once(words.as_str()).chain(lines).flat_map(|line| [line, "\n"]).collect()
    }

    /// The names of the uniforms, and those that tell where they are bound; in order.
    fn places(module: &Module, written: &ReflectionInfo, stage: ShaderStage) -> Vec<(String, String)> {
        let stage = if stage == ShaderStage::Vertex { "v" } else { "f" };
        let place = |variable: Handle<_>| {
            let binding = module.global_variables[variable].binding.expect("uniforms are bound");
            format!("{}_{}", binding.group, binding.binding)
        };
        let blocks =
            written.uniforms.iter().map(|(block, name)| (name.clone(), format!("u_{}_{stage}", place(*block))));
        let textures = written.texture_mapping.iter().map(|(name, mapping)| {
            let sampler = place(mapping.sampler.expect("textures are read by samplers"));
            (name.clone(), format!("t_{}_{sampler}", place(mapping.texture)))
        });
        let mut places: Vec<_> = blocks.chain(textures).collect();
        places.sort();
        places
    }
}
