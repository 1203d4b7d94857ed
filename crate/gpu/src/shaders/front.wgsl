// Windows cross the faces of a patch, and vertices send others, as by `heatwalk::propagation`.

fn corner(face: Face, k: u32) -> u32 {
    return (face.corners >> (10u * k)) & 0x3ffu;
}

// Sine of the angle at a corner.
fn sine(face: Face, k: u32) -> f32 {
    return face.area / (face.lengths[k] * face.lengths[(k + 2u) % 3u]);
}

// Offers a window to the half-edge `to`: the sooner one stays for each stretch. Every thread offers one, or none.
fn offer(own: Patch, thread: u32, is_any: bool, to: u32, offered: Window, bar: Bar) {
    let edge = to & ~LEAVING;
    let is_leaving = (to & LEAVING) != 0u;
    let first = select(2u * to, SLOTS + 2u * edge, is_leaving);
    var keys = vec2(NONE);
    var label = vec4(0u);
    if (is_any && to != NONE) {
        for (var stretch = 0u; stretch < 2u; stretch += 1u) {
            let at = middle(stretch, bar.length);
            let value = bent_at(offered, at);
            if (value < by_ends(bar, at) && is_sooner(value, atomicLoad(&values[first + stretch]))) {
                keys[stretch] = (bitcast<u32>(value) & VALUE) | thread;
            }
        }
        if (any(keys != vec2(NONE))) {
            let window = clipped(offered, bar);
            label = pack(window, bar.length);
            if (is_empty(label) || !is_wide(window)) {
                keys = vec2(NONE);
            }
        }
        for (var stretch = 0u; stretch < 2u; stretch += 1u) {
            if (keys[stretch] != NONE) {
                atomicMin(&values[first + stretch], keys[stretch]);
            }
        }
    }
    workgroupBarrier();
    for (var stretch = 0u; stretch < 2u; stretch += 1u) {
        if (keys[stretch] != NONE && atomicLoad(&values[first + stretch]) == keys[stretch]) {
            if (is_leaving) {
                let place = round.parity * round.edges + own.first_edge + edge;
                sent_labels[2u * place + stretch] = label;
                atomicOr(&is_told[edge >> 5u], 1u << (edge & 31u));
            } else {
                windows[first + stretch] = label;
                let_wait(first + stretch);
            }
        }
    }
    storageBarrier();
    workgroupBarrier();
}

// Whether a window reaches the middle of a stretch sooner than the ends of its half-edge do.
fn is_nearer(window: Window, bar: Bar, stretch: u32) -> bool {
    let at = middle(stretch, bar.length);
    return bent_at(window, at) < by_ends(bar, at);
}

// Lets the first windows of the ring cross their faces, two threads each: one for each edge that they may leave by.
fn cross_some(own: Patch, thread: u32, count: u32) {
    let number = thread >> 1u;
    let to_end = (thread & 1u) != 0u;
    let is_one = number < count;
    let slot = select(0u, ring[(ring_begin + number) % SLOTS], is_one);
    let label = windows[slot];
    // One that is kept for both stretches crosses once.
    let is_double = is_one && all(label == windows[slot ^ 1u]) && waits(slot ^ 1u);
    workgroupBarrier();
    if (is_one && !to_end) {
        atomicAnd(&is_waiting[slot >> 5u], ~(1u << (slot & 31u)));
    }
    if (thread == 0u) {
        ring_begin += count;
    }
    workgroupBarrier();
    var is_crossing = is_one && !is_empty(label);
    if (is_double) {
        if (waits(slot ^ 1u)) {
            if (!to_end) {
                windows[slot ^ 1u] = vec4(0u);
            }
        } else if ((slot & 1u) != 0u) {
            is_crossing = false;
        }
    }
    let halfedge = slot >> 1u;
    let k = halfedge % 3u;
    let face = faces[own.first_face + halfedge / 3u];
    let base = face.lengths[k];
    let corners = vec3(corner(face, k), corner(face, (k + 1u) % 3u), corner(face, (k + 2u) % 3u));
    let ends = vec3(near_to(corners.x), near_to(corners.y), near_to(corners.z));
    let window = unpack(label, base);
    // The ends may have become nearer since.
    let bar_before = Bar(base, ends.xy);
    let is_near = is_nearer(window, bar_before, slot & 1u) || (is_double && is_nearer(window, bar_before, ~slot & 1u));
    is_crossing = is_crossing && is_near;
    // Seen from the end that the thread is for.
    let side_k = select((k + 2u) % 3u, (k + 1u) % 3u, to_end);
    let angle_k = select(k, (k + 1u) % 3u, to_end);
    let side = face.lengths[side_k];
    var seen = window;
    if (to_end) {
        seen = mirrored(window, base);
    }
    let crossed = crossing(seen, face.cosines[angle_k], sine(face, angle_k), side);
    if (is_crossing && !to_end) {
        atomicMin(&near[corners.z], bitcast<u32>(crossed.at_corner));
    }
    is_crossing = is_crossing && crossed.exit.begin < crossed.exit.end;
    // As the half-edge across sees it: towards the opposite corner, or from there.
    let at_corner = min(ends.z, crossed.at_corner);
    var exit = crossed.exit;
    var bar = Bar(side, vec2(ends.x, at_corner));
    if (to_end) {
        exit = mirrored(exit, side);
        bar.ends = vec2(at_corner, ends.y);
    }
    offer(own, thread, is_crossing, face.neighbors[side_k], exit, bar);
}

// Sends distances along the edges, and windows across the faces, of the vertices that are marked.
fn send(own: Patch, thread: u32, number: u32) {
    let is_one = number < 3u * own.face_count;
    let k = select(0u, number % 3u, is_one);
    let face = faces[own.first_face + select(0u, number / 3u, is_one)];
    let vertex = sent[corner(face, k)];
    let is_sending = is_one && (vertex & SENDING) != 0u;
    let value = bitcast<f32>(vertex & ~SENDING);
    let next = (k + 1u) % 3u;
    let last = (k + 2u) % 3u;
    if (is_sending) {
        atomicMin(&near[corner(face, next)], bitcast<u32>(value + face.lengths[k]));
        atomicMin(&near[corner(face, last)], bitcast<u32>(value + face.lengths[last]));
    }
    // As the half-edge across the opposite edge sees it, which begins at the last corner.
    let length = face.lengths[next];
    let ends = vec2(near_to(corner(face, last)), near_to(corner(face, next)));
    // Whatever lies behind the edge, its ends are nearer.
    let is_useful = value + max(face.lengths[k], face.lengths[last]) < min(ends.x, ends.y) + length;
    let window = Window(value, face.lengths[last] * face.cosines[last], face.area / length, 0.0, length);
    offer(own, thread, is_sending && is_useful, face.neighbors[next], window, Bar(length, ends));
}

// Lets windows cross, and vertices send where none waits, until nothing is left to do or the round has lasted long enough.
fn propagate(own: Patch, thread: u32) {
    for (var turn = 0u; turn < PASSES; turn += 1u) {
        if (thread == 0u) {
            shared_word = atomicLoad(&ring_end) - ring_begin;
            atomicStore(&sending_count, 0u);
        }
        let waiting = workgroupUniformLoad(&shared_word);
        if (waiting > 0u) {
            cross_some(own, thread, min(waiting, THREADS / 2u));
            continue;
        }
        for (var vertex = thread; vertex < own.vertex_count; vertex += THREADS) {
            if (is_to_send(vertex)) {
                sent[vertex] = atomicLoad(&near[vertex]) | SENDING;
                atomicAdd(&sending_count, 1u);
            }
        }
        workgroupBarrier();
        if (thread == 0u) {
            shared_word = atomicLoad(&sending_count);
        }
        if (workgroupUniformLoad(&shared_word) == 0u) {
            break;
        }
        for (var first = 0u; first < 3u * FACES; first += THREADS) {
            send(own, thread, first + thread);
        }
        for (var vertex = thread; vertex < own.vertex_count; vertex += THREADS) {
            sent[vertex] &= ~SENDING;
        }
        workgroupBarrier();
    }
}
