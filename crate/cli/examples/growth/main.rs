//! How time and memory grow with a surface of hostile form: on vertices of n triangles, edges of n triangles,
//! slivers, parts and boundaries that touch.
//!
//! `cargo run --release -p heatwalk-cli --example growth [-- N] [WORD ...]`
//!
//! Measures every operation on every family at N, 4 N and 16 N triangles, N being 2,000 if not given; of several words, those rows
//! whose name has each of them. A row is one operation on one family: seconds and megabytes at the largest size, and the exponents
//! with which both grew over the last factor of 4. Seconds below a hundredth and megabytes below one have none: that is the noise
//! of what does not grow.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

use anyhow::{Context, Result};
use glam::{DMat3, DVec3};
use heatwalk::{
    BridgeRule, Bridges, Distance, DistanceOptions, DistanceSolver, Element, FaceId, Method, Path, Place, Soup,
    Surface, VertexId, Walls, WeldRule, descend, edge_polyline, go_on, straighten, straightest,
};
use heatwalk_base::parallel::ONE;
use heatwalk_curves::{Field, Isolines, Levels, Sheet, Strips, write};
use heatwalk_shapes as shapes;
use peak_alloc::PeakAlloc;

#[global_allocator]
static MEMORY: PeakAlloc = PeakAlloc;

/// Isolines of a field.
const LEVELS: usize = 5;

fn main() -> Result<()> {
    let mut words: Vec<String> = std::env::args().skip(1).collect();
    let count = words.first().and_then(|word| word.parse().ok());
    if count.is_some() {
        words.remove(0);
    }
    let sizes = [1, 4, 16].map(|factor| factor * count.unwrap_or(2000));
    println!(
        "{:<34} {:>9} {:>9} {:>8} {:>8}",
        "triangles: ".to_owned() + &sizes[2].to_string(),
        "s",
        "MB",
        "time",
        "memory"
    );
    for (family, make) in FAMILIES {
        for (operation, prepare) in OPERATIONS {
            let name = format!("{operation}, {family}");
            if words.iter().all(|word| name.contains(word)) {
                let figures = sizes.map(|size| measure(&make(size), prepare)).into_iter().collect::<Result<Vec<_>>>();
                print(&name, &figures.with_context(|| name.clone())?);
            }
        }
    }
    Ok(())
}

/// What one operation took.
struct Figures {
    triangles: f64,
    seconds: f64,
    megabytes: f64,
}

fn measure(soup: &Soup, prepare: Prepare) -> Result<Figures> {
    let operation = prepare(soup)?;
    let before = MEMORY.current_usage_as_mb();
    MEMORY.reset_peak_usage();
    let start = Instant::now();
    operation()?;
    let seconds = start.elapsed().as_secs_f64();
    let megabytes = f64::from(MEMORY.peak_usage_as_mb() - before);
    Ok(Figures { triangles: soup.triangles.len() as f64, seconds, megabytes })
}

fn print(name: &str, figures: &[Figures]) {
    let [.., before, last] = figures else { return };
    let factor = (last.triangles / before.triangles).ln();
    let exponent = |[before, last]: [f64; 2], noise: f64| {
        if last < noise { "-".to_owned() } else { format!("{:.2}", (last / before.max(noise / 4.0)).ln() / factor) }
    };
    println!(
        "{name:<34} {:>9.3} {:>9.1} {:>8} {:>8}",
        last.seconds,
        last.megabytes,
        exponent([before.seconds, last.seconds], 0.01),
        exponent([before.megabytes, last.megabytes], 1.0)
    );
}

/// A form by its name, of about so many triangles.
type Family = (&'static str, fn(usize) -> Soup);

/// Soups of about so many triangles.
const FAMILIES: [Family; 15] = [
    ("terrain", |count| shapes::terrain((count as f64 / 2.0).sqrt() as u32)),
    ("ladder", ladder),
    ("hub", |count| fan(count, 0.0, 0.0)),
    ("wavy hub", |count| fan(count, 0.0, 0.2)),
    ("cone", |count| fan(count, 2.0, 0.0)),
    ("two hubs", two_hubs),
    ("needles", needles),
    ("book", |count| book(count, 0.0)),
    ("winding book", |count| book(count, 0.5)),
    ("bouquet", bouquet),
    ("star", star),
    ("ladders side by side", |count| two_ladders(count, DMat3::IDENTITY)),
    ("ladders across", |count| two_ladders(count, DMat3::from_rotation_z(FRAC_PI_2))),
    ("chain", chain),
    ("crack", crack),
];

/// A square cut across into slivers.
fn ladder(count: usize) -> Soup {
    let columns = count / 2;
    let positions = (0..=columns).flat_map(|column| {
        let x = column as f64 / columns as f64;
        [DVec3::new(x, 0.0, 0.0), DVec3::new(x, 1.0, 0.0)]
    });
    let triangles = (0..columns as u32).flat_map(|column| {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| 2 * column + k);
        [[a, c, b], [b, c, d]]
    });
    Soup::single("ladder", positions.collect(), triangles.collect())
}

/// Triangles around a vertex that is higher than their rim, which goes up and down.
fn fan(count: usize, height: f64, waves: f64) -> Soup {
    let mut positions = vec![DVec3::new(0.0, height, 0.0)];
    positions.extend(rim(count, waves));
    Soup::single("fan", positions, around(0, count))
}

/// Triangles around two vertices with one rim.
fn two_hubs(count: usize) -> Soup {
    let count = count / 2;
    let mut positions = vec![DVec3::Y];
    positions.extend(rim(count, 0.0));
    positions.push(DVec3::NEG_Y);
    let below = around(count as u32 + 1, count).into_iter().map(|[a, b, c]| [a, c, b]);
    let triangles = around(0, count).into_iter().chain(below).collect();
    Soup::single("two hubs", positions, triangles)
}

fn rim(count: usize, waves: f64) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |index| {
        let angle = TAU * index as f64 / count as f64;
        DVec3::new(angle.cos(), waves * (7.0 * angle).sin(), angle.sin())
    })
}

/// A fan around a vertex over the vertices 1 to `count`.
fn around(hub: u32, count: usize) -> Vec<[u32; 3]> {
    let count = count as u32;
    (0..count).map(|index| [hub, (index + 1) % count + 1, index + 1]).collect()
}

/// A triangle cut from one corner into needles.
fn needles(count: usize) -> Soup {
    let mut positions = vec![DVec3::ZERO];
    positions.extend((0..=count).map(|index| DVec3::new(1.0, index as f64 / count as f64, 0.0)));
    let triangles = (1..=count as u32).map(|index| [0, index, index + 1]);
    Soup::single("needles", positions, triangles.collect())
}

/// Pages on one edge, the last of them less wide than the first by this share.
fn book(count: usize, less: f64) -> Soup {
    let mut positions = vec![DVec3::ZERO, DVec3::Y];
    let width = |index: usize| 1.0 - less * index as f64 / count as f64;
    positions.extend(rim(count, 0.0).enumerate().map(|(index, point)| width(index) * point + 0.5 * DVec3::Y));
    Soup::single("book", positions, (0..count as u32).map(|index| [0, 1, index + 2]).collect())
}

/// Triangles that have one corner in common.
fn bouquet(count: usize) -> Soup {
    let outward = directions(2 * count).flat_map(|direction| [direction, 1.1 * direction.any_orthogonal_vector()]);
    let positions = std::iter::once(DVec3::ZERO).chain(outward.take(2 * count)).collect();
    let triangles = (0..count as u32).map(|index| [0, 2 * index + 1, 2 * index + 2]);
    Soup::single("bouquet", positions, triangles.collect())
}

/// Triangles that all pierce each other near one point.
fn star(count: usize) -> Soup {
    let corners = |direction: DVec3| {
        let (x, y) = direction.any_orthonormal_pair();
        [x, y - 0.5 * x, -y - 0.5 * x]
    };
    let triangles = (0..count as u32).map(|index| [0, 1, 2].map(|k| 3 * index + k));
    Soup::single("star", directions(count).flat_map(corners).collect(), triangles.collect())
}

/// Unit vectors all around, on a spiral.
fn directions(count: usize) -> impl Iterator<Item = DVec3> {
    (0..count).map(move |index| {
        let height = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
        let (y, x) = (2.4 * index as f64).sin_cos();
        let radius = (1.0 - height * height).sqrt();
        DVec3::new(radius * x, radius * y, height)
    })
}

/// Two squares of slivers, one near above the other and turned.
fn two_ladders(count: usize, turn: DMat3) -> Soup {
    let mut both = ladder(count / 2);
    let first = both.positions.len() as u32;
    let middle = DVec3::new(0.5, 0.5, 0.0);
    let above = |point: &DVec3| turn * (*point - middle) + middle + 1e-4 * DVec3::Z;
    both.positions.extend_from_within(..);
    both.positions[first as usize..].iter_mut().for_each(|point| *point = above(point));
    let above: Vec<_> = both.triangles.iter().map(|corners| corners.map(|corner| corner + first)).collect();
    both.triangles.extend(above);
    Soup::single("ladders", both.positions, both.triangles)
}

/// Triangles of which each pierces the next.
fn chain(count: usize) -> Soup {
    let corners = |index: usize| {
        let (at, angle) = (index as f64 / 2.0, index as f64);
        [DVec3::new(at, 0.0, 0.0), DVec3::new(at + 1.0, 0.0, 0.0), DVec3::new(at + 0.5, angle.cos(), angle.sin())]
    };
    let triangles = (0..count as u32).map(|index| [0, 1, 2].map(|k| 3 * index + k));
    Soup::single("chain", (0..count).flat_map(corners).collect(), triangles.collect())
}

/// Two strips of a square's width side by side, one twice as fine, whose vertices miss each other by little.
fn crack(count: usize) -> Soup {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    for (columns, from) in [(count as u32 / 6, 0.0), (count as u32 / 3, 1.0 + 1e-7)] {
        let first = positions.len() as u32;
        let width = f64::from(columns).recip();
        for column in 0..=columns {
            positions.extend([from, from + 1.0].map(|y| DVec3::new(f64::from(column) * width, y, 0.0)));
        }
        triangles.extend((0..columns).flat_map(|column| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| first + 2 * column + k);
            [[a, c, b], [b, c, d]]
        }));
    }
    Soup::single("crack", positions, triangles)
}

/// What is measured.
type Operation = Box<dyn FnOnce() -> Result<()>>;

/// Makes what an operation works on.
type Prepare = fn(&Soup) -> Result<Operation>;

const OPERATIONS: [(&str, Prepare); 18] = [
    ("build", |soup| {
        let soup = soup.clone();
        does(move || Surface::build_by(&soup, WeldRule::Exact, ONE))
    }),
    ("contacts", |soup| {
        let surface = surface(soup)?;
        does(move || anyhow::Ok(Bridges::find(&surface, BridgeRule::Automatic)))
    }),
    ("links", |soup| {
        let surface = surface(soup)?;
        does(move || anyhow::Ok(Bridges::find(&surface, BridgeRule::Off).links(&surface)))
    }),
    ("heat", |soup| {
        let mut solver = DistanceSolver::new(surface(soup)?);
        let source = Place::Vertex(VertexId(1));
        does(move || solver.distance(&[source], &DistanceOptions::by(Method::Heat), &mut go_on))
    }),
    ("walls of triangles", |soup| {
        let surface = surface(soup)?;
        let faces = (0..surface.face_count()).step_by(2).map(FaceId::from_index).collect();
        does(move || surface.walled(&Walls { faces, edges: Vec::new() }))
    }),
    ("walls of edges", |soup| {
        let surface = surface(soup)?;
        let edges = (0..surface.face_count()).step_by(2).map(|face| FaceId::from_index(face).halfedge(0)).collect();
        does(move || surface.walled(&Walls { faces: Vec::new(), edges }))
    }),
    ("sources at vertices", |soup| {
        let surface = surface(soup)?;
        let sources: Vec<Place> = surface.vertices().map(Place::Vertex).collect();
        propagates(surface, sources)
    }),
    ("sources on edges", |soup| {
        let surface = surface(soup)?;
        let faces = (0..surface.face_count()).map(FaceId::from_index);
        let on_edge = |face: FaceId| Place::Edge { halfedge: face.halfedge(0), fraction: 0.5 };
        let sources = faces.map(on_edge).collect();
        propagates(surface, sources)
    }),
    ("sources at one vertex", |soup| {
        let surface = surface(soup)?;
        let sources = vec![Place::Vertex(VertexId(0)); surface.face_count()];
        propagates(surface, sources)
    }),
    ("sources along a line", |soup| {
        let surface = surface(soup)?;
        let mut through = walk(&surface);
        through.dedup();
        does(move || edge_polyline(&surface, &through, false))
    }),
    ("descent", |soup| {
        let (surface, distance, from) = field(soup)?;
        does(move || descend(&surface, &distance, from))
    }),
    ("straightened descent", |soup| {
        let (surface, distance, from) = field(soup)?;
        let path = descend(&surface, &distance, from)?;
        does(move || straighten(&surface, &path))
    }),
    ("straightened walk", |soup| {
        let surface = surface(soup)?;
        let path = Path::along_edges(&surface, &walk(&surface))?;
        does(move || straighten(&surface, &path))
    }),
    ("straightest", |soup| {
        let surface = surface(soup)?;
        let from = Place::Face { face: FaceId(0), weights: [0.3, 0.3, 0.4] };
        let length = 3.0 * surface.bounding_radius();
        let direction =
            surface.position(surface.faces()[FaceId(0)][1]) - surface.position(surface.faces()[FaceId(0)][2]);
        does(move || straightest(&surface, from, None, direction, length))
    }),
    ("isolines", |soup| {
        let (field, levels) = curves(soup)?;
        does(move || anyhow::Ok(Isolines::trace(&field, &levels)))
    }),
    ("svg", |soup| {
        let (field, levels) = curves(soup)?;
        let isolines = Isolines::trace(&field, &levels);
        let view = write::View::from_direction(&field, DVec3::new(1.0, 2.0, 3.0), DVec3::Y).context("a view")?;
        does(move || anyhow::Ok(write::svg(&isolines, &field, &view, None)))
    }),
    ("other files", |soup| {
        let (field, levels) = curves(soup)?;
        let isolines = Isolines::trace(&field, &levels);
        does(move || {
            let files = [write::obj, write::dxf, write::csv].map(|file| file(&isolines, None));
            anyhow::Ok((files, write::glb(&isolines), write::strips_obj(&Strips::cut(&field, &levels)?, None)))
        })
    }),
    ("unrolled", |soup| {
        let (field, levels) = curves(soup)?;
        does(move || {
            let strips = Strips::cut(&field, &levels)?;
            // Those of curved surfaces are refused.
            anyhow::Ok(Sheet::unroll(&strips).ok().map(|sheet| write::sheet_dxf(&sheet, &strips, None)))
        })
    }),
];

/// Keeps what an operation gives until it was measured.
fn does<T, E: Into<anyhow::Error>>(operation: impl FnOnce() -> Result<T, E> + 'static) -> Result<Operation> {
    Ok(Box::new(move || operation().map(|made| drop(black_box(made))).map_err(Into::into)))
}

fn surface(soup: &Soup) -> Result<Arc<Surface>> {
    Ok(Arc::new(Surface::build_by(soup, WeldRule::Exact, ONE)?))
}

/// Distances from many sources.
fn propagates(surface: Arc<Surface>, sources: Vec<Place>) -> Result<Operation> {
    let mut solver = DistanceSolver::new(surface);
    solver.exact_geometry();
    does(move || solver.distance(&sources, &DistanceOptions::by(Method::Propagation), &mut go_on))
}

/// The distance to a place of the last triangle, and the vertex farthest from there.
fn field(soup: &Soup) -> Result<(Arc<Surface>, Distance, VertexId)> {
    let surface = surface(soup)?;
    let source = Place::Face { face: FaceId::from_index(surface.face_count() / 3), weights: [0.3, 0.3, 0.4] };
    let mut solver = DistanceSolver::new(Arc::clone(&surface));
    let options = DistanceOptions::by(Method::Propagation);
    let distance = solver.distance(&[source], &options, &mut go_on)?.distance;
    let reached = surface.vertices().filter(|&vertex| distance.values[vertex] < f64::INFINITY);
    let from = reached.max_by(|&a, &b| distance.values[a].total_cmp(&distance.values[b]));
    Ok((surface, distance, from.context("a vertex")?))
}

fn curves(soup: &Soup) -> Result<(Field, Levels)> {
    let (surface, distance, _) = field(soup)?;
    let triangles = surface.faces().iter().map(|face| face.map(|vertex| vertex.0)).collect();
    let field = Field::new(surface.positions().clone().into_vec(), triangles, distance.values.into_vec())?;
    let levels = Levels::counted(LEVELS, field.largest())?;
    Ok((field, levels))
}

/// Half of the vertices in their order, joined by edges where there are any, else by way of others.
fn walk(surface: &Surface) -> Vec<VertexId> {
    let mut walk: Vec<VertexId> = Vec::new();
    for face in (0..surface.face_count() / 2).map(FaceId::from_index) {
        let corners = surface.faces()[face];
        for vertex in corners {
            if walk.last().is_none_or(|&last| last != vertex && (corners.contains(&last))) {
                walk.push(vertex);
            }
        }
    }
    walk
}
