// Shared by all shaders: the frame's uniform, the lights and a few helpers. Colours are linear
// light until `encode`.

struct Frame {
    clip_from_world: mat4x4f,
    // The camera's axes in world space; w unused.
    right: vec4f,
    up: vec4f,
    back: vec4f,
    // World position of the eye; w: bounding radius of the surface.
    eye: vec4f,
    // Width and height in physical pixels, physical pixels a CSS pixel, world size of a pixel at unit distance.
    screen: vec4f,
    // The walker's foot point; w: reach of its shadow, 0 without a walker.
    shadow: vec4f,
}

@group(0) @binding(0) var<uniform> frame: Frame;

const SKY = vec3f(0.66, 0.69, 0.74);
const GROUND = vec3f(0.13, 0.125, 0.135);
const KEY = vec3f(1.02, 0.98, 0.92);
// Where the key light stands, along the camera's axes: it turns with the camera, so that every view reads well.
const KEY_RIGHT = -0.46;
const KEY_UP = 0.70;
const KEY_BACK = 0.55;

fn key_direction() -> vec3f {
    return normalize(KEY_RIGHT * frame.right.xyz + KEY_UP * frame.up.xyz + KEY_BACK * frame.back.xyz);
}

// World size of a CSS pixel at a world position.
fn css_pixel(position: vec3f) -> f32 {
    return frame.screen.w * frame.screen.z * dot(frame.eye.xyz - position, frame.back.xyz);
}

// Light that comes from a direction in an imagined studio: bright above, dark below, a soft horizon.
fn studio(direction: vec3f) -> vec3f {
    return mix(GROUND, SKY, smoothstep(-0.35, 0.65, direction.y));
}

// Keeps highlights from clipping hard: the identity up to the knee, then a smooth approach to 1.
fn shoulder(light: vec3f) -> vec3f {
    let knee = 0.72;
    let excess = max(light - knee, vec3f(0.0)) / (1.0 - knee);
    return min(light, vec3f(knee)) + (1.0 - knee) * (1.0 - exp(-excess));
}

// Linear light to sRGB (IEC 61966-2-1), as an opaque pixel.
fn encode(light: vec3f) -> vec4f {
    let clamped = clamp(light, vec3f(0.0), vec3f(1.0));
    let curved = 1.055 * pow(clamped, vec3f(1.0 / 2.4)) - 0.055;
    return vec4f(select(curved, 12.92 * clamped, clamped <= vec3f(0.0031308)), 1.0);
}

// Lambert under sky and key light, a tight and a broad highlight, and a Fresnel rim that mirrors the studio.
// `normal` faces the eye; `gloss` 0 is matt, 1 is glazed.
fn shade(albedo: vec3f, position: vec3f, normal: vec3f, gloss: f32) -> vec3f {
    let to_eye = normalize(frame.eye.xyz - position);
    let key = key_direction();
    let facing = clamp(dot(normal, to_eye), 0.0, 1.0);
    let sky_share = 0.5 + 0.5 * normal.y;
    // Wrapped a little past the terminator, which softens the edge of the shadow side.
    let lit = clamp((dot(normal, key) + 0.12) / 1.12, 0.0, 1.0);
    let diffuse = 0.50 * mix(GROUND, SKY, sky_share) + 0.74 * KEY * lit + 0.06 * facing;
    let halfway = max(dot(normal, normalize(key + to_eye)), 0.0);
    let highlight = 0.42 * pow(halfway, 90.0) + 0.07 * pow(halfway, 14.0);
    let fresnel = 0.035 + 0.5 * pow(1.0 - facing, 4.0);
    let mirrored = studio(reflect(-to_eye, normal));
    return shoulder(albedo * diffuse + gloss * (highlight * KEY + fresnel * mirrored));
}

// The shading normal turned towards the eye. The side is read from the triangle itself: vertex normals of an open or
// badly wound mesh may point either way. w: 1 for the outside, 0 for the inside.
fn normal_to_eye(position: vec3f, normal: vec3f) -> vec4f {
    let to_eye = frame.eye.xyz - position;
    var face = cross(dpdx(position), dpdy(position));
    face = face * select(-1.0, 1.0, dot(face, to_eye) > 0.0);
    let outside = dot(normal, face) >= 0.0;
    return vec4f(normalize(select(-normal, normal, outside)), select(0.0, 1.0, outside));
}
