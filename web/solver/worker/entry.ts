/** The worker: what the page may call. What is handed back takes its buffers along. */
import { expose } from 'comlink';
import { handedOver } from '../transfer';
import * as answers from './api/answers';
import * as opening from './api/opening';
import * as queries from './api/queries';

const api = { ...opening, ...answers, ...queries };
/**
 * Calls run one after another, none before `start`. A call that fails rejects with a one-sentence message and changes
 * nothing.
 */
export type SolverApi = typeof api;
export type Queries = typeof queries;

const answering =
  (call: (...given: never[]) => unknown) =>
  async (...given: never[]) =>
    handedOver(await call(...given));
expose(Object.fromEntries(Object.entries(api).map(([name, call]) => [name, answering(call)])));
