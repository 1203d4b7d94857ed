/** What is measured when it is asked for: a button that begins and cancels it, how far it is, and what came of it. */
import { sentenceOf } from '../../error';
import { Cancelled } from '../../solver/remote';
import { copy } from '../clipboard';
import { h, say } from '../dom';
import { t, type Words } from '../../texts';

export interface Measuring {
  button: HTMLButtonElement;
  progress: HTMLProgressElement;
  said: HTMLElement;
  cancel: () => void;
}

interface Task {
  label: Words;
  /** Of the steps that progress counts. */
  steps: Words;
  /** Rejects where `signal` is aborted; the sentence that it ends with. */
  measure: (signal: AbortSignal) => Promise<Words>;
  /** However it has ended. */
  ended: () => void;
}

export function measuring({ label, steps, measure, ended }: Task): Measuring {
  let running: AbortController | null = null;
  const button = h('button', { class: 'wide' }, label);
  const progress = h('progress', { value: 0, hidden: true, 'aria-label': steps });
  const said = h('p', { class: 'quiet', role: 'status' });
  const run = async () => {
    running = new AbortController();
    const { signal } = running;
    progress.hidden = false;
    say(said, '');
    say(button, t('Cancel'));
    try {
      say(said, await measure(signal));
    } catch (error) {
      const isCancelled = error instanceof Cancelled || signal.aborted;
      say(said, isCancelled ? t('Cancelled.') : sentenceOf(error));
    } finally {
      running = null;
      say(button, label);
      progress.hidden = true;
      ended();
    }
  };
  button.addEventListener('click', () => {
    if (running) running.abort();
    else void run();
  });
  return { button, progress, said, cancel: () => running?.abort() };
}

/** A section of what is measured, and what it is. */
export function measurement(title: Words, about: Words, ...content: HTMLElement[]): HTMLElement {
  return h(
    'section',
    { class: 'stack measured', 'aria-label': title },
    h('h2', {}, title),
    h('p', { class: 'quiet' }, about),
    ...content,
  );
}

/** A button that puts Markdown on the clipboard. */
export function markdownButton(text: () => string, said: HTMLElement, instead: Words): HTMLElement {
  const give = async () => {
    say(said, (await copy(text())) ? t('Copied.') : instead);
  };
  return h('button', { class: 'small', onclick: () => void give() }, t('Copy as Markdown'));
}
