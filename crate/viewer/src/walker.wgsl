// Little figures that walk: instances of one solid, bent at hips, knees, ankles, shoulders and elbows.

// Tag x: what the part hangs from; the right side's are RIGHT higher. The numbers are those of walker.rs.
const THIGH = 1.0;
const SHIN = 2.0;
const FOOT = 3.0;
const ARM = 4.0;
const FOREARM = 5.0;
const RIGHT = 5.0;
// As in gait.rs.
const HIP = vec3f(0.075, 0.42, 0.0);
const SHOULDER_HEIGHT = 0.655;
const ELBOW_HEIGHT = 0.525;
// Length of a thigh, and of a shin.
const BONE = 0.2;
// Bend of the elbows, lean of the body; radians.
const ELBOW_BEND = 0.45;
const LEAN = -0.05;

// Tag y: coat, skin, cap, dark.
const COLORS = array<vec3f, 4>(
    vec3f(0.72, 0.13, 0.52),
    vec3f(0.86, 0.55, 0.36),
    vec3f(0.22, 0.75, 0.03),
    vec3f(0.045, 0.042, 0.06),
);

struct Fragment {
    @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec3f,
}

struct Posed {
    position: vec3f,
    normal: vec3f,
}

// Turns about the x axis; a positive angle swings what hangs down forwards, to +z.
fn swing(v: vec3f, angle: f32) -> vec3f {
    let s = sin(angle);
    let c = cos(angle);
    return vec3f(v.x, c * v.y + s * v.z, c * v.z - s * v.y);
}

// Turns what hangs down so that it hangs along a direction.
fn hang(v: vec3f, along: vec3f) -> vec3f {
    let ahead = normalize(vec3f(0.0, along.z, -along.y));
    let across = cross(-along, ahead);
    return v.x * across - v.y * along + v.z * ahead;
}

// Parts of a leg between the hip and an ankle (w: pitch of the foot). The knee bends forwards.
fn leg(part: f32, solid: Posed, hip: vec3f, ankle: vec4f) -> Posed {
    let bone_ends = ankle.xyz - hip;
    let span = min(length(bone_ends), 1.999 * BONE);
    let along = normalize(bone_ends);
    let middle = hip + 0.5 * span * along;
    let out = sqrt(max(BONE * BONE - 0.25 * span * span, 0.0));
    let knee = middle + out * normalize(vec3f(0.0, along.z, -along.y));
    if part == THIGH {
        let bone = normalize(knee - hip);
        return Posed(hip + hang(solid.position, bone), hang(solid.normal, bone));
    }
    let end = hip + span * along;
    if part == SHIN {
        let bone = normalize(end - knee);
        return Posed(knee + hang(solid.position, bone), hang(solid.normal, bone));
    }
    return Posed(end + swing(solid.position, -ankle.w), swing(solid.normal, -ankle.w));
}

// Parts of an arm; the elbow bends forwards.
fn arm(part: f32, solid: Posed, angle: f32) -> Posed {
    var posed = solid;
    if part == FOREARM {
        let elbow = vec3f(0.0, ELBOW_HEIGHT, 0.0);
        let bend = ELBOW_BEND + 0.35 * max(angle, 0.0);
        posed = Posed(elbow + swing(solid.position - elbow, bend), swing(solid.normal, bend));
    }
    let shoulder = vec3f(0.0, SHOULDER_HEIGHT, 0.0);
    return Posed(shoulder + swing(posed.position - shoulder, angle), swing(posed.normal, angle));
}

@vertex
fn vs_walker(
    solid: Vertex,
    @location(2) tags: vec2f,
    @location(3) place: vec4f,
    @location(4) up: vec4f,
    @location(5) ahead: vec4f,
    @location(6) left: vec4f,
    @location(7) right: vec4f,
) -> Fragment {
    let is_right = tags.x > RIGHT;
    let part = select(tags.x, tags.x - RIGHT, is_right);
    let lift = vec3f(0.0, up.w, 0.0);
    var posed = Posed(solid.position, solid.normal);
    if part >= THIGH && part <= FOOT {
        let side = vec3f(select(1.0, -1.0, is_right), 1.0, 1.0);
        posed = leg(part, posed, HIP * side + lift, select(left, right, vec4<bool>(is_right)));
    } else {
        if part >= ARM {
            posed = arm(part, posed, select(ahead.w, -ahead.w, is_right));
        }
        let waist = vec3f(0.0, HIP.y, 0.0);
        posed = Posed(waist + lift + swing(posed.position - waist, LEAN), swing(posed.normal, LEAN));
    }
    let left_side = cross(up.xyz, ahead.xyz);
    let normal = posed.normal.x * left_side + posed.normal.y * up.xyz + posed.normal.z * ahead.xyz;
    let offset = posed.position.x * left_side + posed.position.y * up.xyz + posed.position.z * ahead.xyz;
    let position = place.xyz + place.w * offset;
    var colors = COLORS;
    return Fragment(to_clip(position), position, normal, colors[u32(tags.y)]);
}

@fragment
fn fs_walker(fragment: Fragment) -> @location(0) vec4f {
    let normal = normalize(fragment.normal);
    let material = Material(fragment.color, 0.0, 0.5, vec3f(0.0), 1.0);
    return encode(shade(material, fragment.position, normal, normal));
}
