/** A very small DOM helper: attributes by name, `on…` for listeners, properties of the element as they are. */
import { entry } from '../state/entry';
import { Phrase, type Words } from '../texts';

type Child = Node | Words | null;
type Attributes = Record<string, Words | number | boolean | ((event: Event) => void)>;

/** What texts and attributes of the page say, where that depends on its language. */
const said = new WeakMap<Node, Phrase>();

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') element.addEventListener(name.replace(/^on/, ''), value);
    else if (typeof value === 'boolean') element.toggleAttribute(name, value);
    else attribute(element, name, value);
  }
  for (const child of children) if (child !== null) element.append(child instanceof Node ? child : textNode(child));
  return element;
}

function textNode(words: Words): Text {
  return keep(document.createTextNode(String(words)), words);
}

function keep<N extends Node>(node: N, words: unknown): N {
  if (words instanceof Phrase) said.set(node, words);
  else said.delete(node);
  return node;
}

/** Gives an attribute a value. */
export function attribute(element: Element, name: string, value: Words | number): void {
  element.setAttribute(name, String(value));
  const node = element.getAttributeNode(name);
  if (node) keep(node, value);
}

/** Has an element say something; the same once more is no change, which a screen reader would read aloud. */
export function say(element: Element, words: Words | null): void {
  const text = String(words ?? '');
  if (element.textContent !== text) element.textContent = text;
  if (element.firstChild) keep(element.firstChild, words);
}

/** Writes what the page says once more, after its language has changed. */
export function sayAgain(): void {
  const walker = document.createTreeWalker(document, NodeFilter.SHOW_TEXT | NodeFilter.SHOW_ELEMENT);
  while (walker.nextNode()) {
    const { currentNode: node } = walker;
    for (const each of node instanceof Element ? node.attributes : [node]) {
      const phrase = said.get(each);
      if (phrase) each.nodeValue = String(phrase);
    }
  }
}

const SVG = 'http://www.w3.org/2000/svg';

/** A 20 × 20 line drawing of one path. */
export function icon(path: string): SVGSVGElement {
  const svg = document.createElementNS(SVG, 'svg');
  svg.setAttribute('viewBox', '0 0 20 20');
  svg.setAttribute('aria-hidden', 'true');
  svg.classList.add('icon');
  const line = document.createElementNS(SVG, 'path');
  line.setAttribute('d', path);
  svg.append(line);
  return svg;
}

/** One of several choices. */
export interface Choice<T> {
  element: HTMLElement;
  show: (value: T) => void;
  /** Which of the choices can be made. A list shows the others too, radio buttons do not. */
  offer: (isOffered: (value: T) => boolean) => void;
}

export function select<T extends string | number>(
  label: Words,
  choices: readonly (readonly [T, Words])[],
  change: (value: T) => void,
): Choice<T> {
  const options = choices.map(([value, text]) => h('option', { value }, text));
  const input = h('select', { onchange: () => change(entry(choices, input.selectedIndex)[0]) }, ...options);
  return {
    element: h('label', { class: 'field' }, h('span', {}, label), input),
    show: (value) => {
      input.value = String(value);
    },
    offer: (isOffered) => {
      choices.forEach(([value], i) => {
        entry(options, i).disabled = !isOffered(value);
      });
    },
  };
}
