declare const WORKER: string;

/** The text of the worker. */
export default WORKER;
