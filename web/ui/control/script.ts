/** The part of `window.heatwalk` that changes the page. Fetched when it is asked for first. */
import type { Command } from '../commands';
import type { Heatwalk, Script } from '../scripting';
import { Actions, type ActionsOptions } from './actions';
import { openable, optionsOf, shown, sourcesOf, isObject, tapesOf, walkerOf } from './arguments';

export interface ScriptOptions extends ActionsOptions {
  commands: readonly Command[];
}

export function scriptOf({ commands, ...options }: ScriptOptions, api: Heatwalk): Script {
  const actions = new Actions(options, api);
  const told = () => commands.map(({ name, keys }) => ({ name: String(name), keys }));
  return {
    async open(given) {
      if (!isObject(given)) throw new Error(`open takes an object, not ${shown(given)}: { preset: 'torus' }.`);
      return actions.open(openable(given));
    },
    set: async (given) => actions.set(optionsOf(given)),
    setSources: async (given) => actions.setSources(sourcesOf(given)),
    setWalker: async (given) => actions.setWalker(walkerOf(given)),
    setTapes: async (given) => actions.setTapes(tapesOf(given)),
    distances: () => actions.distances(),
    path: () => actions.path(),
    state: async () => actions.state(),
    commands: async () => told(),
    async run(given) {
      const wanted = String(given).toLowerCase();
      const found = commands.find(({ name, keys }) => keys.includes(wanted) || String(name).toLowerCase() === wanted);
      if (!found) {
        const names = told().map(({ name, keys }) => (keys[0] ? `${name} (${keys[0]})` : name));
        throw new Error(`There is no command ${shown(given)}; there are ${names.join(', ')}.`);
      }
      found.run({});
    },
  };
}
