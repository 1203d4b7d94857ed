// A pin in the surface: a steel needle and a ball, one instance a source.

// Height of a pin in CSS pixels at most: near the surface it must not hide what it marks.
const MAX_PIXELS = 76.0;
// Height in bounding radii otherwise.
const SIZE = 0.15;

const GREEN = vec3f(0.22, 0.80, 0.02);
const GREEN_SELECTED = vec3f(0.50, 1.0, 0.10);
const STEEL = vec3f(0.62, 0.63, 0.66);

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    // 0 needle, 1 ball.
    @location(2) ball: f32,
    @location(3) selected: f32,
}

// Solid space: the pin stands on +y and is one unit high. Tag x: 0 needle, 1 ball.
@vertex
fn vs_pin(
    solid: Vertex,
    @location(2) tags: vec2f,
    @location(3) foot: vec3f,
    @location(4) up: vec3f,
    @location(5) selected: f32,
) -> Fragment {
    let axes = basis(up);
    let size = min(SIZE * frame.radius, MAX_PIXELS * css_pixel(foot)) * mix(1.0, 1.22, selected);
    let position = foot + size * (axes * solid.position);
    let normal = axes * solid.normal;
    return Fragment(to_clip(position), position, normal, tags.x, selected);
}

@fragment
fn fs_pin(fragment: Fragment) -> @location(0) vec4f {
    let green = mix(GREEN, GREEN_SELECTED, fragment.selected);
    let glow = 0.08 * green * fragment.ball;
    let material = Material(mix(STEEL, green, fragment.ball), 1.0 - fragment.ball, mix(0.35, 0.22, fragment.ball), glow, 1.0);
    let normal = normalize(fragment.normal);
    return encode(shade(material, fragment.position, normal, normal));
}
