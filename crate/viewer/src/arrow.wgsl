// Darts on the surface or within the solid that show a vector field, one instance each.

const AMBER = vec3f(1.0, 0.42, 0.10);
const INK = vec3f(0.01, 0.01, 0.015);
// Where it turns from ink to amber, by the cosine between its normal and the direction to the eye.
const RIM = vec2f(0.55, 0.8);

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
}

// An instance.
struct Arrow {
    @location(3) middle: vec3f,
    @location(4) vector: vec3f,
}

// Solid space: the dart points along +y, is one unit long, its middle at the origin.
fn dart(solid: Vertex, arrow: Arrow, scale: f32) -> Fragment {
    let size = length(arrow.vector);
    let axes = basis(arrow.vector / size);
    let position = arrow.middle + scale * size * (axes * solid.position);
    return Fragment(to_clip(position), position, axes * solid.normal);
}

// Where the surface is cut away, its darts shrink to nothing.
@vertex
fn vs_arrow(solid: Vertex, arrow: Arrow) -> Fragment {
    return dart(solid, arrow, select(1.0, 0.0, beyond(arrow.middle).w > 0.0));
}

@vertex
fn vs_inner_arrow(solid: Vertex, arrow: Arrow) -> Fragment {
    return dart(solid, arrow, 1.0);
}

// Amber within a rim of ink, so that it is seen on any color.
fn inked(position: vec3f, normal: vec3f) -> Material {
    let facing = dot(normal, normalize(frame.eye - position));
    let color = mix(INK, AMBER, smoothstep(RIM.x, RIM.y, facing));
    return Material(color, 0.0, 0.45, 0.15 * color, 1.0);
}

@fragment
fn fs_arrow(fragment: Fragment) -> @location(0) vec4f {
    let normal = normalize(fragment.normal);
    return encode(shade(inked(fragment.position, normal), fragment.position, normal, normal));
}

// Within the solid: what is seen of it lies open.
@fragment
fn fs_inner_arrow(fragment: Fragment) -> @location(0) vec4f {
    let normal = normalize(fragment.normal);
    return encode(shade_open(inked(fragment.position, normal), fragment.position, normal, normal));
}
