// Darts on the surface or within the solid that show a vector field, one instance each.

const AMBER = vec3f(1.0, 0.42, 0.10);

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

const DART = Material(AMBER, 0.0, 0.45, 0.15 * AMBER, 1.0);

@fragment
fn fs_arrow(fragment: Fragment) -> @location(0) vec4f {
    let normal = normalize(fragment.normal);
    return encode(shade(DART, fragment.position, normal, normal));
}

// Within the solid: what is seen of it lies open.
@fragment
fn fs_inner_arrow(fragment: Fragment) -> @location(0) vec4f {
    let normal = normalize(fragment.normal);
    return encode(shade_open(DART, fragment.position, normal, normal));
}
