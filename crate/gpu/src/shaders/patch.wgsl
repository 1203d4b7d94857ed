// A patch in the memory of a workgroup: how it comes there, and what is written back.
//
// The constants FACES, EDGES and VERTICES are the most that a patch has, PASSES how often it lets windows cross in a round; they are
// written before this text.

struct Face {
    // Of the sides from each corner to the next.
    lengths: vec3<f32>,
    // Twice the area.
    area: f32,
    // Of the angles at the corners.
    cosines: vec3<f32>,
    // The vertices of the corners in the patch, ten bits each.
    corners: u32,
    // The half-edges glued to the sides: in the patch, or LEAVING + edge of the patch, or NONE.
    neighbors: vec3<u32>,
}

struct Round {
    // Places of the numbers of this round, of the next and of the one after it.
    now: u32,
    next: u32,
    later: u32,
    // 0 and 1 in turn.
    parity: u32,
    workgroups: u32,
    patches: u32,
    edges: u32,
}

@group(0) @binding(0) var<uniform> round: Round;
@group(0) @binding(1) var<storage, read> faces: array<Face>;
@group(0) @binding(2) var<storage, read> tables: array<u32>;
// Of each patch: the values of its slots, two a half-edge; those sent by its edges to other patches; distances sent from vertices.
@group(0) @binding(3) var<storage, read_write> state: array<u32>;
// Windows of slots, those that wait.
@group(0) @binding(4) var<storage, read_write> labels: array<vec4<u32>>;
// Windows that leave patches, two an edge, in two parities: patches read what was written in the round before.
@group(0) @binding(5) var<storage, read_write> sent_labels: array<vec4<u32>>;
@group(0) @binding(6) var<storage, read_write> distances: array<atomic<u32>>;
// Counts of lists, least pending distances, rounds with work; then two lists and the pending distances of patches, by parity.
@group(0) @binding(7) var<storage, read_write> control: array<atomic<u32>>;

const COUNT = 0u;
const LEAST = 3u;
const ROUNDS = 6u;
const LISTS = 8u;

const THREADS = 64u;
const LEAVING = 0x80000000u;
const NONE = 0xffffffffu;
const INFINITE = 0x7f800000u;

// Two stretches of each half-edge.
const SLOTS = 6u * FACES;
const WORDS = (SLOTS + 31u) / 32u;
const TOLD_WORDS = (EDGES + 31u) / 32u;

// In the state of a slot: its window waits to cross.
const WAITING = 0x80000000u;
// The bits of a value that are not the number of the thread that offered it.
const VALUE = 0xffffffc0u;

// What an improvement must be at least, in mean edges and as a share of the value.
const MARGIN: vec2<f32> = vec2(1e-4, 1e-6);

// Patches whose pending distance is so much more than the least, in mean edges, wait for another round: what they sent would be
// replaced by what comes from nearer ones.
const AHEAD: f32 = 30.0;

struct Patch {
    number: u32,
    first_face: u32,
    face_count: u32,
    first_edge: u32,
    edge_count: u32,
    vertex_count: u32,
    // Where its edges and vertices are in the tables, and its numbers in the state.
    edges: u32,
    vertices: u32,
    state: u32,
}

var<workgroup> values: array<atomic<u32>, SLOTS + 2u * EDGES>;
var<workgroup> windows: array<vec4<u32>, SLOTS>;
// Slots whose windows wait, each once.
var<workgroup> ring: array<u32, SLOTS>;
var<workgroup> ring_begin: u32;
var<workgroup> ring_end: atomic<u32>;
var<workgroup> is_waiting: array<atomic<u32>, WORDS>;
// Distances of vertices, those from which windows were sent, with SENDING while they are, and edges by which some left.
var<workgroup> near: array<atomic<u32>, VERTICES>;
var<workgroup> sent: array<u32, VERTICES>;
var<workgroup> is_told: array<atomic<u32>, TOLD_WORDS>;
var<workgroup> least_left: atomic<u32>;
var<workgroup> sending_count: atomic<u32>;
// What one thread tells all.
var<workgroup> shared_word: u32;

const SENDING = 0x80000000u;

fn margin(value: f32) -> f32 {
    return MARGIN.x + MARGIN.y * value;
}

fn is_sooner(value: f32, known: u32) -> bool {
    return value + margin(value) < bitcast<f32>(known & VALUE);
}

fn middle(stretch: u32, length: f32) -> f32 {
    return (f32(stretch) + 0.5) * 0.5 * length;
}

fn list_place(parity: u32) -> u32 {
    return LISTS + parity * round.patches;
}

fn pending_place(parity: u32) -> u32 {
    return LISTS + (2u + parity) * round.patches;
}

// Lists a patch for the next round, with a distance that has come to it.
fn activate(number: u32, distance: u32) {
    let parity = 1u - round.parity;
    if (atomicMin(&control[pending_place(parity) + number], distance) == INFINITE) {
        let place = atomicAdd(&control[COUNT + round.next], 1u);
        atomicStore(&control[list_place(parity) + place], number);
    }
    atomicMin(&control[LEAST + round.next], distance);
}

fn patch_of(number: u32) -> Patch {
    let at = 8u * number;
    var own: Patch;
    own.number = number;
    own.first_face = tables[at];
    own.face_count = tables[at + 1u];
    own.first_edge = tables[at + 2u];
    own.edge_count = tables[at + 3u];
    own.vertex_count = tables[at + 4u];
    own.edges = tables[at + 5u];
    own.vertices = tables[at + 6u];
    own.state = tables[at + 7u];
    return own;
}

// A window that has come to a slot of a patch, and the slot.
struct Arrival {
    slot: u32,
    label: vec4<u32>,
    // Bits of the distance of the stretch's middle.
    value: u32,
}

// What the neighbor of a patch sent for a stretch of an edge between them; infinite where that is nothing.
fn arrival(own: Patch, number: u32) -> Arrival {
    let edge = own.edges + 3u * (number >> 1u);
    let halfedge = tables[edge];
    let sent_edge = (1u - round.parity) * round.edges + tables[edge + 2u];
    var result: Arrival;
    result.slot = 2u * halfedge + (number & 1u);
    result.label = sent_labels[2u * sent_edge + (number & 1u)];
    let length = faces[own.first_face + halfedge / 3u].lengths[halfedge % 3u];
    result.value = INFINITE;
    if (!is_empty(result.label)) {
        result.value = bitcast<u32>(bent_at(unpack(result.label, length), middle(number & 1u, length)));
    }
    return result;
}

// Keeps what has come to a patch, for a later round.
fn postpone(own: Patch, thread: u32) {
    for (var number = thread; number < 2u * own.edge_count; number += THREADS) {
        let arrived = arrival(own, number);
        let place = own.state + arrived.slot;
        if (is_sooner(bitcast<f32>(arrived.value), state[place] & ~WAITING)) {
            state[place] = (arrived.value & VALUE) | WAITING;
            labels[6u * own.first_face + arrived.slot] = arrived.label;
        }
    }
}

// Lets the window of a slot wait, if it does not yet.
fn let_wait(slot: u32) {
    let bit = 1u << (slot & 31u);
    if ((atomicOr(&is_waiting[slot >> 5u], bit) & bit) == 0u) {
        ring[atomicAdd(&ring_end, 1u) % SLOTS] = slot;
    }
}

fn waits(slot: u32) -> bool {
    return (atomicLoad(&is_waiting[slot >> 5u]) & (1u << (slot & 31u))) != 0u;
}

// Brings a patch into the memory of the workgroup.
fn load(own: Patch, thread: u32) {
    let slots = 6u * own.face_count;
    let edges = 2u * own.edge_count;
    for (var word = thread; word < WORDS; word += THREADS) {
        atomicStore(&is_waiting[word], 0u);
    }
    if (thread < TOLD_WORDS) {
        atomicStore(&is_told[thread], 0u);
    }
    if (thread == 0u) {
        ring_begin = 0u;
        atomicStore(&ring_end, 0u);
        atomicStore(&least_left, INFINITE);
    }
    workgroupBarrier();
    for (var slot = thread; slot < slots; slot += THREADS) {
        let known = state[own.state + slot];
        atomicStore(&values[slot], known & ~WAITING);
        if ((known & WAITING) != 0u) {
            windows[slot] = labels[6u * own.first_face + slot];
            let_wait(slot);
        }
    }
    for (var number = thread; number < edges; number += THREADS) {
        atomicStore(&values[SLOTS + number], state[own.state + slots + number]);
    }
    for (var vertex = thread; vertex < own.vertex_count; vertex += THREADS) {
        atomicStore(&near[vertex], atomicLoad(&distances[tables[own.vertices + 2u * vertex]]));
        sent[vertex] = state[own.state + slots + edges + vertex];
    }
    workgroupBarrier();
    for (var number = thread; number < edges; number += THREADS) {
        let arrived = arrival(own, number);
        if (is_sooner(bitcast<f32>(arrived.value), atomicLoad(&values[arrived.slot]))) {
            atomicStore(&values[arrived.slot], arrived.value & VALUE);
            windows[arrived.slot] = arrived.label;
            let_wait(arrived.slot);
        }
    }
    workgroupBarrier();
}

// Writes a patch back, and lists the patches that it has reached.
fn store(own: Patch, thread: u32) {
    let slots = 6u * own.face_count;
    let edges = 2u * own.edge_count;
    for (var slot = thread; slot < slots; slot += THREADS) {
        var value = atomicLoad(&values[slot]);
        if (waits(slot) && !is_empty(windows[slot])) {
            atomicMin(&least_left, value & VALUE);
            value |= WAITING;
            labels[6u * own.first_face + slot] = windows[slot];
        }
        state[own.state + slot] = value;
    }
    for (var edge = thread; edge < own.edge_count; edge += THREADS) {
        if ((atomicLoad(&is_told[edge >> 5u]) & (1u << (edge & 31u))) != 0u) {
            let first = atomicLoad(&values[SLOTS + 2u * edge]);
            let second = atomicLoad(&values[SLOTS + 2u * edge + 1u]);
            state[own.state + slots + 2u * edge] = first;
            state[own.state + slots + 2u * edge + 1u] = second;
            activate(tables[own.edges + 3u * edge + 1u], min(first, second) & VALUE);
        }
    }
    for (var vertex = thread; vertex < own.vertex_count; vertex += THREADS) {
        let bits = atomicLoad(&near[vertex]);
        if (is_to_send(vertex)) {
            atomicMin(&least_left, bits);
        }
        state[own.state + slots + edges + vertex] = sent[vertex];
        let at = own.vertices + 2u * vertex;
        // Who lowers it tells the others.
        if (bits < atomicMin(&distances[tables[at]], bits) && tables[at + 1u] != NONE) {
            let others = tables[at + 1u];
            for (var other = 1u; other <= tables[others]; other += 1u) {
                if (tables[others + other] != own.number) {
                    activate(tables[others + other], bits);
                }
            }
        }
    }
    workgroupBarrier();
    if (thread == 0u && atomicLoad(&least_left) != INFINITE) {
        activate(own.number, atomicLoad(&least_left));
    }
}

fn near_to(vertex: u32) -> f32 {
    return bitcast<f32>(atomicLoad(&near[vertex]));
}

fn is_to_send(vertex: u32) -> bool {
    let value = near_to(vertex);
    return value + margin(value) < bitcast<f32>(sent[vertex]);
}
