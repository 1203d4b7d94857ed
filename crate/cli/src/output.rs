//! Output files. Their format and place are checked before the work begins.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use anyhow::{Context, Result, bail, ensure};
use glam::DVec3;
use heatwalk::Up;
use heatwalk_index::Bounds;
use heatwalk_model::Model;
use heatwalk_model::io::write;
use heatwalk_model::io::write::overlay::Overlay;
use heatwalk_volume::TetSoup;
use heatwalk_volume::io::write as volume;

use crate::destination::{STANDARD, check, is_standard, print, replace};
use crate::place::Pair;

/// Columns of distances by their names, each a value an input vertex.
pub type Columns = Vec<(String, Vec<f64>)>;

#[derive(Clone, Copy)]
pub enum DistanceFormat {
    Csv,
    Overlay(Overlay),
    Ply,
    Glb,
}

/// Formats of which some have several columns.
trait Columned {
    fn has_columns(&self) -> bool;
}

impl Columned for DistanceFormat {
    fn has_columns(&self) -> bool {
        match self {
            Self::Csv => true,
            Self::Overlay(overlay) => overlay.has_columns(),
            Self::Ply | Self::Glb => false,
        }
    }
}

impl Columned for VolumeFormat {
    fn has_columns(&self) -> bool {
        matches!(self, Self::Csv)
    }
}

#[derive(Clone, Copy)]
pub enum VolumeFormat {
    Csv,
    Vtu,
    Msh,
}

#[derive(Clone, Copy)]
pub enum PathFormat {
    Obj,
    Csv,
}

/// Places, one a row.
#[derive(Clone, Copy)]
pub struct PlacesCsv;

/// Pairs of places with their distances.
#[derive(Clone, Copy)]
pub struct PairsCsv;

/// An index of distances.
#[derive(Clone, Copy)]
pub struct IndexFormat;

#[derive(Debug, Clone, Copy)]
pub enum MatrixFormat {
    Csv,
    Npy,
    Npz,
}

/// Numbers of each vertex.
#[derive(Clone, Copy)]
pub struct VerticesCsv;

#[derive(Clone, Copy)]
pub enum FillFormat {
    Msh,
    Vtu,
}

#[derive(Clone, Copy)]
pub enum CurveFormat {
    Obj,
    Dxf,
    Svg,
    Csv,
    Glb,
    StripsObj,
    Pdf,
    Unrolled(SheetFormat),
}

#[derive(Clone, Copy)]
pub enum SheetFormat {
    Svg,
    Dxf,
    Pdf,
}

/// Of `--each`, in columns.
const OF_EACH: &str = "the distances of --each";

/// A file that can be written, and how.
pub struct Output<F> {
    path: PathBuf,
    pub format: F,
}

impl Output<DistanceFormat> {
    /// `several`: columns of distances.
    pub fn distance(path: &Path, several: bool) -> Result<Self> {
        let formats = [("csv", DistanceFormat::Csv), ("ply", DistanceFormat::Ply), ("glb", DistanceFormat::Glb)];
        let overlays = Overlay::ALL.map(|overlay| (overlay.ending(), DistanceFormat::Overlay(overlay)));
        Self::of_distances(path, "distances", &[&formats[..], &overlays].concat(), several)
    }

    /// `columns`: named distances, one value an input vertex; a single column unless it was made for several.
    pub fn write(&self, model: &Model, up: Up, columns: &[(String, Vec<f64>)]) -> Result<()> {
        let (_, first) = &columns[0];
        let turned = || {
            let mut turned = model.clone();
            turned.soup.positions.iter_mut().for_each(|position| *position = up.turned(*position));
            let normals = &mut Arc::make_mut(&mut turned.appearance).normals;
            normals.iter_mut().for_each(|normal| *normal = up.turned(normal.as_dvec3()).as_vec3());
            turned
        };
        self.save(&match self.format {
            DistanceFormat::Csv => write::distance_csv(&named(columns)),
            DistanceFormat::Overlay(overlay) => overlay.bytes(&named(columns), model.soup.triangles.len()),
            DistanceFormat::Ply => write::distance_ply(&turned().soup, first),
            DistanceFormat::Glb => write::distance_glb(&turned(), first),
        })
    }
}

impl Output<VolumeFormat> {
    /// As [`Output::distance`].
    pub fn volume(path: &Path, several: bool) -> Result<Self> {
        let formats = [("csv", VolumeFormat::Csv), ("vtu", VolumeFormat::Vtu), ("msh", VolumeFormat::Msh)];
        Self::of_distances(path, "distances inside of tetrahedra", &formats, several)
    }

    /// As [`Output::write`].
    pub fn write_volume(&self, soup: &TetSoup, columns: &[(String, Vec<f64>)]) -> Result<()> {
        let (_, first) = &columns[0];
        self.save(&match self.format {
            VolumeFormat::Csv => write::distance_csv(&named(columns)),
            VolumeFormat::Vtu => volume::vtu(soup, Some(first)),
            VolumeFormat::Msh => volume::msh(soup, Some(first)),
        })
    }
}

impl Output<PathFormat> {
    pub fn path(path: &Path) -> Result<Self> {
        Self::by_extension(path, "paths", &[("obj", PathFormat::Obj), ("csv", PathFormat::Csv)])
    }

    /// The polyline through these points.
    pub fn write(&self, points: impl Iterator<Item = DVec3>, up: Up) -> Result<()> {
        let points: Vec<_> = points.map(|point| up.turned(point)).collect();
        self.save(&match self.format {
            PathFormat::Obj => write::polylines_obj(&[points]),
            PathFormat::Csv => {
                let mut text = String::from("x,y,z\n");
                for point in &points {
                    // Writing to a String cannot fail.
                    let _ = writeln!(text, "{:.16e},{:.16e},{:.16e}", point.x, point.y, point.z);
                }
                text.into_bytes()
            }
        })
    }

    /// Any number of polylines; in a table each row has the number of its one, in a column called `what` one is.
    pub fn write_several(&self, lines: &[Vec<DVec3>], what: &str, up: Up) -> Result<()> {
        if let [only] = lines {
            return self.write(only.iter().copied(), up);
        }
        let turned = |line: &Vec<DVec3>| line.iter().map(|&point| up.turned(point)).collect::<Vec<_>>();
        let lines: Vec<Vec<DVec3>> = lines.iter().map(turned).collect();
        self.save(&match self.format {
            PathFormat::Obj => write::polylines_obj(&lines),
            PathFormat::Csv => {
                let mut text = format!("{what},x,y,z\n");
                for (number, line) in lines.iter().enumerate() {
                    for point in line {
                        let _ = writeln!(text, "{number},{:.16e},{:.16e},{:.16e}", point.x, point.y, point.z);
                    }
                }
                text.into_bytes()
            }
        })
    }
}

impl Output<PlacesCsv> {
    pub fn places(path: &Path) -> Result<Self> {
        Self::by_extension(path, "places", &[("csv", PlacesCsv)])
    }

    /// Each by how it is written, and its position.
    pub fn write(&self, places: impl Iterator<Item = (String, DVec3)>, up: Up) -> Result<()> {
        let mut text = String::from("place,x,y,z\n");
        for (place, position) in places {
            let DVec3 { x, y, z } = up.turned(position);
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{place},{x:.16e},{y:.16e},{z:.16e}");
        }
        self.save(text.as_bytes())
    }
}

impl Output<PairsCsv> {
    pub fn pairs(path: &Path) -> Result<Self> {
        Self::by_extension(path, "distances of pairs", &[("csv", PairsCsv)])
    }

    pub fn write(&self, pairs: &[Pair], distances: &[f64]) -> Result<()> {
        let mut text = String::from("from,to,distance\n");
        for (Pair([from, to]), distance) in pairs.iter().zip(distances) {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{},{},{distance:.16e}", from.in_table(), to.in_table());
        }
        self.save(text.as_bytes())
    }

    /// The same with what each distance is no less than.
    pub fn write_bounds(&self, pairs: &[Pair], bounds: &[Bounds]) -> Result<()> {
        let mut text = String::from("from,to,distance,at_least\n");
        for (Pair([from, to]), Bounds { lower, upper }) in pairs.iter().zip(bounds) {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{},{},{upper:.16e},{lower:.16e}", from.in_table(), to.in_table());
        }
        self.save(text.as_bytes())
    }
}

impl Output<IndexFormat> {
    pub fn index(path: &Path) -> Result<Self> {
        Self::by_extension(path, "indices", &[("hwindex", IndexFormat)])
    }
}

impl Output<MatrixFormat> {
    pub fn matrix(path: &Path) -> Result<Self> {
        let formats = [("csv", MatrixFormat::Csv), ("npy", MatrixFormat::Npy), ("npz", MatrixFormat::Npz)];
        let output = Self::by_extension(path, "matrices", &formats)?;
        let is_stream = is_standard(path) && matches!(output.format, MatrixFormat::Npz);
        ensure!(!is_stream, "an .npz file is put together at the end, not written as it comes; give it a name");
        Ok(output)
    }
}

impl Output<VerticesCsv> {
    /// `what`: what they are called.
    pub fn of_vertices(path: &Path, what: &str) -> Result<Self> {
        Self::by_extension(path, what, &[("csv", VerticesCsv)])
    }

    /// The number of a cell, NaN for none, and the distance of each input vertex.
    pub fn write_cells(&self, cells: &[f64], distances: &[f64]) -> Result<()> {
        let mut text = String::from("vertex,source,distance\n");
        for (vertex, (cell, distance)) in cells.iter().zip(distances).enumerate() {
            let cell = if cell.is_nan() { String::new() } else { cell.to_string() };
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{vertex},{cell},{distance:.16e}");
        }
        self.save(text.as_bytes())
    }

    /// Named numbers, one value an input vertex.
    pub fn write(&self, columns: &[(&str, Vec<f64>)]) -> Result<()> {
        self.save(&write::distance_csv(
            &columns.iter().map(|(name, values)| (*name, values.as_slice())).collect::<Vec<_>>(),
        ))
    }
}

impl Output<CurveFormat> {
    /// Of borders between cells.
    pub fn borders(path: &Path) -> Result<Self> {
        let formats = [
            ("obj", CurveFormat::Obj),
            ("dxf", CurveFormat::Dxf),
            ("svg", CurveFormat::Svg),
            ("csv", CurveFormat::Csv),
        ];
        Self::by_extension(path, "borders", &formats)
    }

    /// Of isolines, of the `strips` between them, or of those `unrolled`.
    pub fn curves(path: &Path, strips: bool, unrolled: bool) -> Result<Self> {
        let (what, formats): (_, &[_]) = match (strips, unrolled) {
            (true, _) => ("strips", &[("obj", CurveFormat::StripsObj)]),
            (_, true) => (
                "unrolled strips",
                &[
                    ("svg", CurveFormat::Unrolled(SheetFormat::Svg)),
                    ("dxf", CurveFormat::Unrolled(SheetFormat::Dxf)),
                    ("pdf", CurveFormat::Unrolled(SheetFormat::Pdf)),
                ],
            ),
            _ => (
                "isolines",
                &[
                    ("obj", CurveFormat::Obj),
                    ("dxf", CurveFormat::Dxf),
                    ("svg", CurveFormat::Svg),
                    ("pdf", CurveFormat::Pdf),
                    ("csv", CurveFormat::Csv),
                    ("glb", CurveFormat::Glb),
                ],
            ),
        };
        Self::by_extension(path, what, formats)
    }
}

impl Output<FillFormat> {
    pub fn fill(path: &Path) -> Result<Self> {
        Self::by_extension(path, "tetrahedra", &[("msh", FillFormat::Msh), ("vtu", FillFormat::Vtu)])
    }

    pub fn write_filled(&self, soup: &TetSoup) -> Result<()> {
        self.save(&match self.format {
            FillFormat::Msh => volume::msh(soup, None),
            FillFormat::Vtu => volume::vtu(soup, None),
        })
    }
}

impl<F: Copy> Output<F> {
    /// In the format, of these, that the extension of the file names.
    fn by_extension(path: &Path, what: &str, formats: &[(&str, F)]) -> Result<Self> {
        if path == Path::new(STANDARD) {
            let (_, format) = *formats.iter().find(|(known, _)| *known == "csv").unwrap_or(&formats[0]);
            return Ok(Self { path: path.to_owned(), format });
        }
        let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let ends_in = |known: &str| {
            let stem = name.strip_suffix(known).and_then(|name| name.strip_suffix('.'));
            stem.is_some_and(|stem| !stem.is_empty())
        };
        let Some(&(_, format)) = formats.iter().find(|&&(known, _)| ends_in(known)) else {
            let mut known = formats.iter().map(|(known, _)| format!(".{known}")).collect::<Vec<_>>();
            let last = known.pop().unwrap_or_default();
            let others = if known.is_empty() { String::new() } else { format!("{} or ", known.join(", ")) };
            bail!("{}: {what} are written as {others}{last}", path.display());
        };
        if is_standard(path) {
            return Ok(Self { path: path.to_owned(), format });
        }
        check(path).with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self { path: path.to_owned(), format })
    }

    /// The same of distances, of which some formats have `several` columns.
    fn of_distances(path: &Path, what: &str, formats: &[(&str, F)], several: bool) -> Result<Self>
    where
        F: Columned,
    {
        if !several {
            return Self::by_extension(path, what, formats);
        }
        let formats: Vec<_> = formats.iter().copied().filter(|(_, format)| format.has_columns()).collect();
        Self::by_extension(path, OF_EACH, &formats)
    }

    pub fn save(&self, bytes: &[u8]) -> Result<()> {
        if is_standard(&self.path) {
            return print(bytes).map(drop);
        }
        replace(&self.path, bytes).with_context(|| format!("cannot write {}", self.path.display()))
    }
}

fn named(columns: &[(String, Vec<f64>)]) -> Vec<(&str, &[f64])> {
    columns.iter().map(|(name, values)| (name.as_str(), values.as_slice())).collect()
}
