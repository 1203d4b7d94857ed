/** What goes wrong, in a sentence, with its kind. */
export class HeatwalkError extends Error {
  override readonly name = 'HeatwalkError';
  /** The kind in kebab case, such as `no-such-vertex`; docs/npm.md lists them. */
  readonly code: string;

  constructor(message: string, code: string) {
    super(message);
    this.code = code;
  }
}
