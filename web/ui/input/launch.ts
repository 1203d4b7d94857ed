/** Files that the system opens with the installed page. */
import type { InputFiles } from '../../session/opener';
import { filesOf } from './files';

/** Not every browser has it; https://wicg.github.io/web-app-launch/ */
interface LaunchQueue {
  setConsumer(consumer: (launched: { files?: readonly FileSystemFileHandle[] }) => void): void;
}

/** Those that came before are opened too. */
export function followLaunches(open: (input: InputFiles) => void): void {
  const { launchQueue } = globalThis as { launchQueue?: LaunchQueue };
  launchQueue?.setConsumer(({ files = [] }) => {
    if (files.length > 0) void openAll(files, open);
  });
}

async function openAll(handles: readonly FileSystemFileHandle[], open: (input: InputFiles) => void): Promise<void> {
  open(filesOf(await Promise.all(handles.map((handle) => handle.getFile()))));
}
