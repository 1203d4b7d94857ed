// The surface cut open: what is beyond both planes is not drawn.

// Pixels from the middle of one to beyond the farthest of its samples.
const SLACK = 0.75;
// Of places that are cut off by a pixel seen aslant, in pixels: at contours the slope of a surface has no bound.
const MOST_SLACK = 8.0;
// Of places in single precision, in bounding radii: a face that lies in a plane stays.
const ROUNDING = 1e-6;

// How far beyond the nearer plane a place is (w), negative for what stays, and the normal of that plane.
fn beyond(position: vec3f) -> vec4f {
    let first = dot(frame.cut[0].xyz, position) - frame.cut[0].w;
    let second = dot(frame.cut[1].xyz, position) - frame.cut[1].w;
    let nearer = select(vec4f(frame.cut[1].xyz, second), vec4f(frame.cut[0].xyz, first), first < second);
    return nearer - vec4f(vec3f(0.0), ROUNDING * frame.radius);
}

// How far beyond the nearer plane a place within the pixel may be that is at `away` in the middle.
fn slack(position: vec3f, away: f32) -> f32 {
    let pixel = css_pixel(position) / frame.pixel_ratio;
    return min(SLACK * length(vec2f(dpdx(away), dpdy(away))), MOST_SLACK * pixel);
}

// A pixel is drawn or not as a whole, while the section that closes a cut ends within it, sample by sample. So the section
// draws the edge, and the surface ends a little before it: what is between them is the rim.
fn is_away(position: vec3f) -> bool {
    let away = beyond(position).w;
    return away > -slack(position, away) * frame.is_capped;
}

@fragment
fn fs_field_cut(fragment: Fragment) -> @location(0) vec4f {
    let painted = paint_field(fragment);
    if is_away(fragment.position) {
        discard;
    }
    return lit(painted, fragment.position);
}

@fragment
fn fs_plain_cut(fragment: Fragment) -> @location(0) vec4f {
    let painted = paint_plain(fragment);
    if is_away(fragment.position) {
        discard;
    }
    return lit(painted, fragment.position);
}

struct RimPixel {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

// Depth of a pixel of the rim, 0 for another one. The rim is drawn a little beyond the plane too, and gives way to the section
// in depth, so that it fills just those samples that the section leaves. It is needed only where the section lies behind it:
// elsewhere the section shows through.
fn rim_depth(fragment: Fragment, is_outside: bool) -> f32 {
    let beyond = beyond(fragment.position);
    let slack = slack(fragment.position, beyond.w);
    let from_eye = fragment.position - frame.eye;
    let approach = dot(from_eye, beyond.xyz);
    // Of the plane, on the line of sight.
    let section = frame.clip_from_world * vec4f(fragment.position - from_eye * (beyond.w / approach), 1.0);
    let section_depth = section.z / section.w;
    let given_way = section_depth + SLACK * fwidth(section_depth);
    let is_rim = is_outside && approach < 0.0 && abs(beyond.w) <= slack;
    return select(0.0, clamp(given_way, fragment.clip.z, 1.0), is_rim);
}

@fragment
fn fs_field_rim(fragment: Fragment) -> RimPixel {
    let painted = paint_field(fragment);
    let depth = rim_depth(fragment, painted.geometric.w > 0.5);
    if depth == 0.0 {
        discard;
    }
    return RimPixel(lit(painted, fragment.position), depth);
}

@fragment
fn fs_plain_rim(fragment: Fragment) -> RimPixel {
    let painted = paint_plain(fragment);
    let depth = rim_depth(fragment, painted.geometric.w > 0.5);
    if depth == 0.0 {
        discard;
    }
    return RimPixel(lit(painted, fragment.position), depth);
}

struct CutCaster {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
}

@vertex
fn vs_shadow_cut(@location(0) position: vec3f) -> CutCaster {
    return CutCaster(frame.clip_from_world * vec4f(position, 1.0), position);
}

@fragment
fn fs_shadow_cut(caster: CutCaster) {
    if beyond(caster.position).w > 0.0 {
        discard;
    }
}
