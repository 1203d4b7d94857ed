//! Balls that are cut open, with the straight distance inside of them.

use std::f32::consts::{FRAC_PI_2, PI, TAU};

use glam::{DVec3, Vec2, Vec3, Vec4};
use heatwalk_viewer::{
    Context, Error, Finish, Hierarchy, InnerTriangles, MeshAppearance, MeshArrays, Pattern, Renderer, SectionArrays,
    Style, SurfaceHit, View,
};
use libtest_mimic::Failed;

use crate::halves::columns_apart;
use crate::image::{HEIGHT, WIDTH};

use crate::scenes::{self, BANDS, SOURCE};
use crate::{picture, shown};

/// Of the shells, and how dense they are.
const RADII: [f32; 5] = [0.4, 0.7, 1.0, 1.3, 1.6];
const OPACITY: f32 = 0.3;

/// Of the ball is away what is beyond this plane.
const PLANE: Vec4 = Vec4::new(0.36, 0.48, 0.8, 0.1);

/// Distance from the source in a straight line, and the direction in which it grows.
fn straight(place: Vec3) -> (f32, Vec3) {
    let way = place - SOURCE;
    (way.length(), way.normalize_or_zero())
}

fn snorm(direction: Vec3) -> [i8; 4] {
    (127.0 * direction).extend(0.0).to_array().map(|component| component as i8)
}

/// Shows the ball with its straight distances.
fn show_ball(renderer: &mut Renderer, style: Style) -> Result<(), Error> {
    show_solid(renderer, scenes::sphere().arrays(), style)
}

fn show_solid(renderer: &mut Renderer, arrays: MeshArrays, style: Style) -> Result<(), Error> {
    let positions = arrays.positions.clone();
    scenes::show_mesh(renderer, arrays, style)?;
    renderer.set_field(positions.len(), 2.0, false, |values, directions| fill(&positions, values, directions))
}

fn fill(positions: &[Vec3], values: &mut [f32], directions: &mut [i8]) {
    for ((&place, value), direction) in positions.iter().zip(values).zip(directions.as_chunks_mut::<4>().0) {
        let (distance, grows) = straight(place);
        (*value, *direction) = (distance, snorm(grows));
    }
}

/// A flat sheet: a grid from an inner to an outer rim, whose places are given by shares around and from rim to rim.
fn sheet(normal: Vec3, columns: u32, rows: u32, at: impl Fn(f32, f32) -> Vec3) -> InnerTriangles {
    let corners = (0..=rows).flat_map(|row| (0..=columns).map(move |column| (column, row)));
    let positions: Vec<Vec3> =
        corners.map(|(column, row)| at(column as f32 / columns as f32, row as f32 / rows as f32)).collect();
    let squares = (0..rows).flat_map(|row| (0..columns).map(move |column| row * (columns + 1) + column));
    let triangles = squares.flat_map(|a| {
        let [b, c, d] = [a + 1, a + columns + 2, a + columns + 1];
        [[a, b, c], [a, c, d]]
    });
    InnerTriangles {
        normals: vec![normal; positions.len()],
        values: positions.iter().map(|&place| straight(place).0).collect(),
        triangles: triangles.collect(),
        positions,
    }
}

/// What a plane leaves of a spherical shell between two radii: a disk, or a ring.
fn disk(plane: Vec4, inner: f32, outer: f32) -> InnerTriangles {
    let (normal, offset) = (plane.truncate(), plane.w);
    let (right, up) = normal.any_orthonormal_pair();
    let rim = |radius: f32| (radius * radius - offset * offset).max(0.0).sqrt();
    sheet(normal, 96, 24, |around, along| {
        let (sin, cos) = (TAU * around).sin_cos();
        offset * normal + (rim(inner) + along * (rim(outer) - rim(inner))) * (cos * right + sin * up)
    })
}

fn section(parts: impl IntoIterator<Item = InnerTriangles>) -> SectionArrays {
    let mesh = joined(parts);
    let tangents = mesh.positions.iter().map(|&place| snorm(straight(place).1)).collect();
    SectionArrays { mesh, tangents }
}

fn joined(parts: impl IntoIterator<Item = InnerTriangles>) -> InnerTriangles {
    parts.into_iter().fold(InnerTriangles::default(), |mut all, part| {
        let first = all.positions.len() as u32;
        all.triangles.extend(part.triangles.iter().map(|corners| corners.map(|vertex| first + vertex)));
        all.positions.extend(part.positions);
        all.normals.extend(part.normals);
        all.values.extend(part.values);
        all
    })
}

/// The part of a sphere about the source that is inside of the ball.
fn shell(radius: f32) -> InnerTriangles {
    let (right, up) = SOURCE.any_orthonormal_pair();
    // Of the unit sphere about the origin are at this distance the places of a circle about the axis.
    let widest = (0.5 * radius).acos();
    let outward = |around: f32, along: f32| {
        let ((sin, cos), turn) = ((along * widest).sin_cos(), Vec2::from_angle(TAU * around));
        sin * (turn.x * right + turn.y * up) - cos * SOURCE
    };
    let mut shell = sheet(Vec3::ZERO, 96, 32, |around, along| SOURCE + radius * outward(around, along));
    shell.normals = shell.positions.iter().map(|&place| straight(place).1).collect();
    shell.values.fill(radius);
    shell
}

/// A ball cut by a plane: stripes run over the rim.
pub fn cut_open(renderer: &mut Renderer) -> Result<(), Error> {
    // The section may come before the field that its values belong to.
    show_ball(renderer, BANDS)?;
    renderer.set_cut(&[PLANE])?;
    renderer.set_section(Some(section([disk(PLANE, 0.0, 1.0)])), false)
}

/// A hollow ball: the cavity is seen through the cut.
pub fn hollow(renderer: &mut Renderer) -> Result<(), Error> {
    const CAVITY: f32 = 0.6;
    let mut arrays = scenes::sphere().arrays();
    let count = arrays.positions.len() as u32;
    let inner: Vec<Vec3> = arrays.positions.iter().map(|&place| CAVITY * place).collect();
    let inward: Vec<Vec3> = arrays.normals.iter().map(|&normal| -normal).collect();
    let turned: Vec<[u32; 3]> = arrays.triangles.iter().map(|&[a, b, c]| [count + a, count + c, count + b]).collect();
    arrays.positions.extend(inner);
    arrays.normals.extend(inward);
    arrays.triangles.extend(turned);
    let hierarchy = Hierarchy::new(&arrays.positions, &arrays.triangles);
    show_solid(renderer, MeshArrays { hierarchy, appearance: MeshAppearance::default(), ..arrays }, LINES)?;
    renderer.set_cut(&[PLANE])?;
    renderer.set_section(Some(section([disk(PLANE, CAVITY, 1.0)])), false)
}

const LINES: Style = Style { pattern: Pattern::Lines { width: 2.0 }, ..scenes::PLAIN };

/// A ball without a quarter.
pub fn wedge(renderer: &mut Renderer) -> Result<(), Error> {
    show_ball(renderer, Style { period: 0.16, ..BANDS })?;
    renderer.set_cut(&[Vec4::X, Vec4::Z])?;
    // Half disks on either plane, from the axis to the rim on the side that is away.
    let half = |normal: Vec3, side: Vec3| {
        sheet(normal, 48, 24, |around, along| {
            let (sin, cos) = (PI * around - FRAC_PI_2).sin_cos();
            along * (cos * side + sin * Vec3::Y)
        })
    };
    renderer.set_section(Some(section([half(Vec3::X, Vec3::Z), half(Vec3::Z, Vec3::X)])), false)
}

/// Shells around the source before a section.
pub fn shells(renderer: &mut Renderer) -> Result<(), Error> {
    show_ball(renderer, LINES)?;
    renderer.set_cut(&[PLANE])?;
    renderer.set_section(Some(section([disk(PLANE, 0.0, 1.0)])), false)?;
    renderer.set_shells(Some(joined(RADII.map(shell))), OPACITY)
}

/// What is inside with all distances a multiple.
fn stretched(times: f32) -> (SectionArrays, InnerTriangles) {
    let (mut section, mut shells) = (section([disk(PLANE, 0.0, 1.0)]), joined(RADII.map(shell)));
    section.mesh.values.iter_mut().chain(&mut shells.values).for_each(|value| *value *= times);
    (section, shells)
}

/// The ball without its surface: section and shells with all distances a multiple.
fn show_stretched(renderer: &mut Renderer, times: f32) -> Result<(), Error> {
    show_ball(renderer, BANDS)?;
    let (section, shells) = stretched(times);
    renderer.set_section(Some(section), true)?;
    renderer.set_shells(Some(shells), OPACITY)
}

/// Blocks, the outer ones drawn asunder, in the place of the surface.
pub fn whole_cells(renderer: &mut Renderer) -> Result<(), Error> {
    const STEPS: u32 = 4;
    const VERTICES: usize = 6 * (STEPS as usize + 1).pow(2);
    show_ball(renderer, BANDS)?;
    let steps = || (-4..4).map(|step| 0.25 * step as f32 + 0.125);
    let middles = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| Vec3::new(x, y, z))));
    let kept = middles.filter(|&middle| middle.length() < 0.95 && PLANE.truncate().dot(middle) < PLANE.w);
    let faces = [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X, Vec3::NEG_Y, Vec3::NEG_Z];
    let block = |middle: Vec3| {
        faces.map(|normal| {
            let (right, up) = normal.any_orthonormal_pair();
            sheet(normal, STEPS, STEPS, |across, along| {
                middle + 0.125 * (normal + (2.0 * across - 1.0) * right + (2.0 * along - 1.0) * up)
            })
        })
    };
    let mut asunder = section(kept.flat_map(block));
    // Values stay those of the places that the blocks come from.
    let places = asunder.mesh.positions.chunks_mut(VERTICES);
    places.for_each(|block| {
        let middle = block.iter().sum::<Vec3>() / block.len() as f32;
        block.iter_mut().for_each(|place| *place += 0.3 * middle);
    });
    renderer.set_section(Some(asunder), true)
}

/// Arrows before a section.
pub fn arrows_inside(renderer: &mut Renderer) -> Result<(), Error> {
    show_ball(renderer, LINES)?;
    renderer.set_cut(&[PLANE])?;
    renderer.set_section(Some(section([disk(PLANE, 0.0, 1.0)])), false)?;
    let steps = || (-24..=24).map(|step| step as f32 / 24.0);
    let places = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| Vec3::new(x, y, z))));
    let places: Vec<Vec3> = places.filter(|place| place.length() < 1.0).collect();
    let vectors: Vec<Vec3> = places.iter().map(|&place| straight(place).1).collect();
    renderer.set_inner_arrows(&places, &vectors)
}

fn all_inside(renderer: &mut Renderer) -> Result<(), Error> {
    arrows_inside(renderer)?;
    renderer.set_shells(Some(joined(RADII.map(shell))), OPACITY)
}

/// Looks straight at the middle of the picture along z, from in front.
fn look_along_z(renderer: &mut Renderer) {
    renderer.move_camera(|camera| {
        camera.set_view(View { yaw: 0.0, pitch: 0.0, distance: 5.0, target: DVec3::ZERO });
    });
}

fn pick(renderer: &Renderer) -> Option<SurfaceHit> {
    renderer.pick(0.5 * Vec2::new(WIDTH as f32, HEIGHT as f32))
}

/// Where the line of sight meets z, and whether on the section.
fn met(renderer: &Renderer) -> Option<(f32, bool)> {
    pick(renderer).map(|hit| ((1000.0 * hit.point.z).round() / 1000.0, hit.is_on_section))
}

/// The ray goes on through what is cut away, to the far side where nothing closes the cut; scenery and what hides the surface
/// count as before.
pub fn picks_go_through_the_cut(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |renderer| show_ball(renderer, BANDS))?;
    look_along_z(&mut renderer);
    assert_eq!(met(&renderer), Some((1.0, false)));
    renderer.set_cut(&[Vec3::Z.extend(0.2)])?;
    assert_eq!(met(&renderer), Some((-1.0, false)), "the far side from within");
    renderer.set_section(Some(section([disk(Vec3::Z.extend(0.2), 0.0, 1.0)])), false)?;
    assert_eq!(met(&renderer), Some((0.2, true)));
    let hit = pick(&renderer).expect("the section");
    assert_eq!(hit.normal, Vec3::Z);
    assert!((hit.weights.element_sum() - 1.0).abs() < 1e-6);
    // A section behind the surface is not met before it.
    renderer.set_cut(&[])?;
    assert_eq!(met(&renderer), Some((1.0, false)));
    // Beyond one of two planes alone nothing is away.
    renderer.set_cut(&[Vec3::Z.extend(0.2), Vec3::X.extend(0.1)])?;
    assert_eq!(met(&renderer), Some((1.0, false)));
    renderer.set_section(Some(section([disk(Vec3::Z.extend(0.2), 0.0, 1.0)])), true)?;
    assert_eq!(met(&renderer), Some((0.2, true)));
    renderer.set_section(None, true)?;
    assert_eq!(met(&renderer), None);
    renderer.set_scenery(vec![scenes::sphere().arrays()])?;
    renderer.set_section(Some(section([disk(Vec3::Z.extend(0.2), 0.0, 1.0)])), true)?;
    assert_eq!(met(&renderer), None, "scenery before it");
    Ok(())
}

/// Another surface, and what is taken away again, leave nothing behind.
pub fn what_was_inside_goes(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |renderer| show_ball(renderer, LINES))?;
    let whole = picture(&mut renderer)?;
    for scene in [shells, arrows_inside, whole_cells] {
        scene(&mut renderer)?;
        assert!(picture(&mut renderer)?.difference(&whole).pixels > 1000);
        show_ball(&mut renderer, LINES)?;
        assert_eq!(picture(&mut renderer)?.difference(&whole).pixels, 0);
    }
    all_inside(&mut renderer)?;
    renderer.set_cut(&[])?;
    renderer.set_section(None, false)?;
    renderer.set_shells(None, 0.3)?;
    renderer.set_inner_arrows(&[], &[])?;
    assert_eq!(picture(&mut renderer)?.difference(&whole).pixels, 0);
    Ok(())
}

/// Section and shells of another field are right of the split alone, and only while the surface has another field.
pub fn each_half_has_its_inside(device: &Context) -> Result<(), Failed> {
    let one = picture(&mut shown(device, |renderer| show_stretched(renderer, 1.0))?)?;
    let other = picture(&mut shown(device, |renderer| show_stretched(renderer, 0.5))?)?;
    assert!(one.difference(&other).pixels > 1000);
    let joined = |renderer: &mut Renderer, middle: u32| -> Result<(), Failed> {
        // With several samples a pixel, lavapipe draws one column more left of a scissor. What is solid hides that, films do not.
        let apart = columns_apart(&picture(renderer)?, &one, &other, middle);
        assert!(apart.iter().all(|&x| x + 1 == middle), "columns {apart:?} with the split at {middle}");
        Ok(())
    };
    let mut renderer = shown(device, |renderer| show_stretched(renderer, 1.0))?;
    let positions = scenes::sphere().arrays().positions;
    let (section, shells) = stretched(0.5);
    renderer.set_other_inside(Some(section), Some(shells))?;
    joined(&mut renderer, WIDTH)?;
    renderer.set_other_field(positions.len(), false, |values, directions| fill(&positions, values, directions))?;
    for (split, middle) in [(0.0, WIDTH / 2), (-0.25, WIDTH / 4), (-0.5, 0)] {
        renderer.set_split(split);
        joined(&mut renderer, middle)?;
    }
    // Colors follow the largest value of the field on the left.
    renderer.set_field(positions.len(), 1.0, false, |values, directions| fill(&positions, values, directions))?;
    let (section, shells) = stretched(0.5);
    renderer.set_other_inside(Some(section), Some(shells))?;
    renderer.set_field(positions.len(), 2.0, false, |values, directions| fill(&positions, values, directions))?;
    joined(&mut renderer, 0)?;
    let spoiled = SectionArrays { tangents: Vec::new(), ..stretched(0.5).0 };
    assert!(renderer.set_other_inside(Some(spoiled), None).is_err());
    joined(&mut renderer, 0)?;
    show_stretched(&mut renderer, 1.0)?;
    joined(&mut renderer, WIDTH)
}

/// Whichever of field and section comes first, whatever the largest value before.
pub fn a_section_follows_the_field(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, shells)?;
    let usual = picture(&mut renderer)?;
    let field = |renderer: &mut Renderer, max: f64| {
        let positions = scenes::sphere().arrays().positions;
        renderer.set_field(positions.len(), max, false, |values, directions| fill(&positions, values, directions))
    };
    field(&mut renderer, 7.0)?;
    assert!(picture(&mut renderer)?.difference(&usual).pixels > 1000, "other colours");
    renderer.set_section(Some(section([disk(PLANE, 0.0, 1.0)])), false)?;
    field(&mut renderer, 2.0)?;
    assert_eq!(picture(&mut renderer)?.difference(&usual).pixels, 0);
    Ok(())
}

pub fn refused_insides_leave_the_picture_as_it_is(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, all_inside)?;
    let before = picture(&mut renderer)?;
    let spoils: [fn(&mut SectionArrays); 7] = [
        |given| given.mesh.positions[3].y = f32::NAN,
        |given| given.mesh.normals[3].y = f32::INFINITY,
        |given| given.mesh.normals.truncate(5),
        |given| given.mesh.values.truncate(5),
        |given| given.tangents.truncate(5),
        |given| given.mesh.triangles[2][1] = given.mesh.positions.len() as u32,
        |given| given.mesh.values.clear(),
    ];
    for (index, spoil) in spoils.into_iter().enumerate() {
        let mut given = section([disk(PLANE, 0.5, 0.8)]);
        spoil(&mut given);
        assert!(renderer.set_section(Some(given.clone()), true).is_err(), "section {index}");
        // They have no tangents.
        let is_refused = renderer.set_shells(Some(given.mesh), 1.0).is_err();
        assert_eq!(is_refused, index != 4, "shells {index}");
        if !is_refused {
            renderer.set_shells(Some(joined(RADII.map(shell))), OPACITY)?;
        }
    }
    assert!(renderer.set_cut(&[Vec4::X; 3]).is_err(), "three planes");
    assert!(renderer.set_cut(&[Vec4::splat(f32::NAN)]).is_err(), "no plane");
    assert!(renderer.set_inner_arrows(&[Vec3::ZERO; 2], &[Vec3::X]).is_err(), "a place without a vector");
    assert!(renderer.set_inner_arrows(&[Vec3::NAN], &[Vec3::X]).is_err(), "no place");
    assert_eq!(picture(&mut renderer)?.difference(&before).pixels, 0);
    Ok(())
}

/// What is cut away casts no shadow on what is left, and the section takes its place.
pub fn what_is_cut_away_casts_no_shadow(device: &Context) -> Result<(), Failed> {
    let matt = Style { surface: Finish { metalness: 0.0, roughness: 1.0, glow: 0.0 }, ..scenes::PLAIN };
    // A lid between the light and a section.
    let lit = |planes: &[Vec4]| -> Result<u8, Failed> {
        let mut renderer = shown(device, |_| Ok(()))?;
        show_ball(&mut renderer, matt)?;
        renderer.move_camera(|camera| camera.set_view(View { pitch: 1.4, ..camera.view() }));
        renderer.set_cut(planes)?;
        let floor = disk(Vec3::Y.extend(0.0), 0.0, 0.9);
        renderer.set_section(Some(section([floor])), planes.is_empty())?;
        Ok(picture(&mut renderer)?.pixel(WIDTH / 2, HEIGHT / 2)[0])
    };
    let (open, alone) = (lit(&[Vec3::Y.extend(0.0)])?, lit(&[])?);
    assert!(open.abs_diff(alone) <= 2, "{open} with the lid cut away, {alone} without the ball");
    Ok(())
}

/// Whole segments, and parts of those that cross a plane: the same as if they had been cut before.
pub fn edges_are_cut_as_the_surface_is(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |renderer| show_ball(renderer, LINES))?;
    let red = Vec3::new(0.9, 0.1, 0.1);
    let mut drawn = |planes: &[Vec4], edges: &[[Vec3; 2]]| {
        renderer.set_cut(planes)?;
        renderer.set_section(None, true)?;
        renderer.clear_edges();
        renderer.add_edges(edges, red, 3.0)?;
        picture(&mut renderer)
    };
    let across = |y: f32| [Vec3::new(-1.0, y, 0.0), Vec3::new(1.0, y, 0.0)];
    let from = |start: f32, y: f32, end: f32| [Vec3::new(start, y, 0.0), Vec3::new(end, y, 0.0)];
    let nothing = drawn(&[], &[])?;
    let half = drawn(&[Vec3::X.extend(0.25)], &[across(0.5), across(-0.5), from(0.5, 0.0, 0.9)])?;
    assert!(half.difference(&nothing).pixels > 100);
    let cut_before = [from(-1.0, 0.5, 0.25), from(-1.0, -0.5, 0.25)];
    assert_eq!(half.difference(&drawn(&[], &cut_before)?).pixels, 0);
    let wedge = drawn(&[Vec3::X.extend(0.25), Vec3::Y.extend(0.0)], &[across(0.5), across(-0.5)])?;
    assert_eq!(wedge.difference(&drawn(&[], &[from(-1.0, 0.5, 0.25), across(-0.5)])?).pixels, 0);
    Ok(())
}

/// Neither where it is cut away nor where it is hidden.
pub fn arrows_of_the_surface_go_with_it(device: &Context) -> Result<(), Failed> {
    let mut renderer = shown(device, |renderer| show_ball(renderer, LINES))?;
    let vectors = vec![Vec3::Y; scenes::sphere().arrays().triangles.len()];
    for (planes, is_hidden) in [(&[Vec3::Y.extend(-2.0)][..], false), (&[], true)] {
        renderer.set_cut(planes)?;
        renderer.set_section(None, is_hidden)?;
        renderer.set_arrows(&[])?;
        let nothing = picture(&mut renderer)?;
        renderer.set_arrows(&vectors)?;
        assert_eq!(picture(&mut renderer)?.difference(&nothing).pixels, 0);
        renderer.set_cut(&[])?;
        renderer.set_section(None, false)?;
        assert!(picture(&mut renderer)?.difference(&nothing).pixels > 1000);
    }
    Ok(())
}
