// A path on the surface: a ribbon that faces the camera with a constant width in pixels, shaded like a cord.

// CSS pixels from the middle to the edge.
const HALF_WIDTH = 2.6;
// Depth the ribbon is drawn in front of its place, in half widths: its edges clear a surface tilted up to 72 degrees.
const LIFT_WIDTHS = 3.0;
// The least lift, in bounding radii: covers the sag between a path's points on a curved surface.
const LIFT_RADII = 0.003;
// A sharp bend would need an endless mitre.
const MITRE_LIMIT = 0.5;

const CORD = vec3f(0.13, 0.78, 0.03);
const EDGE = vec3f(0.012, 0.085, 0.02);

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) side: vec3f,
    // −1 to 1 from edge to edge.
    @location(2) across: f32,
}

fn direction(from_point: vec3f, to_point: vec3f) -> vec3f {
    let step = to_point - from_point;
    // Exactly zero where the ends are repeated.
    return select(vec3f(0.0), step / length(step), dot(step, step) > 0.0);
}

// An instance is a segment with its neighbours; the ends of the polyline repeat their point.
@vertex
fn vs_curve(
    @builtin(vertex_index) corner: u32,
    @location(0) before: vec3f,
    @location(1) start: vec3f,
    @location(2) end: vec3f,
    @location(3) after: vec3f,
) -> Fragment {
    let at_end = corner >= 2u;
    let here = select(start, end, at_end);
    let along = direction(start, end);
    let bend = along + select(direction(before, start), direction(end, after), at_end);
    let tangent = select(along, normalize(bend), dot(bend, bend) > 0.0);
    let to_eye = normalize(frame.eye - here);
    let side = normalize(cross(tangent, to_eye));
    let across = select(-1.0, 1.0, (corner & 1u) == 1u);
    let half_width = HALF_WIDTH * css_pixel(here);
    let mitre = half_width / max(dot(tangent, along), MITRE_LIMIT);
    let position = here + across * mitre * side;
    let lift = max(LIFT_WIDTHS * half_width, LIFT_RADII * frame.radius);
    // Moving along the line of sight changes the depth and leaves the pixel.
    let lifted = position + lift * normalize(frame.eye - position);
    return Fragment(to_clip(lifted), position, side, across);
}

@fragment
fn fs_curve(fragment: Fragment) -> @location(0) vec4f {
    let to_eye = normalize(frame.eye - fragment.position);
    let across = clamp(fragment.across, -1.0, 1.0);
    let normal = normalize(across * fragment.side + sqrt(1.0 - 0.9 * across * across) * to_eye);
    let feather = fwidth(fragment.across);
    // The dark edge sets the cord off from stripes of any colour.
    let edge = smoothstep(0.66 - feather, 0.66 + feather, abs(across));
    let cord = Material(mix(CORD, EDGE, edge), 0.0, 0.45, 0.12 * mix(CORD, EDGE, edge), 1.0);
    return encode(shade(cord, fragment.position, normal, normal));
}
