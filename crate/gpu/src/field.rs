//! Distances on a device.

use std::sync::Arc;

use heatwalk::{ToSource, VertexId};
use wgpu::util::DeviceExt as _;

use crate::error::{Error, Result};
use crate::layout::Layout;
use crate::pipelines::{Pipelines, STORAGE_BUFFERS};
use crate::readback;
use crate::records::{FaceRecord, INFINITE, RoundRecord};
use crate::seeds::Seeds;

/// Bytes of a window.
const LABEL: u64 = size_of::<[u32; 4]>() as u64;

/// Rounds that differ: two parities, three places of counts and least distances.
const PHASES: u32 = 6;

/// Bytes from one of them to the next, as uniforms are aligned.
const STRIDE: u64 = 256;

/// Workgroups of a round at most: what is more works on further patches of the list.
const MOST_WORKGROUPS: u32 = 4096;

/// Words of `control` before its lists, and where in them the count of the first list and the number of rounds with work are.
const CONTROL_WORDS: usize = 8;
const COUNT: usize = 0;
const LEAST: usize = 3;
const ROUNDS: usize = 6;

/// Rounds that are encoded before the first answer, and after each that says that something is left.
const FEW_ROUNDS: u32 = 48;

/// Rounds beyond the number of the last time, as a share of it.
const SPARE: f64 = 0.15;

/// Rounds that a front takes at most: some for each patch that it may have to pass one after another, and some more.
const ROUNDS_OF_PATCH: u32 = 16;
const ROUNDS_OF_ANY: u32 = 1024;

/// What was done for an answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Rounds in which something was left to do.
    pub rounds: u32,
}

/// Distances of the vertices of a surface, on a device.
pub struct DistanceField {
    device: wgpu::Device,
    queue: wgpu::Queue,
    layout: Arc<Layout>,
    pipelines: Pipelines,
    state: wgpu::Buffer,
    labels: wgpu::Buffer,
    distances: wgpu::Buffer,
    control: wgpu::Buffer,
    output: wgpu::Buffer,
    clear: wgpu::BindGroup,
    advance: wgpu::BindGroup,
    gather: wgpu::BindGroup,
    /// Rounds to encode at once, and rounds that an answer may take.
    expected: u32,
    most: u32,
}

impl DistanceField {
    /// Brings a surface to a device. The buffer of distances has one 32-bit float for each vertex of `order`, a vertex as often as
    /// the caller needs it.
    ///
    /// The device needs WebGPU's default limits only.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for buffers beyond the device's limits; [`Error::Device`] where it has no compute shaders or too little
    /// memory; [`Error::NoVertex`]; [`Error::Source`] where `order` names a vertex that is not on the surface.
    pub async fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: Arc<Layout>,
        order: impl IntoIterator<Item = VertexId>,
    ) -> Result<Self> {
        let order: Vec<u32> = order.into_iter().map(|vertex| vertex.0).collect();
        if order.is_empty() {
            return Err(Error::NoVertex);
        }
        let vertices = layout.surface().vertex_count();
        if let Some(&vertex) = order.iter().find(|&&vertex| vertex as usize >= vertices) {
            return Err(heatwalk::surface::Error::NoSuchVertex { vertex: vertex as usize, vertices }.into());
        }
        let sizes = Sizes::new(&layout, order.len());
        sizes.require(&device.limits())?;
        let memory = device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let field = Self::allocated(device, queue, layout, &order, &sizes);
        match memory.pop().await {
            None => Ok(field),
            Some(error) => Err(Error::Device { reason: error.to_string() }),
        }
    }

    fn allocated(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: Arc<Layout>,
        order: &[u32],
        sizes: &Sizes,
    ) -> Self {
        let pipelines = Pipelines::new(device, layout.capacity);
        let most = ROUNDS_OF_ANY.saturating_add(ROUNDS_OF_PATCH.saturating_mul(layout.patches.len() as u32));
        let filled = |label, contents: &[u8], usage| {
            device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: Some(label), contents, usage })
        };
        let empty = |label, size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor { label: Some(label), size, usage, mapped_at_creation: false })
        };
        let storage = wgpu::BufferUsages::STORAGE;
        let written = storage | wgpu::BufferUsages::COPY_DST;
        let faces = filled("faces", bytemuck::cast_slice(&layout.faces), storage);
        let tables = filled("tables of patches", bytemuck::cast_slice(&layout.tables), storage);
        let state = empty("state", sizes.state, written);
        let labels = empty("windows", sizes.labels, written);
        let sent = empty("sent windows", sizes.sent, storage);
        let distances = empty("distances", sizes.distances, written);
        let control = empty("control", sizes.control, written | wgpu::BufferUsages::COPY_SRC);
        let order = filled("order of vertices", bytemuck::cast_slice(order), storage);
        let usage = storage | wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::VERTEX;
        let output = empty("distances in order", sizes.output, usage);
        let unit = [layout.mean_edge as f32, 0.0, 0.0, 0.0];
        let unit = filled("unit", bytemuck::cast_slice(&unit), wgpu::BufferUsages::UNIFORM);
        let rounds = filled("rounds", &rounds(&layout), wgpu::BufferUsages::UNIFORM);
        let round = wgpu::BufferBinding {
            buffer: &rounds,
            offset: 0,
            size: wgpu::BufferSize::new(size_of::<RoundRecord>() as u64),
        };
        let all = wgpu::Buffer::as_entire_binding;
        let bound = [&faces, &tables, &state, &labels, &sent, &distances, &control].map(all);
        let bound = std::iter::once(wgpu::BindingResource::Buffer(round)).chain(bound).collect::<Vec<_>>();
        Self {
            clear: pipelines.clear.bind(device, "clear", &[&state, &sent, &distances].map(all)),
            advance: pipelines.advance.bind(device, "advance", &bound),
            gather: pipelines.gather.bind(device, "gather", &[&distances, &order, &output, &unit].map(all)),
            device: device.clone(),
            queue: queue.clone(),
            layout,
            pipelines,
            state,
            labels,
            distances,
            control,
            output,
            expected: FEW_ROUNDS,
            most,
        }
    }

    /// Lets an answer take fewer rounds, or more, than a front is known to need: some thousand, and sixteen for each patch.
    pub fn limit_rounds(&mut self, rounds: u32) {
        self.most = rounds;
    }

    /// Distances from the nearest of some sources, for all vertices of the order. They are in [`buffer`](Self::buffer) when this is
    /// done.
    ///
    /// # Errors
    /// [`Error::NoSource`]; [`Error::Source`]; [`Error::NotFinished`]; [`Error::Device`]. The buffer holds nothing of use then.
    pub async fn solve<S: ToSource>(&mut self, sources: &[S]) -> Result<Progress> {
        if sources.is_empty() {
            return Err(Error::NoSource);
        }
        let surface = self.layout.surface();
        let sources = sources.iter().map(|source| source.to_source(surface));
        let sources = sources.collect::<Result<Vec<_>, heatwalk::surface::Error>>()?;
        let seeds = Seeds::new(&self.layout, &sources);
        self.start(&seeds);
        let (mut encoded, mut batch) = (0, self.expected);
        loop {
            let answer = self.advance_by(batch).await?;
            encoded += batch;
            let rounds = answer[ROUNDS];
            if answer[COUNT] == 0 {
                let expected = f64::from(rounds) * (1.0 + SPARE);
                self.expected = (expected as u32 + 1).next_multiple_of(PHASES);
                return Ok(Progress { rounds });
            }
            if encoded >= self.most {
                return Err(Error::NotFinished { rounds });
            }
            // A front that needs many gets more of them at once.
            batch = FEW_ROUNDS.max((encoded / 4).next_multiple_of(PHASES));
        }
    }

    /// One 32-bit float for each vertex of the order, in the file's unit; infinite where no source is reached. To be bound as storage
    /// or as vertices, or copied.
    pub fn buffer(&self) -> &wgpu::Buffer {
        &self.output
    }

    /// The numbers of the buffer.
    ///
    /// # Errors
    /// [`Error::Device`].
    pub async fn read(&self) -> Result<Vec<f32>> {
        let mut encoder = self.encoder();
        let read = self.copied(&mut encoder, &self.output, self.output.size());
        self.queue.submit([encoder.finish()]);
        readback::read(&self.device, &read).await
    }

    /// A copy of the first bytes of a buffer, to be read. It is a new one each time: who waited for the last one may have given up.
    fn copied(&self, encoder: &mut wgpu::CommandEncoder, buffer: &wgpu::Buffer, size: u64) -> wgpu::Buffer {
        let copy = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("copy to read"),
            size,
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        encoder.copy_buffer_to_buffer(buffer, 0, &copy, 0, size);
        copy
    }

    fn encoder(&self) -> wgpu::CommandEncoder {
        self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor { label: Some("distance") })
    }

    /// Forgets the last answer, and writes what the first round starts from.
    fn start(&self, seeds: &Seeds) {
        let mut encoder = self.encoder();
        let mut pass =
            encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some("clear"), timestamp_writes: None });
        pass.set_pipeline(&self.pipelines.clear.pipeline);
        pass.set_bind_group(0, &self.clear, &[]);
        pass.dispatch_workgroups(self.layout.state_count.div_ceil(64).min(MOST_WORKGROUPS), 1, 1);
        drop(pass);
        self.queue.submit([encoder.finish()]);
        let patches = self.layout.patches.len();
        let mut control = vec![INFINITE; CONTROL_WORDS + 4 * patches];
        control[..CONTROL_WORDS].fill(0);
        control[LEAST..LEAST + 3].fill(INFINITE);
        control[COUNT] = seeds.patches.len() as u32;
        for (place, (&patch, distance)) in seeds.patches.iter().enumerate() {
            control[CONTROL_WORDS + place] = patch;
            control[CONTROL_WORDS + 2 * patches + patch as usize] = distance.to_bits();
            control[LEAST] = control[LEAST].min(distance.to_bits());
        }
        self.queue.write_buffer(&self.control, 0, bytemuck::cast_slice(&control));
        for (&vertex, distance) in &seeds.vertices {
            self.queue.write_buffer(&self.distances, 4 * u64::from(vertex), bytemuck::bytes_of(distance));
        }
        for (&place, seed) in &seeds.windows {
            self.queue.write_buffer(&self.labels, LABEL * u64::from(place), bytemuck::bytes_of(&seed.label));
            self.queue.write_buffer(&self.state, 4 * u64::from(seed.state), bytemuck::bytes_of(&seed.word));
        }
    }

    /// Does so many rounds, a multiple of [`PHASES`], and writes the distances as they are then. Gives the words of `control`.
    async fn advance_by(&self, rounds: u32) -> Result<Vec<u32>> {
        let mut encoder = self.encoder();
        let mut pass =
            encoder.begin_compute_pass(&wgpu::ComputePassDescriptor { label: Some("advance"), timestamp_writes: None });
        pass.set_pipeline(&self.pipelines.advance.pipeline);
        for round in 0..rounds {
            pass.set_bind_group(0, &self.advance, &[round % PHASES * STRIDE as u32]);
            pass.dispatch_workgroups(workgroups(&self.layout), 1, 1);
        }
        pass.set_pipeline(&self.pipelines.gather.pipeline);
        pass.set_bind_group(0, &self.gather, &[]);
        pass.dispatch_workgroups((self.output.size() / 4).div_ceil(64).min(u64::from(MOST_WORKGROUPS)) as u32, 1, 1);
        drop(pass);
        let read = self.copied(&mut encoder, &self.control, 4 * CONTROL_WORDS as u64);
        self.queue.submit([encoder.finish()]);
        readback::read(&self.device, &read).await
    }
}

/// Workgroups of a round.
fn workgroups(layout: &Layout) -> u32 {
    (layout.patches.len() as u32).min(MOST_WORKGROUPS)
}

/// The uniforms of the rounds that differ.
fn rounds(layout: &Layout) -> Vec<u8> {
    let mut bytes = vec![0; (STRIDE * u64::from(PHASES)) as usize];
    for (phase, place) in (0..PHASES).zip(bytes.chunks_exact_mut(STRIDE as usize)) {
        let record = RoundRecord {
            now: phase % 3,
            next: (phase + 1) % 3,
            later: (phase + 2) % 3,
            parity: phase % 2,
            workgroups: workgroups(layout),
            patches: layout.patches.len() as u32,
            edges: layout.edge_count,
            padding: 0,
        };
        place[..size_of::<RoundRecord>()].copy_from_slice(bytemuck::bytes_of(&record));
    }
    bytes
}

/// Bytes of the buffers of a mesh.
struct Sizes {
    faces: u64,
    tables: u64,
    state: u64,
    labels: u64,
    sent: u64,
    distances: u64,
    control: u64,
    output: u64,
}

impl Sizes {
    fn new(layout: &Layout, order: usize) -> Self {
        let words = |count: usize| 4 * count as u64;
        Self {
            faces: size_of::<FaceRecord>() as u64 * layout.faces.len() as u64,
            tables: words(layout.tables.len()),
            state: words(layout.state_count as usize),
            labels: LABEL * 6 * layout.faces.len() as u64,
            // A buffer is never empty.
            sent: LABEL * 4 * u64::from(layout.edge_count.max(1)),
            distances: words(layout.surface().vertex_count()),
            control: words(CONTROL_WORDS + 4 * layout.patches.len()),
            output: words(order),
        }
    }

    /// Refuses a device that they do not fit into.
    fn require(&self, limits: &wgpu::Limits) -> Result<()> {
        if limits.max_storage_buffers_per_shader_stage < STORAGE_BUFFERS {
            return Err(Error::Device { reason: "it was opened without storage buffers".to_owned() });
        }
        let limit = limits.max_storage_buffer_binding_size.min(limits.max_buffer_size);
        let parts = [
            ("triangles", self.faces),
            ("patches", self.tables),
            ("values", self.state),
            ("windows", self.labels),
            ("windows between patches", self.sent),
            ("distances", self.distances),
            ("lists of patches", self.control),
            ("distances in order", self.output),
        ];
        match parts.into_iter().find(|&(_, bytes)| bytes > limit) {
            None => Ok(()),
            Some((what, needed)) => Err(Error::TooLarge { what, needed, limit, unit: "bytes" }),
        }
    }
}
