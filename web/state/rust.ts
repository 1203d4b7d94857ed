/** The lines of Rust that give the distances of a scene again, by the crates `heatwalk` and `heatwalk-model`. */
import { AUTOMATIC, DEFAULT_PARAMETERS } from '../wasm/contract';
import { type Measured, type SurfaceSource, surfaceSources } from './reproduce';

const INDENT = '    ';
/** As the formatter of Rust is set here. */
const WIDTH = 120;

/**
 * A program that prints the distances as CSV, formatted.
 *
 * @throws Error where the crate cannot be asked for the same, with the reason.
 */
export function rustLines(measured: Measured): string {
  const { state, mesh, opened, field, unit } = measured;
  const factor = unit.scale === 1 ? '' : `${float(unit.scale)} * `;
  const sources = surfaceSources(measured);
  const used = new Set(['DistanceOptions', 'DistanceSolver', 'InputVertex', 'Method', 'Surface', 'go_on']);
  const use = (...names: string[]) => names.forEach((name) => used.add(name));
  const shape = /^shape:(\w+)$/.exec(mesh);
  const body = [shape ? `let model = by_name("${shape[1]}")?;` : readLine(mesh)];
  if (opened.active.length < opened.parts.length)
    body.push(`let model = model.chosen(&[${opened.active.join(', ')}])?;`);
  const { clip, seconds, live } = state.animation;
  if (live && clip !== null) body.push(`let model = model.posed(${clip}, ${float(seconds)})?;`);
  body.push('let surface = Surface::build(&model.soup)?;', ...sourceLines(sources, use), ...solverLines(state, use));
  body.push(
    ...optionLines(state, field, use),
    'let distance = solver.distance(&sources, &options, &mut go_on)?.distance;',
    'for input in 0..model.soup.positions.len() as u32 {',
    `${INDENT}let vertex = solver.surface().vertex_of_input(InputVertex(input));`,
    `${INDENT}println!("{input},{}", ${factor}vertex.map_or(f64::INFINITY, |vertex| distance.values[vertex]));`,
    '}',
    'Ok(())',
  );
  return [
    `//! Distances on ${mesh.replaceAll(/\s/g, ' ')}, as the page of Heatwalk shows them: a line of vertex,distance each${unit.symbol && `, in ${unit.symbol}`}.`,
    '',
    ...imported([...used].toSorted(byRust)),
    shape ? 'use heatwalk_shapes::by_name;' : 'use heatwalk_model::io;',
    '',
    'fn main() -> Result<(), Box<dyn std::error::Error>> {',
    ...body.map((line) => INDENT + line),
    '}',
    '',
  ].join('\n');
}

type Use = (...names: string[]) => void;

/** Names of types before those of modules. */
function byRust(one: string, other: string): number {
  return Number(/^[a-z]/.test(one)) - Number(/^[a-z]/.test(other)) || (one < other ? -1 : 1);
}

function readLine(mesh: string): string {
  const name = text(mesh);
  return `let model = io::read(${name}, &std::fs::read(${name})?, &|file| std::fs::read(file).ok())?;`;
}

function sourceLines(sources: readonly SurfaceSource[], use: Use): string[] {
  use('Place');
  const lines = [];
  if (sources.some((source) => 'vertex' in source))
    lines.push(
      'let vertex = |input| surface.vertex_of_input(InputVertex(input)).ok_or("a vertex without a triangle");',
    );
  if (sources.some((source) => 'face' in source)) {
    use('InputTriangle');
    lines.push('let face = |index| surface.face_of_triangle(InputTriangle(index)).ok_or("a triangle without area");');
  }
  const places = sources.map((source) => {
    const place =
      'vertex' in source
        ? `Place::Vertex(vertex(${source.vertex})?)`
        : `Place::Face { face: face(${source.face})?, weights: [${source.weights.map(float).join(', ')}] }`;
    return `(${place}, ${float(source.offset ?? 0)})`;
  });
  return [...lines, ...laid('let sources = [', places, '];', '')];
}

function solverLines({ bridge, links }: Measured['state'], use: Use): string[] {
  if (bridge === 'off' && links === 0) return ['let mut solver = DistanceSolver::new(surface);'];
  use('BridgeRule', 'Bridges');
  const automatic = bridge === AUTOMATIC ? 'BridgeRule::Automatic' : `BridgeRule::Within(${float(Number(bridge))})`;
  const rule = bridge === 'off' ? 'BridgeRule::Off' : automatic;
  const lines = [`let bridges = Bridges::find(&surface, ${rule});`];
  if (links > 0)
    lines.push(
      'let mut links = bridges.links(&surface);',
      `links.truncate(${links});`,
      'let bridges = bridges.linked(&surface, &links);',
    );
  return [...lines, 'let mut solver = DistanceSolver::new(surface).bridged(bridges);'];
}

function optionLines({ method, parameters, windows }: Measured['state'], field: Measured['field'], use: Use): string[] {
  if (field.exactBelow === Infinity) return ['let options = DistanceOptions::by(Method::Exact);'];
  if (method !== 'heat' || field.windows !== undefined) {
    use('Windows');
    return [
      `let windows = Windows::AtMost(${field.windows || windows}.try_into()?);`,
      'let options = DistanceOptions { windows, ..DistanceOptions::by(Method::Propagation) };',
    ];
  }
  const { operator, solver, timeStep, boundary, sources, exactRadius } = parameters;
  const changed: string[] = [];
  const change = (key: string, value: string, isDefault: boolean) => {
    if (!isDefault) changed.push(`${key}: ${value}`);
  };
  change('operator', `${text(operator)}.parse()?`, operator === DEFAULT_PARAMETERS.operator);
  change('solver', `${text(solver)}.parse()?`, solver === DEFAULT_PARAMETERS.solver);
  if (timeStep !== AUTOMATIC) {
    use('TimeStep');
    changed.push(`time_step: TimeStep::Factor(${float(timeStep)})`);
  }
  change('boundary', `${text(boundary)}.parse()?`, boundary === DEFAULT_PARAMETERS.boundary);
  change('sources', `${text(sources)}.parse()?`, sources === DEFAULT_PARAMETERS.sources);
  if (exactRadius !== AUTOMATIC) {
    use('ExactRadius');
    changed.push(`exact_radius: ExactRadius::Edges(${float(exactRadius)})`);
  }
  if (changed.length === 0) return ['let options = DistanceOptions::by(Method::Heat);'];
  use('Parameters');
  return [
    ...laid('let heat = Parameters {', changed, '};', ' ', '..Parameters::default()'),
    'let options = DistanceOptions { heat, ..DistanceOptions::by(Method::Heat) };',
  ];
}

/** Items between brackets, on one line where they fit. `rest` comes last, without a comma after it. */
function laid(open: string, items: readonly string[], close: string, space: '' | ' ', rest?: string): string[] {
  const all = rest === undefined ? items : [...items, rest];
  const line = `${open}${space}${all.join(', ')}${space}${close}`;
  if (INDENT.length + line.length <= WIDTH) return [line];
  return [open, ...items.map((item) => `${INDENT}${item},`), ...(rest === undefined ? [] : [INDENT + rest]), close];
}

/** Names from the crate: on one line where they fit, else as many a line as do. */
function imported(names: readonly string[]): string[] {
  const line = `use heatwalk::{${names.join(', ')}};`;
  // rustfmt leaves space for what could follow.
  if (line.length <= WIDTH - 2) return [line];
  const lines = [INDENT.trimEnd()];
  for (const name of names) {
    const last = lines[lines.length - 1];
    const longer = last === '' ? `${INDENT}${name},` : `${last} ${name},`;
    if (longer.length <= WIDTH) lines[lines.length - 1] = longer;
    else lines.push(`${INDENT}${name},`);
  }
  return ['use heatwalk::{', ...lines, '};'];
}

function float(value: number): string {
  if (value === Infinity) return 'f64::INFINITY';
  return Number.isInteger(value) && Math.abs(value) < 1e15 ? value.toFixed(1) : String(value);
}

/** A string of Rust. */
function text(value: string): string {
  return `"${value.replaceAll(/["\\]/g, String.raw`\$&`)}"`;
}
