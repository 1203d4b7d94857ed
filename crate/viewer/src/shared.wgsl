// Shared by all shaders: the frame's uniform, the lights and a few helpers. Colours are linear
// light until `encode`.

struct Light {
    // Direction to its middle, unit length.
    towards: vec3f,
    // Over its distance, as the half height.
    half_width: f32,
    // Direction along its width, unit length.
    right: vec3f,
    half_height: f32,
    // Linear colour.
    radiance: vec3f,
    // Solid angle over π.
    share: f32,
}

// The number is that of environment.rs.
const LIGHT_COUNT = 4;

// A light of a file: see `PunctualLight` in punctual.rs.
struct PunctualLight {
    // Its position and 1, or the direction to one that is far away and 0.
    place: vec4f,
    // Direction in which it shines; w: offset of its cone.
    axis: vec4f,
    // Linear colour at unit distance; w: slope of its cone.
    color: vec4f,
}

// The number is that of punctual.rs.
const MOST_PUNCTUAL = 8;

// Its layout is that of `FrameUniform` in shared.rs.
struct Frame {
    clip_from_world: mat4x4f,
    // From world space to the shadow maps: clip space seen from the key light.
    shadow_from_world: mat4x4f,
    // The camera's axis against the line of sight; world space.
    back: vec3f,
    // World size of a physical pixel at unit distance.
    pixel_slope: f32,
    // World position.
    eye: vec3f,
    // Bounding radius of the surface.
    radius: f32,
    // The cube of the occlusion grid: its least corner and its side. World space.
    occlusion_low: vec3f,
    occlusion_side: f32,
    // The part of the shadow maps that shadows of what moves can fall on; clip space.
    moving_low: vec2f,
    moving_high: vec2f,
    zenith: vec3f,
    // Physical pixels a CSS pixel.
    pixel_ratio: f32,
    horizon: vec3f,
    // World size of a texel of the shadow maps.
    shadow_texel: f32,
    nadir: vec3f,
    // The first casts the shadows.
    // How many lights of a file there are.
    punctual_count: i32,
    lights: array<Light, LIGHT_COUNT>,
    punctual: array<PunctualLight, MOST_PUNCTUAL>,
    // Planes that the surface is cut open by, unit normal and offset: what is beyond both is away.
    cut: array<vec4f, 2>,
    // 1 where a section closes the cut.
    is_capped: f32,
}

@group(0) @binding(0) var<uniform> frame: Frame;

@group(1) @binding(0) var still_shadows: texture_depth_2d;
@group(1) @binding(1) var moving_shadows: texture_depth_2d;
@group(1) @binding(2) var shadow_sampler: sampler_comparison;
// See occlusion.rs.
@group(1) @binding(3) var occlusion_grid: texture_3d<f32>;
@group(1) @binding(4) var occlusion_sampler: sampler;

// A vertex of the surface, or of a solid that stands on it.
struct Vertex {
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

// Where a place of the world is on the screen; clip space.
fn to_clip(position: vec3f) -> vec4f {
    return frame.clip_from_world * vec4f(position, 1.0);
}

// What light meets.
struct Material {
    albedo: vec3f,
    // 0 is a dielectric, 1 a metal.
    metalness: f32,
    // 0 is a mirror, 1 is matt.
    roughness: f32,
    emission: vec3f,
    // Share of the light from all around that arrives.
    openness: f32,
}

// Of places in single precision, in bounding radii: a face in a plane of the cut stays.
const ROUNDING = 1e-6;

// How far beyond each plane of the cut a place is. Not above 0 where there is no cut.
fn beyond_each(position: vec3f) -> vec2f {
    let first = dot(frame.cut[0].xyz, position) - frame.cut[0].w;
    let second = dot(frame.cut[1].xyz, position) - frame.cut[1].w;
    return vec2f(first, second) - ROUNDING * frame.radius;
}

// How far beyond the nearer plane a place is (w), above 0 for what is away, and the normal of that plane.
fn beyond(position: vec3f) -> vec4f {
    let each = beyond_each(position);
    return select(vec4f(frame.cut[1].xyz, each.y), vec4f(frame.cut[0].xyz, each.x), each.x < each.y);
}

// World size of a CSS pixel at a world position.
fn css_pixel(position: vec3f) -> f32 {
    return frame.pixel_slope * frame.pixel_ratio * dot(frame.eye - position, frame.back);
}

// Axes at right angles, the second along a unit vector. Duff et al., "Building an orthonormal basis, revisited" (2017).
fn basis(up: vec3f) -> mat3x3f {
    let turn = select(-1.0, 1.0, up.z >= 0.0);
    let a = -1.0 / (turn + up.z);
    let b = up.x * up.y * a;
    let right = vec3f(1.0 + turn * up.x * up.x * a, turn * b, -turn * up.x);
    let ahead = vec3f(b, turn + up.y * up.y * a, -up.y);
    return mat3x3f(right, up, ahead);
}

// From 0 far below zero to 1 far above: a step blurred over about a unit to either side.
fn blurred_step(x: f32) -> f32 {
    return smoothstep(0.0, 1.0, 0.5 + 0.36 * x);
}

// Share of a light that a mirror shows in a direction, where `blur` is the tangent of the angle that it is blurred over.
fn light_share(light: Light, direction: vec3f, blur: f32) -> f32 {
    let ahead = dot(direction, light.towards);
    if ahead <= 0.0 {
        return 0.0;
    }
    let up = cross(light.towards, light.right);
    let at = abs(vec2f(dot(direction, light.right), dot(direction, up))) / (blur * max(ahead, 0.05));
    let half = vec2f(light.half_width, light.half_height) / blur;
    let low = smoothstep(vec2f(0.0), vec2f(1.0), 0.5 + 0.36 * (half - at));
    let high = smoothstep(vec2f(0.0), vec2f(1.0), 0.5 - 0.36 * (half + at));
    let inside = low - high;
    return inside.x * inside.y * smoothstep(0.0, 0.3, ahead);
}

// Sky and floor in a direction, blurred likewise.
fn surroundings(direction: vec3f, blur: f32) -> vec3f {
    let height = direction.y;
    let sky = mix(frame.horizon, frame.zenith, smoothstep(0.0, 0.9, max(height, 0.0)));
    let floor = mix(frame.horizon, frame.nadir, smoothstep(-0.1, 0.5 + 0.4 * blur, -height));
    return mix(floor, sky, blurred_step(height / (0.08 + 0.7 * blur)));
}

// Share of a large light's rays that a tilted surface gets: those beyond the terminator still get some.
fn wrapped(cosine: f32) -> f32 {
    let softness = 0.2;
    let share = clamp((cosine + softness) / (1.0 + softness), 0.0, 1.0);
    return share * mix(share, 1.0, 0.75);
}

// Share of the key light that comes through to a point whose normal faces the eye.
fn key_visibility(position: vec3f, normal: vec3f) -> f32 {
    let facing = dot(normal, frame.lights[0].towards);
    // Triangles seen edge on by the light would speckle: there the light itself fades instead.
    let certain = smoothstep(0.02, 0.3, facing);
    if certain <= 0.0 {
        return 1.0;
    }
    let lifted = position + normal * (2.5 * frame.shadow_texel);
    let clip = (frame.shadow_from_world * vec4f(lifted, 1.0)).xyz;
    let place = vec2f(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y);
    // The floor reaches beyond the map: what is behind the scene is as far as nothing.
    let depth = min(clip.z, 1.0);
    let step = 1.5 / vec2f(textureDimensions(still_shadows));
    // A square turned, so that the four blend along rows and columns.
    var taps = array<vec2f, 4>(vec2f(-0.4, -1.0), vec2f(1.0, -0.4), vec2f(0.4, 1.0), vec2f(-1.0, 0.4));
    // Few points are near what moves.
    let is_near = all(clip.xy >= frame.moving_low) && all(clip.xy <= frame.moving_high);
    var lit = 0.0;
    for (var i = 0; i < 4; i++) {
        let tap = place + step * taps[i];
        var through = textureSampleCompareLevel(still_shadows, shadow_sampler, tap, depth);
        if is_near {
            through *= textureSampleCompareLevel(moving_shadows, shadow_sampler, tap, depth);
        }
        lit += through;
    }
    return mix(1.0, lit / 4.0, certain);
}

// How far from a surface the occlusion grid is asked, as a share of its side: a little less than two cells. Nearer the
// surface itself, which is a cell thick there, would be in the way.
const OCCLUSION_LIFT = 0.027;

// The mean direction (xyz) and the mean share (w) of the light that comes to a place on a surface.
fn openness(position: vec3f, normal: vec3f) -> vec4f {
    let place = (position - frame.occlusion_low) / frame.occlusion_side + OCCLUSION_LIFT * normal;
    let texel = textureSampleLevel(occlusion_grid, occlusion_sampler, place, 0.0);
    return vec4f(0.5 * texel.rgb - 0.25, texel.a);
}

// Surfaces keep a little of the light, or a place without a way out would be bright without end.
const MOST_REFLECTED = 0.98;

// Share of the light that a place gets where a share `open` comes from outside and the rest from surfaces of its own kind,
// which reflect this much of what they get themselves.
fn gathered(open: f32, reflected: vec3f) -> vec3f {
    return open / (1.0 - (1.0 - open) * min(reflected, vec3f(MOST_REFLECTED)));
}

// The Khronos PBR neutral tone mapper (2024): colours below the shoulder stay as they are, highlights pale towards white.
fn tone(light: vec3f) -> vec3f {
    let start = 0.76;
    let least = min(light.r, min(light.g, light.b));
    let offset = select(0.04, least - 6.25 * least * least, least < 0.08);
    let lowered = light - offset;
    let peak = max(lowered.r, max(lowered.g, lowered.b));
    if peak < start {
        return lowered;
    }
    let room = 1.0 - start;
    let pressed = 1.0 - room * room / (peak + room - start);
    let pale = 1.0 - 1.0 / (0.15 * (peak - pressed) + 1.0);
    return mix(lowered * (pressed / peak), vec3f(pressed), pale);
}

// Linear light to sRGB (IEC 61966-2-1), as an opaque pixel.
fn encode(light: vec3f) -> vec4f {
    let clamped = clamp(light, vec3f(0.0), vec3f(1.0));
    let curved = 1.055 * pow(clamped, vec3f(1.0 / 2.4)) - 0.055;
    return vec4f(select(curved, 12.92 * clamped, clamped <= vec3f(0.0031308)), 1.0);
}

// What one light gives to a matt surface and to a mirror.
struct Lit {
    diffuse: vec3f,
    specular: vec3f,
}

fn lit_by(light: Light, normal: vec3f, mirrored: vec3f, blur: f32) -> Lit {
    let share = light.share * wrapped(dot(normal, light.towards));
    return Lit(light.radiance * share, light.radiance * light_share(light, mirrored, blur));
}

// What the lights of the file give: Lambert, and for highlights GGX with the visibility of Karis, "Physically based shading on
// mobile" (2014).
fn lit_by_file(position: vec3f, normal: vec3f, to_eye: vec3f, roughness: f32) -> Lit {
    var lit = Lit(vec3f(0.0), vec3f(0.0));
    let slope = roughness * roughness;
    for (var i = 0; i < frame.punctual_count; i++) {
        let light = frame.punctual[i];
        let way = light.place.xyz - position * light.place.w;
        let square = max(dot(way, way), 1e-6);
        let towards = way * inverseSqrt(square);
        let cone = clamp(light.color.w * dot(-towards, light.axis.xyz) + light.axis.w, 0.0, 1.0);
        let arriving = light.color.rgb * (cone * cone * max(dot(normal, towards), 0.0) / square);
        let along = max(dot(normal, normalize(towards + to_eye)), 0.0);
        let spread = slope / max(along * along * (slope * slope - 1.0) + 1.0, 1e-4);
        lit.diffuse += arriving;
        lit.specular += arriving * (spread * spread * (0.25 * roughness + 0.25));
    }
    return lit;
}

// Light that leaves a surface towards the eye, tone mapped: diffuse under sky and lights, and their reflection blurred by
// roughness. `normal` is that of the relief upon the surface, whose own is `geometric`; both face the eye.
fn shade(material: Material, position: vec3f, normal: vec3f, geometric: vec3f) -> vec3f {
    return shade_under(material, position, normal, geometric, openness(position, geometric));
}

// The same where nothing is around the place but what casts a shadow: half of all directions are open.
fn shade_open(material: Material, position: vec3f, normal: vec3f, geometric: vec3f) -> vec3f {
    return shade_under(material, position, normal, geometric, vec4f(0.25 * geometric, 0.5));
}

// The same where light comes from around as `open` tells: see `openness`.
fn shade_under(material: Material, position: vec3f, normal: vec3f, geometric: vec3f, open: vec4f) -> vec3f {
    let to_eye = normalize(frame.eye - position);
    let facing = clamp(dot(normal, to_eye), 0.02, 1.0);
    let mirrored = reflect(-to_eye, normal);
    let blur = 0.012 + 1.1 * material.roughness * material.roughness;
    var diffuse = surroundings(normal, 1.0);
    var specular = surroundings(mirrored, blur);
    // One by one: a loop over uniforms is slow where the processor draws.
    let lit = array<Lit, LIGHT_COUNT>(
        lit_by(frame.lights[0], normal, mirrored, blur),
        lit_by(frame.lights[1], normal, mirrored, blur),
        lit_by(frame.lights[2], normal, mirrored, blur),
        lit_by(frame.lights[3], normal, mirrored, blur),
    );
    diffuse += lit[1].diffuse + lit[2].diffuse + lit[3].diffuse;
    specular += lit[1].specular + lit[2].specular + lit[3].specular;
    if frame.punctual_count > 0 {
        let of_file = lit_by_file(position, normal, to_eye, material.roughness);
        diffuse += of_file.diffuse;
        specular += of_file.specular;
    }
    let straight_on = mix(vec3f(0.04), material.albedo, material.metalness);
    let body = material.albedo * (1.0 - material.metalness);
    // What is open of the half sphere over the normal, and beside the mirrored direction.
    let above = clamp(open.w + 2.0 * dot(open.xyz, normal), 0.0, 1.0);
    let whole = 0.5 + 0.75 * max(dot(geometric, mirrored), 0.0);
    let beside = clamp((open.w + 3.0 * dot(open.xyz, mirrored)) / whole, 0.0, 1.0);
    let key = key_visibility(position, geometric);
    diffuse = diffuse * gathered(above, body) * material.openness + key * lit[0].diffuse;
    specular = specular * gathered(beside, straight_on) * material.openness + key * lit[0].specular;
    // Karis, "Physically based shading on mobile" (2014): the reflection's share of a rough surface, fitted.
    let fit = material.roughness * vec4f(-1.0, -0.0275, -0.572, 0.022) + vec4f(1.0, 0.0425, 1.04, -0.04);
    let rim = min(fit.x * fit.x, exp2(-9.28 * facing)) * fit.x + fit.y;
    let scale = vec2f(-1.04, 1.04) * rim + fit.zw;
    let reflected = straight_on * scale.x + scale.y;
    return tone(body * diffuse + reflected * specular + material.emission);
}

// The shading normal turned towards the eye. The side is read from the triangle itself: vertex normals of an open or
// badly wound mesh may point either way. w: 1 for the outside, 0 for the inside.
fn normal_to_eye(position: vec3f, normal: vec3f) -> vec4f {
    let to_eye = frame.eye - position;
    var face = cross(dpdx(position), dpdy(position));
    face = face * select(-1.0, 1.0, dot(face, to_eye) > 0.0);
    let outside = dot(normal, face) >= 0.0;
    return vec4f(normalize(select(-normal, normal, outside)), select(0.0, 1.0, outside));
}
