/** What tests change in the workers of the solver. */
import type { Page, Worker } from '@playwright/test';

/** Runs a script in each of them, before its own. */
export async function runInWorkers(page: Page, script: string): Promise<void> {
  await page.route(/entry.*\.js$/, async (route) => {
    // The server may close a connection that was idle in the moment in which it is used again.
    const response = await route.fetch({ maxRetries: 3 });
    await route.fulfill({ response, body: script + (await response.text()) });
  });
}

/** The first that prints a text to the console from now on. */
export function workerThatPrints(page: Page, text: string): Promise<Worker> {
  return new Promise((resolve) => {
    page.on('console', (message) => {
      const worker = message.worker();
      if (worker && message.text() === text) resolve(worker);
    });
  });
}
