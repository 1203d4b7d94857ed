// A little figure that walks along a path.

struct Walker {
    // Columns: right, up, ahead (each the walker's height long) and foot point.
    world_from_walker: mat4x4f,
    // Swing of the legs (radians), lift of the body (heights), swing of the arms, lean of the body.
    gait: vec4f,
}

@group(1) @binding(0) var<uniform> walker: Walker;

// Tag x: what the part hangs from. The numbers are those of walker.rs.
const LEFT_LEG = 1.0;
const RIGHT_LEG = 2.0;
const LEFT_ARM = 3.0;
const RIGHT_ARM = 4.0;
const HIP_HEIGHT = 0.36;
const SHOULDER_HEIGHT = 0.60;

// Tag y: coat, skin, cap, dark.
const COLORS = array<vec3f, 4>(
    vec3f(0.72, 0.17, 0.56),
    vec3f(0.86, 0.55, 0.36),
    vec3f(0.22, 0.75, 0.03),
    vec3f(0.030, 0.028, 0.045),
);

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec3f,
}

// Turns about the x axis; a positive angle swings what hangs down forwards, to +z.
fn swing(v: vec3f, angle: f32) -> vec3f {
    let s = sin(angle);
    let c = cos(angle);
    return vec3f(v.x, c * v.y + s * v.z, c * v.z - s * v.y);
}

@vertex
fn vs_walker(@location(0) solid: vec3f, @location(1) solid_normal: vec3f, @location(2) tags: vec2f) -> Fragment {
    let part = tags.x;
    let is_leg = part == LEFT_LEG || part == RIGHT_LEG;
    let is_arm = part == LEFT_ARM || part == RIGHT_ARM;
    // The right leg swings against the left one, each arm against its leg.
    let leg_angle = select(-walker.gait.x, walker.gait.x, part == LEFT_LEG);
    let arm_angle = select(walker.gait.z, -walker.gait.z, part == LEFT_ARM);
    let angle = select(select(0.0, arm_angle, is_arm), leg_angle, is_leg);
    let joint = vec3f(0.0, select(select(0.0, SHOULDER_HEIGHT, is_arm), HIP_HEIGHT, is_leg), 0.0);
    let posed = joint + swing(solid - joint, angle);
    let posed_normal = swing(solid_normal, angle);
    // All but the legs rises with each step and leans into the walk.
    let hip = vec3f(0.0, HIP_HEIGHT, 0.0);
    let upper = hip + swing(posed - hip, walker.gait.w) + vec3f(0.0, walker.gait.y, 0.0);
    let body = select(upper, posed, is_leg);
    let body_normal = select(swing(posed_normal, walker.gait.w), posed_normal, is_leg);
    let position = (walker.world_from_walker * vec4f(body, 1.0)).xyz;
    let normal = (walker.world_from_walker * vec4f(body_normal, 0.0)).xyz;
    let clip = frame.clip_from_world * vec4f(position, 1.0);
    var colors = COLORS;
    return Fragment(clip, position, normalize(normal), colors[u32(tags.y)]);
}

@fragment
fn fs_walker(fragment: Fragment) -> @location(0) vec4f {
    return encode(shade(fragment.color, fragment.position, normalize(fragment.normal), 0.5));
}
