// Forgets all distances.

@group(0) @binding(0) var<storage, read_write> state: array<u32>;
@group(0) @binding(1) var<storage, read_write> sent_labels: array<vec4<u32>>;
@group(0) @binding(2) var<storage, read_write> distances: array<u32>;

const INFINITE = 0x7f800000u;

@compute @workgroup_size(64)
fn clear(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) workgroups: vec3<u32>) {
    let stride = 64u * workgroups.x;
    for (var number = id.x; number < arrayLength(&state); number += stride) {
        state[number] = INFINITE;
    }
    for (var number = id.x; number < arrayLength(&sent_labels); number += stride) {
        sent_labels[number] = vec4(0u);
    }
    for (var number = id.x; number < arrayLength(&distances); number += stride) {
        distances[number] = INFINITE;
    }
}
