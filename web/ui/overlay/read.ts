/** What is to be told of a file that was read; fetched with the first that needs it. */
import type { OpenedMesh } from '../../protocol';
import { trianglesWords } from '../words';
import { count, counted, enumerated, sentences, some, t, type Words } from '../../texts';

const NAMED = 4;

/** What a file was read without, or otherwise than it is written, and what keeps it from looking as it should. */
export function absentSentence({ name, missing, undecoded, warnings }: OpenedMesh): Words {
  const found = warnings.map((warning) => t`${name}, ${placeWords(warning.place)}: ${warningWords(warning)}.`);
  if (missing.length === 1) found.push(t`${name} refers to ${first(missing)}, which was not given.`);
  if (missing.length > 1) found.push(t`${name} refers to ${first(missing)}, which were not given.`);
  if (undecoded.length > 0) found.push(t`The browser cannot show ${first(undecoded)}.`);
  return sentences(...found);
}

/** What was left out, or taken otherwise than it is written. */
function warningWords({ code, count: number }: OpenedMesh['warnings'][number]): Words {
  switch (code) {
    case 'lines-left-out':
      return counted(number, '{0} point or line left out', '{0} points or lines left out');
    case 'curves-left-out':
      return counted(
        number,
        '{0} statement of a curve left out; save the model as polygons',
        '{0} statements of curves left out; save the model as polygons',
      );
    case 'volumes-left-out':
      return counted(number, '{0} cell that fills space left out', '{0} cells that fill space left out');
    case 'unknown-statements':
      return counted(number, '{0} unknown statement left out', '{0} unknown statements left out');
    case 'unjoined-lines':
      return t('a backslash ends a line; the next one begins a statement of its own and was not joined to it');
    case 'unended-facets':
      return counted(number, '{0} facet without endfacet', '{0} facets without endfacet');
    case 'no-end':
      return t('the end of the file is missing; it may be cut short');
    case 'trailing':
      return t('there is more behind the end; it was left out');
    case 'straightened':
      return counted(
        number,
        '{0} curved cell made flat between the corners',
        '{0} curved cells made flat between the corners',
      );
    case 'crossed-polygons':
      return counted(
        number,
        '{0} polygon crosses itself; the triangles are a guess',
        '{0} polygons cross themselves; the triangles are a guess',
      );
    default:
      return code;
  }
}

/** A place in a file; the names of elements are those of its format. */
function placeWords(place: string): Words {
  const [, line] = /^line (\d+)$/.exec(place) ?? [];
  return line ? t`line ${line}` : place;
}

/** Names, of many the first ones. */
function first(names: readonly string[]): Words {
  const rest = names.length - NAMED;
  const shown = names.slice(0, NAMED).map((name) => name || t('an image'));
  return enumerated(rest > 0 ? [...shown, t`${count(rest)} more`] : shown);
}

/** What joins the points of a cloud. */
export function cloudSentence({ report }: OpenedMesh): Words {
  const { faces, boundaryLoops, unreferencedVertices } = report;
  return sentences(
    boundaryLoops > 0
      ? counted(
          boundaryLoops,
          '{1} join them, with {0} hole or border.',
          '{1} join them, with {0} holes and borders.',
          trianglesWords(faces),
        )
      : t`${trianglesWords(faces)} join them, without a hole.`,
    some(unreferencedVertices, '{0} point is on no triangle.', '{0} points are on no triangle.'),
  );
}
