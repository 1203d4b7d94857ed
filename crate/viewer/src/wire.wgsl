// Edges of the mesh: segments of constant width in pixels, a little in front of the surface, and cut open as that is.

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

// Where a segment begins, on the way to its other end, that is not cut away as a whole.
fn kept(end: vec3f, other: vec3f) -> vec3f {
    let here = beyond_each(end);
    let there = beyond_each(other);
    // Away is what is beyond both planes: the first that is crossed brings it back.
    let crossings = select(vec2f(1.0), here / (here - there), there <= vec2f(0.0));
    let is_away = min(here.x, here.y) > 0.0;
    return select(end, mix(end, other, min(crossings.x, crossings.y)), is_away);
}

@vertex
fn vs_wire(
    @builtin(vertex_index) corner: u32,
    @location(0) start: vec3f,
    @location(1) end: vec3f,
    @location(2) color: vec3f,
    @location(3) half_width: f32,
) -> Fragment {
    if beyond(start).w > 0.0 && beyond(end).w > 0.0 {
        // All corners in one place make no triangle.
        return Fragment(vec4f(0.0, 0.0, 0.0, 1.0), color, 0.0, 0.0);
    }
    let here = select(kept(start, end), kept(end, start), corner >= 2u);
    let to_eye = normalize(frame.eye - here);
    let side = normalize(cross(end - start, to_eye));
    let half_pixels = half_width * frame.pixel_ratio;
    let across = select(-1.0, 1.0, (corner & 1u) == 1u) * (half_pixels + FEATHER);
    let pixel = css_pixel(here) / frame.pixel_ratio;
    let position = here + across * pixel * side + LIFT * frame.radius * to_eye;
    return Fragment(to_clip(position), color, across, half_pixels);
}

@fragment
fn fs_wire(fragment: Fragment) -> @location(0) vec4f {
    let share = clamp(fragment.half_width + 0.5 - abs(fragment.away), 0.0, 1.0);
    return encode(fragment.color) * share;
}
