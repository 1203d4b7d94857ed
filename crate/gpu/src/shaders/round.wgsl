// A round of propagation: every patch that is listed and near enough takes what has come to it, lets windows cross its faces in the
// memory of its workgroup, and lists those that its windows and distances reach.

@compute @workgroup_size(64)
fn advance(@builtin(workgroup_id) workgroup: vec3<u32>, @builtin(local_invocation_index) thread: u32) {
    if (workgroup.x == 0u && thread == 0u) {
        if (atomicLoad(&control[COUNT + round.now]) > 0u) {
            atomicAdd(&control[ROUNDS], 1u);
        }
        atomicStore(&control[COUNT + round.later], 0u);
        atomicStore(&control[LEAST + round.later], INFINITE);
    }
    if (thread == 0u) {
        shared_word = min(atomicLoad(&control[COUNT + round.now]), round.patches);
    }
    let count = workgroupUniformLoad(&shared_word);
    for (var place = workgroup.x; place < count; place += round.workgroups) {
        if (thread == 0u) {
            shared_word = atomicLoad(&control[list_place(round.parity) + place]);
        }
        let own = patch_of(workgroupUniformLoad(&shared_word));
        var pending = INFINITE;
        if (thread == 0u) {
            pending = atomicExchange(&control[pending_place(round.parity) + own.number], INFINITE);
            let least = bitcast<f32>(atomicLoad(&control[LEAST + round.now]));
            shared_word = select(0u, 1u, bitcast<f32>(pending) > least + AHEAD);
        }
        if (workgroupUniformLoad(&shared_word) != 0u) {
            postpone(own, thread);
            if (thread == 0u) {
                activate(own.number, pending);
            }
        } else {
            load(own, thread);
            propagate(own, thread);
            store(own, thread);
        }
        workgroupBarrier();
    }
}
