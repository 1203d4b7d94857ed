// A soft vertical gradient behind everything.

struct Background {
    // sRGB colours of the upper and the lower edge.
    top: vec3f,
    bottom: vec3f,
}

@group(2) @binding(0) var<uniform> background: Background;

struct Corner {
    @builtin(position) clip: vec4f,
    @location(0) height: f32,
}

@vertex
fn vs_background(@builtin(vertex_index) index: u32) -> Corner {
    // One triangle that covers the canvas.
    let corner = vec2f(f32(index & 1u), f32(index >> 1u)) * 4.0 - 1.0;
    return Corner(vec4f(corner, 1.0, 1.0), 0.5 + 0.5 * corner.y);
}

// Jimenez, "Next generation post processing in Call of Duty: Advanced Warfare" (2014): interleaved gradient noise.
fn noise(pixel: vec2f) -> f32 {
    return fract(52.9829189 * fract(dot(pixel, vec2f(0.06711056, 0.00583715)))) - 0.5;
}

@fragment
fn fs_background(corner: Corner) -> @location(0) vec4f {
    // Mixed as sRGB, which is close to how the eye spaces greys.
    let mixed = mix(background.bottom, background.top, smoothstep(0.0, 1.0, corner.height));
    // A gradient over a whole window shows bands of single byte values unless dithered.
    return vec4f(mixed + noise(corner.clip.xy) / 255.0, 1.0);
}
