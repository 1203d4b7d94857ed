/** What tests change in the workers of the solver. */
import type { Page, Worker } from '@playwright/test';

/** Runs a script in each of them, before its own. */
export async function runInWorkers(page: Page, script: string): Promise<void> {
  await page.route(/entry.*\.js$/, async (route) => {
    const response = await route.fetch();
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
