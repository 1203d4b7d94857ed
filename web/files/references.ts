/** What the text of a mesh refers to. */
import { percentDecoded } from './address';
import { joined } from './paths';

/** A file that a mesh refers to. */
export interface Reference {
  /** Relative to the mesh. */
  uri: string;
  /** Where `resolve` finds it. */
  path: string;
  /** Whether there is no surface without. */
  isNeeded: boolean;
}

/** The buffers and images of a glTF document; a document that is none has none. */
export function gltfReferences(mesh: string, document: string): Reference[] {
  const reference = (isNeeded: boolean) => (uri: string) => ({
    uri,
    path: joined(mesh, percentDecoded(uri)),
    isNeeded,
  });
  try {
    const { buffers, images } = JSON.parse(document) as Record<string, unknown>;
    return [...urisOf(buffers).map(reference(true)), ...urisOf(images).map(reference(false))];
  } catch {
    // Its reader says what is wrong.
    return [];
  }
}

function urisOf(entries: unknown): string[] {
  const uris: unknown[] = Array.isArray(entries) ? entries.map((entry: { uri?: unknown } | null) => entry?.uri) : [];
  return [...new Set(uris.filter((uri) => typeof uri === 'string').filter((uri) => !uri.startsWith('data:')))];
}

/** The material libraries of an OBJ file. */
export function librariesOf(mesh: string, text: string): Reference[] {
  return optional(mesh, '', argumentsOf(text, /^[ \t]*mtllib[ \t]+(.+)$/gm));
}

const OPTION = /^-(?:[ost](?:\s+[-+.\de]+){1,3}|mm\s+\S+\s+\S+|\w+\s+\S+)\s+/i;

/** The images of a material library at `library`, which are named relative to it. */
export function mapsOf(mesh: string, library: string, text: string): Reference[] {
  const names = argumentsOf(text, /^[ \t]*(?:map_\w+|bump|norm)[ \t]+(.+)$/gim).map((statement) => {
    let name = statement;
    while (OPTION.test(name)) name = name.replace(OPTION, '');
    return name;
  });
  const folder = mesh.includes('/') ? mesh.slice(0, mesh.lastIndexOf('/') + 1).length : 0;
  const inside = library.slice(folder);
  return optional(mesh, inside.slice(0, inside.lastIndexOf('/') + 1), names);
}

function argumentsOf(text: string, statement: RegExp): string[] {
  return Array.from(text.matchAll(statement), ([, found = '']) => found.trim());
}

/** Files by their names, which no percent signs encode. */
function optional(mesh: string, folder: string, names: readonly string[]): Reference[] {
  return [...new Set(names)].map((name) => {
    const plain = `${folder}${name.replaceAll('\\', '/')}`;
    const uri = plain.split('/').map(encodeURIComponent).join('/');
    return { uri, path: joined(mesh, plain), isNeeded: false };
  });
}
