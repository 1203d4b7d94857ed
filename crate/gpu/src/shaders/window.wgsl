// Windows: the part of a half-edge that sees one (pseudo-)source along straight lines, unfolded into the plane. The half-edge lies
// on the x axis from the origin, its face above, the source at (x, -depth). Lengths are in mean edges.

struct Window {
    // Distance of the source itself.
    offset: f32,
    x: f32,
    depth: f32,
    // The interval that it sees.
    begin: f32,
    end: f32,
}

// What a window must beat on a half-edge: distances of its ends.
struct Bar {
    length: f32,
    ends: vec2<f32>,
}

// Windows seen under a smaller angle, radians, are dropped: of the size of rounding.
const THIN: f32 = 1e-7;

// What rounding may add to a distance, as a share of it and in mean edges, before a window is cut for it: many begin or end at a ray
// through a vertex, and are as near there as the vertex.
const ROUNDING: vec2<f32> = vec2(1e-6, 1e-5);

// Shares of a half-edge that an interval is kept in.
const SHARES: f32 = 65535.0;

// Where a share is so near to the next one by rounding it is that one.
const SHARE_ROUNDING: f32 = 0.01;

fn pack(window: Window, length: f32) -> vec4<u32> {
    // Rounded inward, so that no path is seen that is not there.
    let shares = vec2(window.begin, window.end) * (SHARES / length);
    let begin = u32(clamp(ceil(shares.x - SHARE_ROUNDING), 0.0, SHARES));
    let end = u32(clamp(floor(shares.y + SHARE_ROUNDING), 0.0, SHARES));
    let interval = select(0u, begin | (end << 16u), begin < end);
    return vec4(bitcast<vec3<u32>>(vec3(window.offset, window.x, window.depth)), interval);
}

fn unpack(label: vec4<u32>, length: f32) -> Window {
    let numbers = bitcast<vec3<f32>>(label.xyz);
    let share = length / SHARES;
    return Window(numbers.x, numbers.y, numbers.z, f32(label.w & 0xffffu) * share, f32(label.w >> 16u) * share);
}

fn is_empty(label: vec4<u32>) -> bool {
    return label.w == 0u;
}

// Distance of a position of the half-edge, bent at the window's end where that is before.
fn bent_at(window: Window, position: f32) -> f32 {
    let at = clamp(position, window.begin, window.end);
    return window.offset + length(vec2(at - window.x, window.depth)) + abs(position - at);
}

// Distance of a position by the nearer end.
fn by_ends(bar: Bar, position: f32) -> f32 {
    return min(bar.ends.x + position, bar.ends.y + (bar.length - position));
}

fn is_wide(window: Window) -> bool {
    let aside = max(max(window.begin - window.x, window.x - window.end), 0.0);
    return (window.end - window.begin) * window.depth > THIN * (aside * aside + window.depth * window.depth);
}

// Where on the x axis the distance from (x, -depth) equals the distance from the origin plus `limit`.
fn tie(x: f32, depth: f32, limit: f32) -> f32 {
    let below = x + limit;
    if (below <= 0.0) {
        return 0.0;
    }
    return 0.5 * (x * x + depth * depth - limit * limit) / below;
}

// Cuts off what is farther than by way of the half-edge's ends (Xin and Wang, theorem 3.2, for every ray). Empty where nothing is left.
fn clipped(window: Window, bar: Bar) -> Window {
    var cut = window;
    let at_begin = window.offset + length(vec2(window.begin - window.x, window.depth));
    let at_end = window.offset + length(vec2(window.end - window.x, window.depth));
    let slack = ROUNDING.x * max(at_begin, at_end) + ROUNDING.y;
    if (at_begin > bar.ends.x + window.begin + slack) {
        if (at_end > bar.ends.x + window.end + slack) {
            cut.end = cut.begin;
            return cut;
        }
        cut.begin = clamp(tie(window.x, window.depth, bar.ends.x - window.offset), window.begin, window.end);
    }
    if (at_end > bar.ends.y + (bar.length - window.end) + slack) {
        if (at_begin > bar.ends.y + (bar.length - window.begin) + slack) {
            cut.end = cut.begin;
            return cut;
        }
        let end = bar.length - tie(bar.length - window.x, window.depth, bar.ends.y - window.offset);
        cut.end = clamp(end, cut.begin, window.end);
    }
    return cut;
}

// The same window on the half-edge in the opposite direction.
fn mirrored(window: Window, length: f32) -> Window {
    return Window(window.offset, length - window.x, window.depth, length - window.end, length - window.begin);
}

// What a window becomes behind a face.
struct Crossing {
    // Distance of the opposite corner, bent at the window's end where its ray misses the window.
    at_corner: f32,
    // What leaves by the edge at the half-edge's begin, seen from there; empty where nothing does.
    exit: Window,
}

// Lets a window cross a face whose opposite corner is seen at an angle of this cosine and sine at the half-edge's begin, `side` from it.
fn crossing(window: Window, cosine: f32, sine: f32, side: f32) -> Crossing {
    let corner = vec2(side * cosine, side * sine);
    let aside = corner.x - window.x;
    let height = corner.y + window.depth;
    let at = clamp(window.x + aside * window.depth / height, window.begin, window.end);
    var result: Crossing;
    result.at_corner = window.offset + length(vec2(at - window.x, window.depth)) + distance(corner, vec2(at, 0.0));
    let interval = vec2(window.begin, window.end);
    // How far right of the ray to the corner the interval begins and ends.
    let from_ray = (interval - window.x) * height - aside * window.depth;
    let towards = cosine * window.depth - sine * (interval - window.x);
    let met = select(vec2(side), min(vec2(side), interval * window.depth / towards), towards > vec2(0.0));
    result.exit.offset = window.offset;
    result.exit.x = window.x * cosine - window.depth * sine;
    result.exit.depth = window.x * sine + window.depth * cosine;
    result.exit.begin = met.x;
    result.exit.end = select(side, met.y, from_ray.y < 0.0);
    if (from_ray.x >= 0.0 || result.exit.depth <= 0.0) {
        result.exit.end = result.exit.begin;
    }
    return result;
}
