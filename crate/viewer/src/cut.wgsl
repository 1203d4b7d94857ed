// The surface cut open: what is beyond both planes is not drawn.

// Pixels from the middle of one to beyond the farthest of its samples.
const SLACK = 0.75;
// Length of a pixel on a surface seen aslant, over its width, at most: at contours there is no bound.
const MOST_SLANT = 8.0;
// Keeps a division by nothing from happening where a pixel spans nothing.
const SMALLEST = 1e-30;

// How much farther beyond the plane one end of a pixel is than the other.
fn span(position: vec3f) -> f32 {
    let away = beyond(position).w;
    let pixel = css_pixel(position) / frame.pixel_ratio;
    return min(length(vec2f(dpdx(away), dpdy(away))), MOST_SLANT * pixel);
}

// Whether a fragment is away, or in a pixel that the plane may run through: those are the rim.
fn is_away(fragment: Fragment) -> bool {
    return beyond(fragment.place).w > -SLACK * span(fragment.position);
}

@fragment
fn fs_field_cut(fragment: Fragment) -> @location(0) vec4f {
    return kept(paint_field(fragment), fragment);
}

@fragment
fn fs_plain_cut(fragment: Fragment) -> @location(0) vec4f {
    return kept(paint_plain(fragment), fragment);
}

fn kept(painted: Painted, fragment: Fragment) -> vec4f {
    if is_away(fragment) {
        discard;
    }
    return lit(painted, fragment.position);
}

struct RimPixel {
    @location(0) color: vec4f,
    @builtin(frag_depth) depth: f32,
}

// A pixel of the rim.
struct Rim {
    // Share of it that the surface covers.
    share: f32,
    depth: f32,
}

// A pixel is drawn or not as a whole, while the section that closes the cut ends within it, sample by sample. Where it lies
// behind the surface, the rim is drawn a little beyond the plane and gives way to the section in depth, so that it fills just
// those samples that the section leaves. Elsewhere it fades over the pixel, over the section where there is one; what is seen
// from inside has no rim there.
fn rim(fragment: Fragment, is_outside: bool) -> Rim {
    let beyond = beyond(fragment.place);
    let span = span(fragment.position);
    let from_eye = fragment.place - frame.eye;
    let approach = dot(from_eye, beyond.xyz);
    // Of the plane, on the line of sight.
    let section = frame.clip_from_world * vec4f(fragment.place - from_eye * (beyond.w / approach), 1.0);
    let section_depth = section.z / section.w;
    let given_way = clamp(section_depth + SLACK * fwidth(section_depth), fragment.clip.z, 1.0);
    let over = max(fragment.clip.z - SLACK * fwidth(fragment.clip.z), 0.0);
    let is_capped = frame.is_capped > 0.5;
    let is_before_section = is_capped && is_outside && approach < 0.0;
    let fading = clamp(0.5 - beyond.w / max(span, SMALLEST), 0.0, 1.0) * select(1.0, 0.0, is_capped && !is_outside);
    let share = select(fading, 1.0, is_before_section);
    let is_rim = abs(beyond.w) <= SLACK * span;
    return Rim(select(0.0, share, is_rim), select(over, given_way, is_before_section));
}

@fragment
fn fs_field_rim(fragment: Fragment) -> RimPixel {
    return rim_pixel(paint_field(fragment), fragment);
}

@fragment
fn fs_plain_rim(fragment: Fragment) -> RimPixel {
    return rim_pixel(paint_plain(fragment), fragment);
}

fn rim_pixel(painted: Painted, fragment: Fragment) -> RimPixel {
    let rim = rim(fragment, painted.geometric.w > 0.5);
    if rim.share == 0.0 {
        discard;
    }
    return RimPixel(rim.share * lit(painted, fragment.position), rim.depth);
}

struct CutCaster {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
}

@vertex
fn vs_shadow_cut(@location(0) position: vec3f) -> CutCaster {
    return CutCaster(to_clip(position), position);
}

@fragment
fn fs_shadow_cut(caster: CutCaster) {
    if beyond(caster.position).w > 0.0 {
        discard;
    }
}
