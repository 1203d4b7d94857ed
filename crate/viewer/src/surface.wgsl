// The surface with its distance stripes, and the scenery around it.

struct Look {
    // Linear stripe colour; w: share of the period it covers.
    stripe: vec4f,
    // 1 / period, 1 / max, unused.
    scale: vec4f,
}

@group(1) @binding(0) var<uniform> look: Look;
@group(1) @binding(1) var ramp: texture_2d<f32>;
@group(1) @binding(2) var ramp_sampler: sampler;

const PLAIN = vec3f(0.46, 0.455, 0.44);
const UNREACHABLE = vec3f(0.40, 0.41, 0.42);
const SCENERY = vec3f(0.030, 0.033, 0.042);
// Ramp texels across.
const RAMP_SIZE = 256.0;
// Hatch lines on a bounding radius, and the share of each period that is dark.
const HATCH_FREQUENCY = 22.0;
const HATCH_WIDTH = 0.3;

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) distance: f32,
    // 1 at vertices that heat reaches, 0 at others.
    @location(3) reached: f32,
}

@vertex
fn vs_plain(@location(0) position: vec3f, @location(1) normal: vec3f) -> Fragment {
    return Fragment(frame.clip_from_world * vec4f(position, 1.0), position, normal, 0.0, 1.0);
}

// A negative distance marks an unreachable vertex.
@vertex
fn vs_field(@location(0) position: vec3f, @location(1) normal: vec3f, @location(2) distance: f32) -> Fragment {
    let clip = frame.clip_from_world * vec4f(position, 1.0);
    return Fragment(clip, position, normal, max(distance, 0.0), select(0.0, 1.0, distance >= 0.0));
}

// Integral from 0 to x of a stripe pattern of period 1, painted in the middle `width` of each period.
fn painted(x: f32, width: f32) -> f32 {
    let shifted = x - 0.5 * (1.0 - width);
    return floor(shifted) * width + min(fract(shifted), width);
}

// Share of a pixel that stripes cover, where one pixel spans `span` periods: the box-filtered pattern, which a box
// filter alone would still let beat against the pixels near two pixels a period.
fn coverage(phase: f32, span: f32, width: f32) -> f32 {
    // Below this the difference of two integrals loses its digits.
    let filtered = max(span, 1e-4);
    // The whole part is taken off first: far from the source the phase is large.
    let local = fract(phase);
    let share = (painted(local + 0.5 * filtered, width) - painted(local - 0.5 * filtered, width)) / filtered;
    return mix(clamp(share, 0.0, 1.0), width, smoothstep(0.33, 0.6, span));
}

// The walker's soft shadow at its feet.
fn shadow(position: vec3f) -> f32 {
    if frame.shadow.w <= 0.0 {
        return 1.0;
    }
    let near = 1.0 - smoothstep(0.0, frame.shadow.w, distance(position, frame.shadow.xyz));
    return 1.0 - 0.6 * near;
}

fn finish(albedo: vec3f, position: vec3f, oriented: vec4f, gloss: f32) -> vec4f {
    // The inside is a little darker, so that an open mesh reads as one.
    let tone = mix(0.62, 1.0, oriented.w) * shadow(position);
    return encode(shade(albedo * tone, position, oriented.xyz, gloss * tone));
}

@fragment
fn fs_field(fragment: Fragment) -> @location(0) vec4f {
    // Derivatives first: they need every pixel of a quad to come along.
    let oriented = normal_to_eye(fragment.position, fragment.normal);
    let phase = fragment.distance * look.scale.x;
    let span = length(vec2f(dpdx(phase), dpdy(phase)));
    let diagonal = dot(fragment.position, vec3f(1.0, 1.0, 1.0)) * HATCH_FREQUENCY / frame.eye.w;
    let diagonal_span = length(vec2f(dpdx(diagonal), dpdy(diagonal)));

    let along = clamp(fragment.distance * look.scale.y, 0.0, 1.0);
    let u = (along * (RAMP_SIZE - 1.0) + 0.5) / RAMP_SIZE;
    let base = textureSampleLevel(ramp, ramp_sampler, vec2f(u, 0.5), 0.0).rgb;
    let striped = mix(base, look.stripe.rgb, coverage(phase, span, look.stripe.w));
    let hatched = UNREACHABLE * (1.0 - 0.22 * coverage(diagonal, diagonal_span, HATCH_WIDTH));
    let albedo = select(hatched, striped, fragment.reached > 0.999);
    return finish(albedo, fragment.position, oriented, 0.85);
}

@fragment
fn fs_plain(fragment: Fragment) -> @location(0) vec4f {
    return finish(PLAIN, fragment.position, normal_to_eye(fragment.position, fragment.normal), 0.8);
}

@fragment
fn fs_scenery(fragment: Fragment) -> @location(0) vec4f {
    return finish(SCENERY, fragment.position, normal_to_eye(fragment.position, fragment.normal), 0.75);
}
