// Writes distances in the order and unit of the caller.

@group(0) @binding(0) var<storage, read> distances: array<f32>;
@group(0) @binding(1) var<storage, read> order: array<u32>;
@group(0) @binding(2) var<storage, read_write> output: array<f32>;
@group(0) @binding(3) var<uniform> unit: vec4<f32>;

@compute @workgroup_size(64)
fn gather(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) workgroups: vec3<u32>) {
    for (var number = id.x; number < arrayLength(&output); number += 64u * workgroups.x) {
        output[number] = distances[order[number]] * unit.x;
    }
}
