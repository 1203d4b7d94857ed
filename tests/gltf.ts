/** What the validator of Khronos says of files that are written. */
import { createRequire } from 'node:module';

interface Issue {
  code: string;
  message: string;
  severity: number;
  pointer?: string;
}
interface Validator {
  validateBytes(bytes: Uint8Array): Promise<{ issues: { messages: Issue[] } }>;
}

const validator = createRequire(import.meta.url)('gltf-validator') as Validator;
/** Of severities, those that are no hints: errors and warnings. */
const LEAST = 1;

/** A line for each error and warning. */
export async function complaints(glb: Uint8Array): Promise<string[]> {
  const { issues } = await validator.validateBytes(new Uint8Array(glb));
  return issues.messages
    .filter(({ severity }) => severity <= LEAST)
    .map(({ code, message, pointer }) => `${code} ${pointer ?? ''} ${message}`);
}
