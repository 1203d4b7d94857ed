// A level of a texture from the next finer one.

@group(0) @binding(0) var finer: texture_2d<f32>;
@group(0) @binding(1) var finer_sampler: sampler;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) place: vec2f,
}

// One triangle over the whole level.
@vertex
fn vs_level(@builtin(vertex_index) index: u32) -> Corner {
    let place = vec2f(f32((index << 1u) & 2u), f32(index & 2u));
    return Corner(vec4f(2.0 * place.x - 1.0, 1.0 - 2.0 * place.y, 0.0, 1.0), place);
}

@fragment
fn fs_level(corner: Corner) -> @location(0) vec4f {
    return textureSampleLevel(finer, finer_sampler, corner.place, 0.0);
}
