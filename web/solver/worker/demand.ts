/** What loads a thing when it is first asked for, and keeps it; after a failure the next one to ask tries again. */
export function onDemand<T>(load: () => Promise<T>): () => Promise<T> {
  let loading: Promise<T> | undefined;
  return () => {
    loading ??= load().catch((error: unknown) => {
      loading = undefined;
      throw error;
    });
    return loading;
  };
}

/** A wasm module that is loaded when it is first asked for. */
export function moduleOnDemand<M extends { default: (options: { module_or_path: string }) => Promise<unknown> }>(
  load: () => Promise<M>,
  address: string,
): () => Promise<M> {
  return onDemand(async () => {
    const module = await load();
    await module.default({ module_or_path: address });
    return module;
  });
}

/** Uses a module in an instance of its own: memory of the last one goes back, and a trap ends nothing else. */
export async function inFreshInstance<M extends { __wbg_reset_state: () => void }, T>(
  loaded: () => Promise<M>,
  use: (module: M) => T | Promise<T>,
): Promise<T> {
  const module = await loaded();
  const { __wbg_reset_state: renew } = module;
  try {
    return await use(module);
  } finally {
    renew();
  }
}
