/** What is done to the scene by hand in one go, by keys or by a drag: each is one step of undo. */

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Where the arrow on a key points, right and down. */
export function arrowOf({ key }: KeyboardEvent): readonly [number, number] | undefined {
  return ARROWS[key];
}

export function hasModifier({ ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return ctrlKey || metaKey || altKey;
}

/** The gesture of the key that is down on an element: the same one for keys in a row, until one is let go. */
export function keyGesture(element: EventTarget): () => object {
  let gesture: object | null = null;
  element.addEventListener('keyup', () => (gesture = null));
  return () => (gesture ??= {});
}

interface Dragging<D> {
  /** What the drag is about; null where there is nothing to drag. */
  begin: (event: PointerEvent) => D | null;
  move: (event: PointerEvent, drag: D) => void;
  end?: (event: PointerEvent, drag: D) => void;
}

/** Follows the pointer that goes down on an element wherever it moves, until it is let go. */
export function draggable<D>(element: HTMLElement, { begin, move, end }: Dragging<D>): void {
  let drag: D | null = null;
  element.addEventListener('pointerdown', (event) => {
    drag = begin(event);
    if (drag) element.setPointerCapture(event.pointerId);
  });
  element.addEventListener('pointermove', (event) => {
    if (drag) move(event, drag);
  });
  for (const ending of ['pointerup', 'pointercancel'] as const) {
    element.addEventListener(ending, (event) => {
      if (drag) end?.(event, drag);
      drag = null;
    });
  }
}
