/** What is being opened, for the loading bar. */
import type { OpeningStage } from '../protocol';
import { Cancelled } from '../solver/remote';
import type { Signal } from '../state/signal';
import type { Words } from '../texts';

export interface Loading {
  title: Words;
  stage: OpeningStage;
  /** 0 to 1; null where it is not known. */
  fraction: number | null;
  vertices: number;
  /** Fetched so far. */
  bytes?: number;
}

export type LoadingListener = (reached: Omit<Loading, 'title'>) => void;

/** Does a work of which `loading` shows the progress. `signal` is aborted once another work, or null, takes its place there. */
export async function whileLoading<T>(
  loading: Signal<Loading | null>,
  title: Words,
  work: (progress: LoadingListener, signal: AbortSignal) => Promise<T>,
): Promise<T> {
  let mine: Loading = { title, stage: 'Fetching', fraction: 0, vertices: 0 };
  const isMine = () => loading.value === mine;
  const progress: LoadingListener = (reached) => {
    if (!isMine()) return;
    mine = { title, ...reached };
    loading.value = mine;
  };
  loading.value = mine;
  const controller = new AbortController();
  const unwatch = loading.watch(() => {
    if (!isMine()) controller.abort(new Cancelled());
  });
  try {
    return await work(progress, controller.signal);
  } finally {
    unwatch();
    if (isMine()) loading.value = null;
  }
}
