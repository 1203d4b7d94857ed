/** Texts that are pasted, and tables that come as files. Fetched with the first of these. */
import { addressIn, hostOf } from '../files/address';
import { fileName } from '../files/paths';
import { detailsOf, Failure, sentenceOf } from '../error';
import type { InputFile } from '../protocol';
import { decodeLink } from '../state/link';
import { isList, isNamedList, isOneLine } from '../state/list';
import { startOf } from '../state/start';
import { paintRows } from './costs';
import type { Notifier } from './notifier';
import type { Session } from './session';
import { counted, enumerated, t } from '../texts';

/** Letters of a text that a message repeats. */
const TOLD_LETTERS = 40;

/** Adds sources to the mesh on screen, or paints its ground: what a heading says, and without one the ground. Takes one table alone. */
export async function takeTable(session: Session, notifier: Notifier, tables: readonly InputFile[]): Promise<void> {
  await reported(notifier, async () => {
    const [table] = tables;
    if (!table || tables.length > 1) {
      const names = enumerated(tables.map(({ path }) => fileName(path)));
      throw new Failure(t`${names} are tables, of which one is taken at a time. Nothing has changed.`);
    }
    const name = fileName(table.path);
    const text = await table.content.text();
    if (!isNamedList(text)) return paintRows(session, name, text);
    const { addList } = await import('./sets');
    notifier.remark(addList(session, name, text));
  });
}

/** Follows a link of this page, adds a list of sources to the mesh on screen, and tells what is neither. */
export async function takePasted(session: Session, notifier: Notifier, text: string): Promise<void> {
  const fragment = sceneIn(text);
  if (fragment !== null) {
    const { state } = decodeLink(fragment, startOf);
    if (state) location.hash = fragment;
    else notifier.remark(t('The link that was pasted names no mesh that can be opened. Nothing has changed.'));
  } else if (isList(text)) await reported(notifier, () => offerList(session, notifier, text));
  else {
    const address = addressIn(text);
    const short = text.trim().replaceAll(/\s+/g, ' ').slice(0, TOLD_LETTERS);
    notifier.remark(
      address
        ? t`This address of ${hostOf(address)} names no mesh; open it by the menu beside the name if there is one.`
        : t`What was pasted, “${short}”, is no mesh, no address of one, no link and no list of sources. Nothing has changed.`,
    );
  }
}

/** Adds a list; stray numbers that lie elsewhere than the model only once the user says so. */
async function offerList(session: Session, notifier: Notifier, text: string): Promise<void> {
  const { placeList } = await import('./sets');
  const list = placeList(session, String(isOneLine(text) ? t('What was pasted') : t('List')), text);
  // A heading says what is meant.
  if (!list.isFar || isNamedList(text)) {
    notifier.remark(list.add());
    return;
  }
  const mesh = session.shown.value?.opened;
  notifier.remark(
    counted(
      list.count,
      'The numbers pasted ({0} place) lie {1} away from the model. Nothing has changed.',
      'The numbers pasted ({0} places) lie up to {1} away from the model. Nothing has changed.',
      list.away,
    ),
    {
      name: counted(list.count, 'Add the nearest place as a source', 'Add the nearest places as sources'),
      run: () => {
        // Places of another mesh mean nothing on this one.
        if (session.shown.value?.opened === mesh) void reported(notifier, () => notifier.remark(list.add()));
      },
    },
  );
}

/** The fragment of a link of this page that names a scene. */
function sceneIn(text: string): string | null {
  const trimmed = text.trim();
  if (/\s/.test(trimmed) || !URL.canParse(trimmed)) return null;
  const { origin, pathname, hash } = new URL(trimmed);
  const keys = new URLSearchParams(hash.slice(1));
  const isOurs = origin === location.origin && pathname === location.pathname;
  return isOurs && (keys.has('m') || keys.has('model')) ? hash : null;
}

/** Tells why a change fails. */
async function reported(notifier: Notifier, work: () => Promise<void> | void): Promise<void> {
  try {
    await work();
  } catch (error) {
    notifier.fail(sentenceOf(error), detailsOf(error));
  }
}
