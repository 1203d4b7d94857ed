// The surface in the materials of its file (glTF 2.0, 3.9), with the pattern of distance upon them.

// Rows of the affine map from texture coordinates to the image; w of the first: the set of coordinates.
struct TextureUse {
    along: vec4f,
    down: vec4f,
}

// Its layout is that of `MaterialUniform` in material.rs.
struct FileMaterial {
    base_color: vec4f,
    emission: vec3f,
    metalness: f32,
    roughness: f32,
    normal_scale: f32,
    occlusion_strength: f32,
    // Alpha below which nothing is drawn.
    cutoff: f32,
    unlit: f32,
    single_sided: f32,
    textures: array<TextureUse, 5>,
}

@group(3) @binding(0) var<uniform> given: FileMaterial;
@group(3) @binding(1) var base_map: texture_2d<f32>;
@group(3) @binding(2) var base_sampler: sampler;
@group(3) @binding(3) var rough_map: texture_2d<f32>;
@group(3) @binding(4) var rough_sampler: sampler;
@group(3) @binding(5) var normal_map: texture_2d<f32>;
@group(3) @binding(6) var normal_sampler: sampler;
@group(3) @binding(7) var occlusion_map: texture_2d<f32>;
@group(3) @binding(8) var occlusion_map_sampler: sampler;
@group(3) @binding(9) var emission_map: texture_2d<f32>;
@group(3) @binding(10) var emission_sampler: sampler;

// A mirror without any roughness would show the lights as points.
const LEAST_ROUGHNESS = 0.06;

// Levels coarser than a pixel: what a stripe should stand out from is larger than a texel.
const SURROUNDINGS_BIAS = 5.0;

// What the file says of a vertex.
struct ModelVertex {
    // Two sets.
    @location(4) texcoords: vec4f,
    @location(5) color: vec4f,
}

@vertex
fn vs_model(vertex: Vertex, field: FieldVertex, model: ModelVertex) -> Fragment {
    return of_model(with_field(vertex, field, vec4f(0.0)), model);
}

@vertex
fn vs_model_tinted(vertex: Vertex, field: FieldVertex, model: ModelVertex, @location(6) tint: vec4f) -> Fragment {
    return of_model(with_field(vertex, field, tint), model);
}

@vertex
fn vs_model_plain(vertex: Vertex, model: ModelVertex) -> Fragment {
    return of_model(without_field(vertex, vec4f(0.0)), model);
}

@vertex
fn vs_model_plain_tinted(vertex: Vertex, model: ModelVertex, @location(6) tint: vec4f) -> Fragment {
    return of_model(without_field(vertex, tint), model);
}

fn of_model(bare: Fragment, model: ModelVertex) -> Fragment {
    var fragment = bare;
    fragment.texcoords = model.texcoords;
    fragment.color = model.color;
    return fragment;
}

fn place_in(texture: TextureUse, texcoords: vec4f) -> vec2f {
    let uv = vec3f(select(texcoords.xy, texcoords.zw, texture.along.w > 0.5), 1.0);
    return vec2f(dot(texture.along.xyz, uv), dot(texture.down.xyz, uv));
}

// Unit tangent and bitangent of texture coordinates, from their derivatives: along u, and at right angles to it the way that
// is up in the image (glTF 2.0, 3.7.2.1).
fn tangents(position: vec3f, uv: vec2f, normal: vec3f) -> mat2x3f {
    let across = dpdx(position);
    let down = dpdy(position);
    let uv_across = dpdx(uv);
    let uv_down = dpdy(uv);
    let side = sign(uv_across.x * uv_down.y - uv_across.y * uv_down.x);
    let along_u = side * (across * uv_down.y - down * uv_across.y);
    let along_v = side * (down * uv_across.x - across * uv_down.x);
    let level = along_u - normal * dot(normal, along_u);
    let tangent = level * inverseSqrt(max(dot(level, level), 1e-30));
    let bitangent = cross(normal, tangent);
    return mat2x3f(tangent, select(bitangent, -bitangent, dot(bitangent, along_v) > 0.0));
}

// What the file says of a place.
struct Given {
    material: Material,
    alpha: f32,
    // Luminance of the base color around the place.
    luminance: f32,
    // Of the normal map, facing the eye.
    normal: vec3f,
}

fn look_up(fragment: Fragment, geometric: vec4f) -> Given {
    let tint = given.base_color * fragment.color;
    let base_place = place_in(given.textures[0], fragment.texcoords);
    let base = tint * textureSample(base_map, base_sampler, base_place);
    let around = tint * textureSampleBias(base_map, base_sampler, base_place, SURROUNDINGS_BIAS);
    let rough = textureSample(rough_map, rough_sampler, place_in(given.textures[1], fragment.texcoords));
    let normal_place = place_in(given.textures[2], fragment.texcoords);
    let bump = textureSample(normal_map, normal_sampler, normal_place).xyz * 2.0 - 1.0;
    let axes = tangents(fragment.position, normal_place, geometric.xyz);
    let occlusion = textureSample(occlusion_map, occlusion_map_sampler, place_in(given.textures[3], fragment.texcoords)).r;
    let emission = textureSample(emission_map, emission_sampler, place_in(given.textures[4], fragment.texcoords)).rgb;

    // A dent is a bump from behind.
    let slope = given.normal_scale * select(-1.0, 1.0, geometric.w > 0.5) * bump.xy;
    let bumped = normalize(geometric.xyz * max(bump.z, 0.05) + axes * slope);
    let material = Material(
        base.rgb,
        clamp(given.metalness * rough.b, 0.0, 1.0),
        clamp(given.roughness * rough.g, LEAST_ROUGHNESS, 1.0),
        given.emission * emission,
        1.0 + given.occlusion_strength * (occlusion - 1.0),
    );
    return Given(material, base.a, luminance(around.rgb), select(geometric.xyz, bumped, given.normal_scale != 0.0));
}

fn luminance(color: vec3f) -> f32 {
    return dot(color, vec3f(0.2126, 0.7152, 0.0722));
}

// The colour of stripes, another one where theirs is less than about twice as bright or dark as what they lie on.
fn standing_out(stripe: vec3f, beneath: f32) -> vec3f {
    let own = luminance(stripe);
    let apart = abs(log2((own + 0.02) / (beneath + 0.02)));
    let other = select(vec3f(0.85), vec3f(0.008), own > 0.18);
    return mix(other, stripe, max(smoothstep(0.8, 1.6, apart), 1.0 - style.contrasting));
}

// Alpha for what is blended, 1 for what is not.
fn painted(fragment: Fragment) -> vec4f {
    // Derivatives first: they need every pixel of a quad to come along.
    let geometric = normal_to_eye(fragment.position, fragment.normal);
    let brush = outline(fragment.position);
    var found = look_up(fragment, geometric);
    found.material.albedo = tinted(found.material.albedo, fragment.tint);
    found.luminance = luminance(tinted(vec3f(found.luminance), fragment.tint));
    let mark = mark(fragment.distance, fragment.tangent, found.normal);
    let turned = turning(fragment.normal) + mark.turned;
    if found.alpha < given.cutoff || (given.single_sided > 0.5 && geometric.w < 0.5) {
        discard;
    }
    let stripe = standing_out(stripe_color(fragment.distance), found.luminance);
    let cover = mark.share * style.stripe_opacity;
    let stained = found.material.albedo * mix(vec3f(1.0), stripe, cover);
    let covered = mix(found.material.albedo, stripe, cover);
    var material = Material(
        mix(covered, stained, style.multiplied),
        mix(found.material.metalness, style.stripe.metalness, cover * (1.0 - style.multiplied)),
        roughened(mix(found.material.roughness, style.stripe.roughness, cover * (1.0 - style.multiplied)), turned),
        found.material.emission * (1.0 - cover) + stripe * (style.stripe.glow * mark.share),
        found.material.openness,
    );
    var normal = mark.normal;
    if is_covered(fragment.reached, fragment.tint) {
        material = covering(fragment.clip, fragment.tint);
        normal = geometric.xyz;
    } else if given.unlit > 0.5 {
        return outlined(vec4f(encode(material.albedo).rgb, found.alpha), brush);
    }
    let color = encode(shade(material, fragment.position, normal, geometric.xyz)).rgb;
    return outlined(vec4f(color, found.alpha), brush);
}

@fragment
fn fs_model(fragment: Fragment) -> @location(0) vec4f {
    return vec4f(painted(fragment).rgb, 1.0);
}

@fragment
fn fs_model_blended(fragment: Fragment) -> @location(0) vec4f {
    let color = painted(fragment);
    let alpha = clamp(color.a, 0.0, 1.0);
    return vec4f(color.rgb * alpha, alpha);
}
