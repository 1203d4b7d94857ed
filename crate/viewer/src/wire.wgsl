// Edges of the mesh: segments of constant width in pixels, a little in front of the surface.

// Pixels over which an edge fades, on top of that.
const FEATHER = 1.0;
// Depth that a segment is drawn in front of its place, in bounding radii.
const LIFT = 0.0015;

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) color: vec3f,
    // Physical pixels from the middle.
    @location(1) away: f32,
    @location(2) half_width: f32,
}

@vertex
fn vs_wire(
    @builtin(vertex_index) corner: u32,
    @location(0) start: vec3f,
    @location(1) end: vec3f,
    @location(2) color: vec3f,
    @location(3) half_width: f32,
) -> Fragment {
    let here = select(start, end, corner >= 2u);
    let to_eye = normalize(frame.eye - here);
    let side = normalize(cross(end - start, to_eye));
    let half_pixels = half_width * frame.pixel_ratio;
    let across = select(-1.0, 1.0, (corner & 1u) == 1u) * (half_pixels + FEATHER);
    let pixel = css_pixel(here) / frame.pixel_ratio;
    let position = here + across * pixel * side + LIFT * frame.radius * to_eye;
    return Fragment(frame.clip_from_world * vec4f(position, 1.0), color, across, half_pixels);
}

@fragment
fn fs_wire(fragment: Fragment) -> @location(0) vec4f {
    let share = clamp(fragment.half_width + 0.5 - abs(fragment.away), 0.0, 1.0);
    return encode(fragment.color) * share;
}
