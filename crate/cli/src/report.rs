//! What the commands print: one JSON object, or aligned lines.

use std::fmt::{Display, Write as _};
use std::time::Instant;

use heatwalk::{BuildReport, Joined, LengthUnit, Link, RelativeError, Soup, Stage, Unit, Warning};
use heatwalk_model::Motion;
use heatwalk_model::motion::Clip;
use serde_json::{Map, Value, json};

/// Numbers of a list that are printed; of a longer one only how many there are.
const FEW: usize = 8;

pub fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

pub fn object(values: impl IntoIterator<Item = (&'static str, Value)>) -> Value {
    Value::Object(values.into_iter().map(|(name, value)| (name.to_owned(), value)).collect())
}

/// Pushes fields of a struct under their own names.
macro_rules! push_fields {
    ($report:ident, $of:ident { $($field:ident),+ $(,)? }) => {
        $($report.push(stringify!($field), $of.$field);)+
    };
}
pub(crate) use push_fields;

/// Named values in the order they are printed.
#[derive(Default)]
pub struct Report {
    values: Vec<(&'static str, Value)>,
}

impl Report {
    pub fn push(&mut self, name: &'static str, value: impl Into<Value>) {
        self.values.push((name, value.into()));
    }

    pub fn extend(&mut self, values: impl IntoIterator<Item = (&'static str, Value)>) {
        self.values.extend(values);
    }

    /// What is told of the path `to` each of these places: of several in a list.
    pub fn push_paths(&mut self, to: &[impl Display], mut facts: Vec<Vec<(&'static str, Value)>>) {
        if facts.len() == 1 {
            self.extend(facts.remove(0));
            return;
        }
        let path = |(to, facts): (&_, Vec<_>)| object([("to", json!(format!("{to}")))].into_iter().chain(facts));
        self.push("paths", to.iter().zip(facts).map(path).collect::<Vec<_>>());
    }

    pub fn push_error(&mut self, error: RelativeError) {
        self.push("mean_error_percent", 100.0 * error.mean);
        self.push("max_error_percent", 100.0 * error.max);
    }

    /// The counts that every command gives.
    pub fn push_surface(&mut self, report: &BuildReport) {
        self.push("vertices", report.input_vertices);
        self.push("faces", report.faces);
        self.push("welded_vertices", report.vertices);
        self.push("components", report.components);
        self.push("boundary_loops", report.boundary_loops);
    }

    /// Of lengths, and whether only the size of the model suggests it.
    pub fn push_unit(&mut self, LengthUnit { unit, is_assumed }: LengthUnit) {
        self.push("unit", unit.map(Unit::symbol));
        self.push("unit_assumed", is_assumed);
    }

    /// What the file was read without, or otherwise than it is written.
    pub fn push_warnings(&mut self, warnings: &[Warning]) {
        let warning =
            |warning: &Warning| json!({ "code": warning.code.name(), "what": warning.what(), "where": warning.place });
        self.push("warnings", warnings.iter().map(warning).collect::<Vec<_>>());
    }

    /// What joins components.
    pub fn push_joined(&mut self, joined: &Joined) {
        let bridges = joined.bridges();
        self.push("groups", bridges.group_count());
        self.push("contacts", joined.contact_count());
        self.push("contacts_complete", bridges.is_complete());
        self.push("crack_portals", bridges.across_cracks().count());
        self.push("crack_gap", bridges.crack_width());
        let link = |link: &Link| json!({ "components": link.components, "gap": link.gap });
        self.push("links", joined.linked().iter().map(link).collect::<Vec<_>>());
    }

    /// What building found and did.
    pub fn push_build(&mut self, report: &BuildReport) {
        self.push("joined_vertices", report.welded_vertices);
        push_fields!(
            self,
            report {
                crack_vertices,
                crack_width,
                unreferenced_vertices,
                degenerate_faces,
                duplicate_faces,
                flipped_faces,
                non_manifold_edges,
                euler_characteristic,
            }
        );
    }

    /// Stages of the same name, one for each boundary condition, are added up.
    pub fn push_stages(&mut self, stages_ms: &[(Stage, f64)]) {
        let mut stages = Map::new();
        for (stage, time) in stages_ms {
            let name = stage.to_string().to_lowercase().replace(' ', "_");
            let before = stages.get(&name).and_then(Value::as_f64).unwrap_or_default();
            stages.insert(name, json!(before + time));
        }
        self.push("stages_ms", stages);
    }

    pub fn push_parts(&mut self, soup: &Soup) {
        let part = |(index, part): (usize, &heatwalk::surface::soup::Part)| json!({ "part": index, "name": part.name, "faces": part.len() });
        self.push("parts", soup.parts.iter().enumerate().map(part).collect::<Vec<_>>());
    }

    /// The animations of a file that has some.
    pub fn push_animations(&mut self, motion: &Motion) {
        let animation = |(index, clip): (usize, &Clip)| {
            let Clip { name, left_out, .. } = clip;
            json!({ "animation": index, "name": name, "seconds": clip.duration(), "left_out": left_out })
        };
        self.push("animations", motion.clips().iter().enumerate().map(animation).collect::<Vec<_>>());
    }

    pub fn render(self, json: bool) -> String {
        if json { self.json() } else { self.lines() }
    }

    fn json(self) -> String {
        format!("{}\n", object(self.values))
    }

    fn lines(self) -> String {
        let mut text = String::new();
        for (name, value) in self.values {
            let name = name.replace('_', " ");
            // Writing to a String cannot fail.
            let _ = match value {
                // That has been told on standard error.
                Value::Object(_) if name == "cloud" => Ok(()),
                Value::Object(timings) => timings.iter().try_for_each(|(stage, value)| {
                    let label = format!("{stage} (ms)");
                    writeln!(text, "{label:<22} {:.3}", value.as_f64().unwrap_or_default())
                }),
                Value::Array(items) if name == "parts" => items.iter().try_for_each(|part| {
                    let label = format!("part {}", part["part"]);
                    let name = part["name"].as_str().unwrap_or_default().replace(char::is_control, " ");
                    writeln!(text, "{label:<22} {name}, {} faces", part["faces"])
                }),
                Value::Array(items) if name == "animations" => items.iter().try_for_each(|animation| {
                    let label = format!("animation {}", animation["animation"]);
                    let name = animation["name"].as_str().unwrap_or_default().replace(char::is_control, " ");
                    write!(text, "{label:<22} {name}, {} s", animation["seconds"])?;
                    match animation["left_out"].as_u64() {
                        None | Some(0) => writeln!(text),
                        Some(left_out) => writeln!(text, ", without {left_out} of its channels"),
                    }
                }),
                Value::Array(items) if name == "links" => items.iter().enumerate().try_for_each(|(index, link)| {
                    let label = format!("link {index}");
                    let [first, second] = [0, 1].map(|of| &link["components"][of]);
                    writeln!(text, "{label:<22} components {first} and {second}, gap {}", link["gap"])
                }),
                Value::Array(items) if name == "missing" => items.iter().try_for_each(|uri| {
                    let uri = uri.as_str().unwrap_or_default().replace(char::is_control, " ");
                    writeln!(text, "{name:<22} {uri}")
                }),
                // Those have been told on standard error.
                Value::Array(_) if name == "warnings" => Ok(()),
                Value::Array(paths) if name == "paths" && paths.len() <= FEW => {
                    paths.iter().enumerate().try_for_each(|(index, path)| {
                        let (label, to) = (format!("path {index}"), path["to"].as_str().unwrap_or_default());
                        writeln!(text, "{label:<22} to {to}, distance {}, length {}", path["distance"], path["length"])
                    })
                }
                Value::Array(loops) if name == "loops" => loops.iter().enumerate().try_for_each(|(index, of_loop)| {
                    let label = format!("loop {index}");
                    writeln!(text, "{label:<22} length {}", of_loop["length"])
                }),
                Value::Array(places) if name == "snapped" && places.len() <= FEW => {
                    places.iter().enumerate().try_for_each(|(index, snapped)| {
                        let label = format!("snapped {index}");
                        let [given, place] = ["given", "place"].map(|end| snapped[end].as_str().unwrap_or_default());
                        writeln!(text, "{label:<22} {given} to {place}, {} away", snapped["distance"])
                    })
                }
                Value::Array(numbers) if numbers.len() <= FEW && numbers.iter().all(Value::is_number) => {
                    let numbers: Vec<String> = numbers.iter().map(Value::to_string).collect();
                    writeln!(text, "{name:<22} {}", numbers.join(","))
                }
                // A path of a thousand points is for files and programs.
                Value::Array(items) => writeln!(text, "{name:<22} {}", items.len()),
                Value::Null if name == "unit" => writeln!(text, "{name:<22} none"),
                Value::String(symbol) if name == "unit" => writeln!(text, "{name:<22} {symbol}"),
                // JSON has no infinity.
                Value::Null => writeln!(text, "{name:<22} inf"),
                value => writeln!(text, "{name:<22} {value}"),
            };
        }
        text
    }
}
