/** Files that the system opens with the installed page. */
import type { Given } from '../../session/opener';
import { givenFiles } from './given';

/** Not every browser has it; https://wicg.github.io/web-app-launch/ */
interface LaunchQueue {
  setConsumer(consumer: (launched: { files?: readonly FileSystemFileHandle[] }) => void): void;
}

/** Those that came before are told too. */
export function followLaunches(open: (given: Given) => void): void {
  const { launchQueue } = globalThis as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files = [] }) => {
    if (files.length > 0) void openAll(files, open);
  });
}

async function openAll(handles: readonly FileSystemFileHandle[], open: (given: Given) => void): Promise<void> {
  open(givenFiles(await Promise.all(handles.map((handle) => handle.getFile()))));
}
