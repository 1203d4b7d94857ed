/** A virtual screen. */
import { type ChildProcess, spawn } from 'node:child_process';

/** What is drawn there is drawn by the processor. */
export interface Screen {
  environment: NodeJS.ProcessEnv;
  display: ChildProcess;
}

/** One that has room for a window with such a page in it; it chooses a number that is free. */
export async function startScreen(width: number, height: number): Promise<Screen> {
  const screen = `${width + 100}x${height + 200}x24`;
  const display = spawn('Xvfb', ['-displayfd', '1', '-screen', '0', screen, '-nolisten', 'tcp'], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const number = await new Promise<string>((resolve, reject) => {
    display.on('error', reject);
    display.on('exit', () => reject(new Error('The virtual screen could not be started.')));
    display.stdout.once('data', (told: Buffer) => resolve(told.toString().trim()));
  });
  return { environment: { ...process.env, DISPLAY: `:${number}`, LIBGL_ALWAYS_SOFTWARE: '1' }, display };
}
