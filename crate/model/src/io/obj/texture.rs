//! Map statements of material libraries, and the image files that they name.

use std::collections::HashMap;

use crate::appearance::{Image, Texels, Texture, Wrap};
use crate::io::reader::Resources;

/// A map statement: `map_Kd -s 2 2 -clamp on wood.png`.
#[derive(Clone, Debug, PartialEq)]
pub struct Map {
    file: String,
    scale: [f32; 2],
    offset: [f32; 2],
    is_clamped: bool,
    /// That a scalar map takes, 0 to 3.
    channel: usize,
    /// Factor on a bump map.
    pub bump: f32,
}

impl Map {
    /// None where no file is named.
    pub fn parse(arguments: &str) -> Option<Self> {
        let mut map =
            Self { file: String::new(), scale: [1.0; 2], offset: [0.0; 2], is_clamped: false, channel: 0, bump: 1.0 };
        let mut rest = arguments.trim();
        while let Some(option) = rest.strip_prefix('-') {
            let (name, after) = word(option);
            rest = after;
            match name {
                "o" => map.offset = triple(&mut rest, 0.0),
                // A scale of 0 would show one texel.
                "s" => map.scale = triple(&mut rest, 1.0).map(|scale| if scale == 0.0 { 1.0 } else { scale }),
                "t" => drop(triple(&mut rest, 0.0)),
                "mm" => drop([number(&mut rest), number(&mut rest)]),
                "bm" => map.bump = number(&mut rest).unwrap_or(1.0),
                "clamp" => map.is_clamped = next(&mut rest).eq_ignore_ascii_case("on"),
                "imfchan" => {
                    map.channel = match next(&mut rest) {
                        "g" => 1,
                        "b" => 2,
                        "m" => 3,
                        _ => 0,
                    }
                }
                // blendu, blendv, boost, cc, texres, type: a word each.
                _ => drop(next(&mut rest)),
            }
        }
        map.file = rest.trim_matches('"').to_owned();
        (!map.file.is_empty()).then_some(map)
    }

    /// Whether both show the same file.
    pub fn is_of_file(&self, other: &Self) -> bool {
        self.file == other.file
    }

    /// Of the image of this index.
    pub fn texture(&self, image: usize) -> Texture {
        let ([u, v], [x, y]) = (self.scale, self.offset);
        // Offset and scale count v upward.
        let transform = [[u, 0.0, x], [0.0, v, 1.0 - v - y]];
        let wrap = if self.is_clamped { Wrap::Clamp } else { Wrap::Repeat };
        Texture { image, set: 0, transform, wrap: [wrap; 2], is_sharp: false }
    }
}

/// The first word, and what follows it.
fn word(text: &str) -> (&str, &str) {
    let text = text.trim_start();
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

fn next<'a>(rest: &mut &'a str) -> &'a str {
    let (word, after) = word(rest);
    *rest = after;
    word
}

/// The next word where it is a finite number.
fn number(rest: &mut &str) -> Option<f32> {
    let (word, after) = word(rest);
    let number = word.parse().ok().filter(|number: &f32| number.is_finite())?;
    *rest = after;
    Some(number)
}

/// The first two of up to three numbers.
fn triple(rest: &mut &str, default: f32) -> [f32; 2] {
    [number(rest), number(rest), number(rest)].map(|number| number.unwrap_or(default))[..2]
        .try_into()
        .unwrap_or_default()
}

/// The images that materials use, each once.
pub struct Images<'a> {
    resources: Resources<'a>,
    by_file: HashMap<(String, Texels), usize>,
    pub images: Vec<Image>,
    /// Files that were not given.
    pub missing: Vec<String>,
}

impl<'a> Images<'a> {
    pub fn new(resources: Resources<'a>) -> Self {
        Self { resources, by_file: HashMap::new(), images: Vec::new(), missing: Vec::new() }
    }

    /// The index of the image of a map, named relative to `folder`.
    pub fn of(&mut self, folder: &str, map: &Map, texels: Texels) -> usize {
        let key = (map.file.clone(), texels);
        if let Some(&index) = self.by_file.get(&key) {
            return index;
        }
        let bytes = find(self.resources, folder, &map.file);
        if bytes.is_none() && !self.missing.contains(&map.file) {
            self.missing.push(map.file.clone());
        }
        let image = Image { name: map.file.clone(), bytes: bytes.unwrap_or_default(), texels, ..Image::default() };
        let index = self.add(image);
        self.by_file.insert(key, index);
        index
    }

    /// The index of an image whose red, green, blue and alpha are those of maps.
    pub fn of_channels(&mut self, folder: &str, channels: [Option<(&Map, Option<usize>)>; 4]) -> usize {
        let channels = channels.map(|channel| {
            channel.map(|(map, channel)| (self.of(folder, map, Texels::Encoded), channel.unwrap_or(map.channel)))
        });
        self.add(Image { texels: Texels::Channels(channels), ..Image::default() })
    }

    fn add(&mut self, image: Image) -> usize {
        self.images.push(image);
        self.images.len() - 1
    }
}

/// The bytes of a file as a library in `folder` names it: from there, else from beside the mesh, else by its name alone, since many
/// programs write paths of the machine that they ran on.
pub fn find(resources: Resources, folder: &str, file: &str) -> Option<Vec<u8>> {
    let file = file.replace('\\', "/");
    let name = file.rsplit('/').next().unwrap_or(&file);
    let mut places = vec![format!("{folder}{file}"), file.clone(), name.to_owned()];
    places.dedup();
    places.iter().find_map(|place| resources(place))
}
