/** What this browser keeps for the page: a database has one store of objects, each by its `hash`. */
import { toError } from '../error';

const STORE = 'files';

/** One question to the store of a database, which is open no longer than that: another page may erase it. */
export async function askStore<T>(
  name: string,
  mode: IDBTransactionMode,
  ask: (store: IDBObjectStore) => IDBRequest,
): Promise<T> {
  const opening = indexedDB.open(name, 1);
  opening.addEventListener('upgradeneeded', () => opening.result.createObjectStore(STORE, { keyPath: 'hash' }));
  const database = await settled(opening);
  try {
    const transaction = database.transaction(STORE, mode);
    const answer = (await settled(ask(transaction.objectStore(STORE)))) as T;
    await new Promise<void>((resolve, reject) => {
      transaction.addEventListener('complete', () => resolve());
      transaction.addEventListener('abort', () => reject(toError(transaction.error)));
    });
    return answer;
  } finally {
    database.close();
  }
}

function settled<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    request.addEventListener('success', () => resolve(request.result));
    request.addEventListener('error', () => reject(toError(request.error)));
  });
}
