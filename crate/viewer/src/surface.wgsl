// The surface with its distance pattern, and the scenery around it.

struct Finish {
    metalness: f32,
    roughness: f32,
    glow: f32,
}

// Its layout is that of `StyleUniform` in style.rs.
struct Style {
    // Periods from no distance to the largest.
    periods: f32,
    // In periods.
    offset: f32,
    // Opacity of the stripes' own colour.
    stripe_opacity: f32,
    // 1 where the colour of the stripes is a factor on that of the file's material, 0 where it covers it.
    multiplied: f32,
    // 1 where stripes are white or black wherever they would not stand out on that material.
    contrasting: f32,
    // Half the width of lines, CSS pixels; 0 for bands.
    line_half_width: f32,
    // Of bands: share of the period covered, half the width of a flank and height, both in periods.
    width: f32,
    flank: f32,
    relief: f32,
    // Between the stripes, and on them.
    @align(16) surface: Finish,
    @align(16) stripe: Finish,
    // Center and radius of the brush; radius 0 for none.
    @align(16) brush: vec4f,
}

@group(2) @binding(0) var<uniform> style: Style;
// Two rows: colours of the surface and of the stripes.
@group(2) @binding(1) var ramps: texture_2d<f32>;
@group(2) @binding(2) var ramp_sampler: sampler;

const PLAIN = Material(vec3f(0.62, 0.61, 0.59), 0.0, 0.45, vec3f(0.0), 1.0);
const SCENERY = Material(vec3f(0.045, 0.05, 0.064), 0.0, 0.3, vec3f(0.0), 1.0);
const UNREACHABLE = vec3f(0.40, 0.41, 0.42);
// Ramp texels across.
const RAMP_SIZE = 256.0;
// CSS pixels from one hatch line to the next, and the share of each period that is dark.
const HATCH_PERIOD = 9.0;
const HATCH_WIDTH = 0.3;
// Mean square slope that a pixel can add: more would turn a mirror matt.
const MOST_ROUGHENED = 0.25;
// Thin lines between two others.
const SUBDIVISIONS = 5.0;
// The most that lines cover where they are too dense to be told apart.
const DENSEST = 0.4;
// The outline of the brush: half the width of its light line, and of that with its dark edges, CSS pixels.
const OUTLINE = vec2f(1.0, 2.2);
// Opacity of a tint from which on it is a wall.
const SOLID = 0.99;

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    // Over the largest.
    @location(2) distance: f32,
    // 1 at vertices that distance is known at, 0 at others.
    @location(3) reached: f32,
    // Direction in which distance grows, about unit length.
    @location(4) tangent: vec3f,
    // Of the ground: color and opacity, 1 for a wall.
    @location(5) tint: vec4f,
    // A place of the triangle: the position in the middle of a pixel at a contour may be far beside it.
    @location(6) @interpolate(perspective, centroid) place: vec3f,
    // What the file says of a vertex; nothing where it is not asked.
    @location(7) texcoords: vec4f,
    @location(8) color: vec4f,
}

// What the field says of a vertex. Distances are shares of the largest one; what is beyond 1, rounding apart, marks an
// unreachable vertex.
struct FieldVertex {
    @location(2) distance: f32,
    @location(3) tangent: vec4f,
}

@vertex
fn vs_plain(vertex: Vertex) -> Fragment {
    return without_field(vertex, vec4f(0.0));
}

@vertex
fn vs_plain_tinted(vertex: Vertex, @location(6) tint: vec4f) -> Fragment {
    return without_field(vertex, tint);
}

fn without_field(vertex: Vertex, tint: vec4f) -> Fragment {
    var fragment: Fragment;
    fragment.clip = to_clip(vertex.position);
    fragment.position = vertex.position;
    fragment.normal = vertex.normal;
    fragment.reached = 1.0;
    fragment.tint = tint;
    fragment.place = vertex.position;
    return fragment;
}

@vertex
fn vs_field(vertex: Vertex, field: FieldVertex) -> Fragment {
    return with_field(vertex, field, vec4f(0.0));
}

@vertex
fn vs_field_tinted(vertex: Vertex, field: FieldVertex, @location(6) tint: vec4f) -> Fragment {
    return with_field(vertex, field, tint);
}

fn with_field(vertex: Vertex, field: FieldVertex, tint: vec4f) -> Fragment {
    var fragment = without_field(vertex, tint);
    fragment.reached = select(0.0, 1.0, field.distance < 1.5);
    fragment.distance = field.distance * fragment.reached;
    fragment.tangent = field.tangent.xyz;
    return fragment;
}

@vertex
fn vs_shadow(@location(0) position: vec3f) -> @builtin(position) vec4f {
    return to_clip(position);
}

// A smooth step from 0 to 1 around zero, over a flank to either side.
fn step_up(x: f32, flank: f32) -> f32 {
    return smoothstep(-flank, flank, x);
}

// Its integral.
fn ramp_up(x: f32, flank: f32) -> f32 {
    let t = clamp((x + flank) / (2.0 * flank), 0.0, 1.0);
    return 2.0 * flank * t * t * t * (1.0 - 0.5 * t) + max(x - flank, 0.0);
}

// Integral of the square of its slope.
fn steepness(x: f32, flank: f32) -> f32 {
    let t = clamp((x + flank) / (2.0 * flank), 0.0, 1.0);
    return 18.0 / flank * t * t * t * (1.0 / 3.0 - 0.5 * t + 0.2 * t * t);
}

// Height of the bands' profile, 0 to 1: up in the middle `width` of each period of 1.
fn profile(x: f32, width: f32, flank: f32) -> f32 {
    let at = fract(x) - 0.5;
    return step_up(at + 0.5 * width, flank) - step_up(at - 0.5 * width, flank);
}

// Integral of the profile from 0 to x.
fn profile_integral(x: f32, width: f32, flank: f32) -> f32 {
    let at = fract(x) - 0.5;
    return floor(x) * width + ramp_up(at + 0.5 * width, flank) - ramp_up(at - 0.5 * width, flank);
}

// Integral of the square of the profile's slope from 0 to x.
fn profile_steepness(x: f32, width: f32, flank: f32) -> f32 {
    let at = fract(x) - 0.5;
    return floor(x) * 1.2 / flank + steepness(at + 0.5 * width, flank) + steepness(at - 0.5 * width, flank);
}

// Mean over a pixel that spans `span` periods of the profile (x) and of its slope (y), and the slope's variance (z). A box
// filter alone would still let the pattern beat against the pixels near two pixels a period, so it fades into its mean there.
fn bands(phase: f32, span: f32, width: f32, flank: f32) -> vec3f {
    // Below this the difference of two integrals loses its digits.
    let filtered = max(span, 1e-4);
    // The whole part is taken off first: far from the source the phase is large.
    let local = fract(phase);
    let low = local - 0.5 * filtered;
    let high = local + 0.5 * filtered;
    let share = (profile_integral(high, width, flank) - profile_integral(low, width, flank)) / filtered;
    // A mirror jumps where a share blends: the slope is taken over two pixels, so that no bevel falls between them.
    let before = low - 0.5 * filtered;
    let after = high + 0.5 * filtered;
    let slope = (profile(after, width, flank) - profile(before, width, flank)) / (2.0 * filtered);
    let dense = smoothstep(0.33, 0.6, span);
    let mean = slope * (1.0 - dense);
    let square = (profile_steepness(after, width, flank) - profile_steepness(before, width, flank)) / (2.0 * filtered);
    return vec3f(mix(clamp(share, 0.0, 1.0), width, dense), mean, max(square - mean * mean, 0.0));
}

// Share of a pixel that lines at whole phases cover, `half` physical pixels to either side; where they are too dense to be told
// apart, their mean, that light still shows the shape through.
fn lines(phase: f32, span: f32, half: f32) -> f32 {
    let away = abs(fract(phase + 0.5) - 0.5) / max(span, 1e-6);
    let dense = smoothstep(0.12, 0.3, span);
    return mix(clamp(half + 0.5 - away, 0.0, 1.0), min(2.0 * half * span, DENSEST), dense);
}

// Roughness as a pixel sees it: where the normal turns within a pixel by so much in the mean square, it mirrors a wider part
// of its surroundings, and would sparkle. Tokuyoshi and Kaplanyan, "Improved geometric specular antialiasing" (2019).
fn roughened(roughness: f32, turned: f32) -> f32 {
    let slope = roughness * roughness;
    return sqrt(sqrt(slope * slope + min(turned, MOST_ROUGHENED)));
}

// The inside is a little darker, so that an open mesh reads as one.
fn finish(given: Material, position: vec3f, normal: vec3f, geometric: vec4f) -> vec4f {
    var material = given;
    let tone = mix(0.62, 1.0, geometric.w);
    material.albedo *= tone;
    material.emission *= tone;
    return encode(shade(material, position, normal, geometric.xyz));
}

// What the pattern makes of a place on the surface.
struct Mark {
    // Share of the pixel that stripes or lines cover.
    share: f32,
    // Of the relief.
    normal: vec3f,
    // How much the normal turns within the pixel, in the mean square.
    turned: f32,
}

// The pattern at a distance, a share of the largest; `tangent` is where distance grows. Every pixel of a quad has to come along.
fn mark(distance: f32, tangent: vec3f, normal: vec3f) -> Mark {
    let phase = distance * style.periods - style.offset;
    let span = length(vec2f(dpdx(phase), dpdy(phase)));
    if style.line_half_width > 0.0 {
        let half = style.line_half_width * frame.pixel_ratio;
        let thin = lines(phase * SUBDIVISIONS, span * SUBDIVISIONS, 0.55 * half);
        return Mark(max(lines(phase, span, half), 0.45 * thin), normal, 0.0);
    }
    let pattern = bands(phase, span, style.width, style.flank);
    let uphill = tangent - normal * dot(normal, tangent);
    let turned = style.relief * style.relief * dot(uphill, uphill) * pattern.z;
    return Mark(pattern.x, normalize(normal - uphill * (style.relief * pattern.y)), turned);
}

// Colors of the surface and of the stripes at a distance, a share of the largest.
fn surface_color(distance: f32) -> vec3f {
    return ramp_color(distance, 0.25);
}

fn stripe_color(distance: f32) -> vec3f {
    return ramp_color(distance, 0.75);
}

fn ramp_color(distance: f32, row: f32) -> vec3f {
    let u = (clamp(distance, 0.0, 1.0) * (RAMP_SIZE - 1.0) + 0.5) / RAMP_SIZE;
    return textureSampleLevel(ramps, ramp_sampler, vec2f(u, row), 0.0).rgb;
}

// How much a normal turns within the pixel, in the mean square.
fn turning(normal: vec3f) -> f32 {
    let across = dpdx(normal);
    let down = dpdy(normal);
    return 0.5 * (dot(across, across) + dot(down, down));
}

// What no source reaches.
fn unreached(clip: vec4f) -> Material {
    let diagonal = (clip.x + clip.y) / (HATCH_PERIOD * frame.pixel_ratio);
    let hatch = bands(diagonal, 1.0 / (HATCH_PERIOD * frame.pixel_ratio), HATCH_WIDTH, 0.05);
    return Material(UNREACHABLE * (1.0 - 0.22 * hatch.x), 0.0, 0.6, vec3f(0.0), 1.0);
}

// What the ground makes of a color.
fn tinted(color: vec3f, tint: vec4f) -> vec3f {
    return mix(color, tint.rgb, tint.a);
}

fn is_wall(tint: vec4f) -> bool {
    return tint.a > SOLID;
}

// Whether something lies over the pattern: a wall, or the hatching of what no source reaches.
fn is_covered(reached: f32, tint: vec4f) -> bool {
    return is_wall(tint) || reached < 0.999;
}

// What lies over the pattern there.
fn covering(clip: vec4f, tint: vec4f) -> Material {
    if is_wall(tint) {
        return Material(tint.rgb, 0.0, 0.8, vec3f(0.0), 1.0);
    }
    var material = unreached(clip);
    material.albedo = tinted(material.albedo, tint);
    return material;
}

// Shares of a pixel that the light line of the brush's outline covers, and that with its dark edges.
fn outline(position: vec3f) -> vec2f {
    let away = distance(position, style.brush.xyz) - style.brush.w;
    let pixels = abs(away) / max(length(vec2f(dpdx(away), dpdy(away))), 1e-9) / frame.pixel_ratio;
    return select(vec2f(0.0), clamp(OUTLINE + 0.5 - pixels, vec2f(0.0), vec2f(1.0)), style.brush.w > 0.0);
}

fn outlined(color: vec4f, outline: vec2f) -> vec4f {
    return vec4f(mix(mix(color.rgb, vec3f(0.08), 0.7 * outline.y), vec3f(0.98), outline.x), color.a);
}

// What is seen of a place on the surface before light falls on it.
struct Painted {
    material: Material,
    // Of the relief, and that of the surface (w: 1 for the outside); both face the eye.
    normal: vec3f,
    geometric: vec4f,
    // Of the brush.
    outline: vec2f,
}

// Every pixel of a quad has to come along.
fn paint_field(fragment: Fragment) -> Painted {
    // Derivatives first.
    let geometric = normal_to_eye(fragment.position, fragment.normal);
    let mark = mark(fragment.distance, fragment.tangent, geometric.xyz);
    let turned = turning(fragment.normal) + mark.turned;
    let brush = outline(fragment.position);
    let between = tinted(surface_color(fragment.distance), fragment.tint);
    let stripe = stripe_color(fragment.distance);
    var material = Material(
        mix(between, stripe, mark.share * style.stripe_opacity),
        mix(style.surface.metalness, style.stripe.metalness, mark.share),
        roughened(mix(style.surface.roughness, style.stripe.roughness, mark.share), turned),
        between * (style.surface.glow * (1.0 - mark.share)) + stripe * (style.stripe.glow * mark.share),
        1.0,
    );
    var normal = mark.normal;
    if is_covered(fragment.reached, fragment.tint) {
        material = covering(fragment.clip, fragment.tint);
        normal = geometric.xyz;
    }
    return Painted(material, normal, geometric, brush);
}

fn paint_plain(fragment: Fragment) -> Painted {
    let geometric = normal_to_eye(fragment.position, fragment.normal);
    var material = PLAIN;
    material.albedo = tinted(material.albedo, fragment.tint);
    return Painted(material, geometric.xyz, geometric, outline(fragment.position));
}

fn lit(painted: Painted, position: vec3f) -> vec4f {
    return outlined(finish(painted.material, position, painted.normal, painted.geometric), painted.outline);
}

@fragment
fn fs_field(fragment: Fragment) -> @location(0) vec4f {
    return lit(paint_field(fragment), fragment.position);
}

@fragment
fn fs_plain(fragment: Fragment) -> @location(0) vec4f {
    return lit(paint_plain(fragment), fragment.position);
}

@fragment
fn fs_scenery(fragment: Fragment) -> @location(0) vec4f {
    let geometric = normal_to_eye(fragment.position, fragment.normal);
    return finish(SCENERY, fragment.position, geometric.xyz, geometric);
}
