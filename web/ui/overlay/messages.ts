/** Messages at the bottom left. All but what was opened stay until they are closed; errors can be copied. */
import { hostOf, nameOf } from '../../files/address';
import { MOST_FETCHED } from '../../files/fetch';
import { fileName } from '../../files/paths';
import type { Action, Notifier } from '../../session/notifier';
import type { OpenedMesh } from '../../protocol';
import type { Shown } from '../../session/prepare';
import { unitOf } from '../../length';
import { refusedWords } from '../../state/link';
import type { SceneState } from '../../state/scene';
import { AUTOMATIC } from '../../wasm/contract';
import { copy } from '../clipboard';
import { h } from '../dom';
import { openingDetails, openingSentence } from '../words';
import { t, type Words } from '../../texts';

const SHOWN_MS = 8000;
/** More would cover the model. */
const MOST_NOTICES = 3;
/** There the model or the panel has no room beside it. */
const SMALL = matchMedia('(width < 720px) or (height < 480px)');
/** Of what can be corrected, which the panel has too. */
const ASKING_MS = 30_000;

export class Messages implements Notifier {
  readonly element = h('div', { class: 'messages' });
  readonly #polite = h('div', { role: 'status', 'aria-live': 'polite' });
  readonly #urgent = h('div', { role: 'alert' });
  readonly #chooseFile: () => void;
  /** Whether it says what was opened; a frame of another page has no room for it. */
  sumsUp = true;
  /** What asks for what a file does not say of itself; null: nothing does. */
  question: (() => Promise<HTMLElement>) | null = null;
  /** What was opened last. */
  #opened: OpenedMesh | null = null;
  #summary: HTMLElement | null = null;
  #absent: HTMLElement | null = null;
  #remark: HTMLElement | null = null;
  #refused: HTMLElement | null = null;
  #failed: HTMLElement | null = null;
  #asked: HTMLElement | null = null;
  #chosen: HTMLElement | null = null;
  #blind: HTMLElement | null = null;

  constructor(chooseFile: () => void) {
    this.#chooseFile = chooseFile;
    this.element.append(this.#urgent, this.#polite);
  }

  /** Says what was done; replaces the message about the mesh before, and the last error. */
  opened(title: Words, shown: Shown, state: SceneState): void {
    for (const former of [this.#summary, this.#absent, this.#failed, this.#chosen, this.#remark]) former?.remove();
    this.#opened = shown.opened;
    if (this.sumsUp) this.#sumUp(title, shown, state);
    const { missing, undecoded, warnings } = shown.opened;
    if (missing.length + undecoded.length + warnings.length > 0) void this.#tellAbsent(shown.opened);
  }

  /** What the file was read without. */
  async #tellAbsent(opened: OpenedMesh): Promise<void> {
    const { absentSentence } = await import('./read');
    if (opened !== this.#opened) return;
    this.#absent = this.#say(this.#polite, 'notice', absentSentence(opened), []);
  }

  #sumUp(title: Words, { opened, answer }: Shown, state: SceneState): void {
    const unit = unitOf(state, opened);
    const sentence = openingSentence(title, opened, answer.factoring, unit);
    this.#summary = this.#say(this.#polite, 'summary', sentence, []);
    const said = this.#summary.querySelector('p');
    if (opened.isCloud)
      void import('./read').then(({ cloudSentence }) => said?.append(' ', h('span', {}, cloudSentence(opened))));
    const lines = openingDetails(opened, answer.factoring, unit).map((line) => h('li', {}, line));
    this.#summary.append(h('details', { class: 'more' }, h('summary', {}, t('Details')), h('ul', {}, ...lines)));
    const asks = state.mesh.kind !== 'preset' && state.unit === AUTOMATIC && opened.unitAssumed;
    const question = asks ? this.question : null;
    if (question) this.#ask(this.#summary, question);
    this.#fade(this.#summary, question ? ASKING_MS : SHOWN_MS);
  }

  notice(text: Words, action?: Action): void {
    this.#notice(text, action);
  }

  remark(text: Words, action?: Action): void {
    this.#remark?.remove();
    this.#remark = this.#notice(text, action);
  }

  #notice(text: Words, action?: Action): HTMLElement {
    const former = [...this.#polite.children].find((one) => one.querySelector('p')?.textContent === String(text));
    former?.remove();
    const run = () => {
      message.remove();
      action?.run();
    };
    const message = this.#say(this.#polite, 'notice', text, action ? [{ ...action, run }] : []);
    const notices = this.#polite.querySelectorAll('.notice');
    if (notices.length > MOST_NOTICES) notices[0]?.remove();
    return message;
  }

  refused(values: readonly string[]): void {
    this.#refused?.remove();
    this.#refused = values.length > 0 ? this.#notice(refusedWords(values)) : null;
  }

  choice(shown: string, meshes: readonly string[], open: (mesh: string) => void): void {
    const text = t`Opened ${fileName(shown)}, one of ${meshes.length} meshes.`;
    this.#chosen = this.#say(this.#polite, 'notice', text, []);
    const options = meshes.map((mesh) => h('option', { value: mesh, selected: mesh === shown }, mesh));
    const select = h('select', { 'aria-label': t('Mesh to open'), onchange: () => open(select.value) }, ...options);
    this.#chosen.append(h('div', { class: 'actions' }, select));
  }

  fail(text: Words, details: string, remedy?: Action): void {
    this.#failed?.remove();
    this.#failed = this.#error(text, details, remedy);
  }

  /** Why nothing can be drawn; stays until drawing works again, which null says. */
  blind(reason: Words | null, tryAgain: () => void): void {
    this.#blind?.remove();
    this.#blind = reason
      ? this.#error(
          t`The scene cannot be drawn, but the solver and the numbers still work. ${reason}`,
          navigator.userAgent,
          {
            name: t('Try again'),
            run: tryAgain,
          },
        )
      : null;
  }

  askForFile(name: string): void {
    this.#asked?.remove();
    const action = { name: t('Open the file…'), run: this.#chooseFile };
    this.#asked = this.#say(this.#polite, 'notice', t`This link needs your file ${name}. Drop it here to open it.`, [
      action,
    ]);
  }

  offer(address: string, open: () => void): void {
    this.#asked?.remove();
    const text = t`This link shows ${nameOf(address)} from ${hostOf(address)}. It is fetched from there, ${MOST_FETCHED} at most, once you open it.`;
    this.#asked = this.#say(this.#polite, 'notice', text, [{ name: t('Open'), run: open }]);
  }

  forget(): void {
    this.#asked?.remove();
    this.#asked = null;
  }

  /** Whoever goes on with the model has no answer to what was asked about it; on a small window what was opened is in the way. */
  goOn(isOnModel: boolean): void {
    if (SMALL.matches || (isOnModel && this.#summary?.querySelector('.question'))) this.#summary?.remove();
  }

  /** Escape closes the newest message of those that are seen. */
  closeNewest(): boolean {
    const all = this.element.querySelectorAll<HTMLElement>('.message');
    const newest = [...all].findLast((each) => each.offsetParent !== null);
    newest?.remove();
    return newest !== undefined;
  }

  #error(text: Words, details: string, remedy: Action | undefined): HTMLElement {
    const copying: Action = { name: t('Copy details'), run: () => void copyDetails(message, `${text}\n${details}`) };
    const message = this.#say(this.#urgent, 'error', text, remedy ? [remedy, copying] : [copying]);
    return message;
  }

  #say(place: HTMLElement, kind: string, text: Words, actions: readonly Action[]): HTMLElement {
    const message = h('div', { class: `message ${kind}` }, h('p', {}, text));
    if (actions.length > 0) {
      const buttons = actions.map(({ name, run }) => h('button', { class: 'link', onclick: run }, name));
      message.append(h('div', { class: 'actions' }, ...buttons));
    }
    message.append(
      h(
        'button',
        {
          class: 'close',
          'aria-label': t('Close the message'),
          title: t('Close (Esc)'),
          onclick: () => message.remove(),
        },
        '×',
      ),
    );
    place.append(message);
    return message;
  }

  /** Below what was opened; without a connection the panel has the same. */
  #ask(message: HTMLElement, question: () => Promise<HTMLElement>): void {
    question().then(
      (element) => message.append(element),
      () => undefined,
    );
  }

  /** Waits while the message is under the pointer, has the focus, or shows its details. */
  #fade(message: HTMLElement, time: number): void {
    setTimeout(() => {
      if (message.matches(':hover, :focus-within, :has([open])')) this.#fade(message, time);
      else message.remove();
    }, time);
  }
}

/** Without permission to use the clipboard the details are shown, to be copied by hand. */
async function copyDetails(message: HTMLElement, details: string): Promise<void> {
  if (!(await copy(details)) && !message.querySelector('pre')) message.append(h('pre', {}, details));
}
