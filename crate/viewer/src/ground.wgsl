// The floor: nothing but the shadow on it, so that any background goes with it.

struct Ground {
    // Its middle and half a side; world space.
    center: vec3f,
    reach: f32,
    // The key light's share of the light on it.
    key_share: f32,
    // How far from the middle of the shadow maps shadows can be; clip space.
    shadow_reach: f32,
}

@group(2) @binding(0) var<uniform> ground: Ground;
@group(2) @binding(1) var contact: texture_2d<f32>;
@group(2) @binding(2) var contact_sampler: sampler;

// Share of the sky that what stands on the floor hides right beside it.
const CONTACT_DEPTH = 0.75;

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    // −1 to 1 over the floor.
    @location(1) place: vec2f,
}

@vertex
fn vs_ground(@builtin(vertex_index) corner: u32) -> Fragment {
    let place = vec2f(f32(corner & 1u), f32(corner >> 1u)) * 2.0 - 1.0;
    let position = ground.center + ground.reach * vec3f(place.x, 0.0, place.y);
    return Fragment(to_clip(position), position, place);
}

@fragment
fn fs_ground(fragment: Fragment) -> @location(0) vec4f {
    let up = vec3f(0.0, 1.0, 0.0);
    let fade = 1.0 - smoothstep(0.55, 1.0, length(fragment.place));
    if fade <= 0.0 {
        return vec4f(0.0);
    }
    let dark = textureSampleLevel(contact, contact_sampler, 0.5 + 0.5 * fragment.place, 0.0).r;
    let place = (frame.shadow_from_world * vec4f(fragment.position, 1.0)).xy;
    var visible = 1.0;
    if length(place) < ground.shadow_reach {
        visible = key_visibility(fragment.position, up);
    }
    if visible == 1.0 && dark == 0.0 {
        return vec4f(0.0);
    }
    // What the floor gets of the light that it would get with nothing on it.
    let key = ground.key_share;
    let left = key * visible + (1.0 - key) * (1.0 - CONTACT_DEPTH * dark);
    // The canvas blends sRGB bytes: what is left of the light there is about this power of what is left of it in truth.
    let shadow = fade * (1.0 - pow(clamp(left, 0.0, 1.0), 1.0 / 2.2));
    return vec4f(0.0, 0.0, 0.0, shadow);
}
