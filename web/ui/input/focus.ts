/** What has the focus and is removed, hidden or disabled leaves it to its section, else to the model: on the page itself no key means anything. */

export function keepFocus(stage: HTMLElement): void {
  let last: HTMLElement | null = null;
  let section: HTMLElement | null = null;
  addEventListener('focusin', ({ target }) => {
    last = target instanceof HTMLElement ? target : null;
    section = last?.closest('details')?.querySelector('summary') ?? null;
  });
  new MutationObserver((changes) => {
    const { activeElement } = document;
    if (!last || (activeElement !== document.body && activeElement !== last)) return;
    // Where nothing has become of it, no layout is asked for.
    const isTouched = changes.some(({ target, removedNodes }) =>
      [target, ...removedNodes].some((node) => node.contains(last)),
    );
    if (!isTouched || canHold(last)) return;
    const next = section && canHold(section) ? section : stage;
    next.focus({ preventScroll: true });
  }).observe(document.body, {
    childList: true,
    subtree: true,
    attributes: true,
    attributeFilter: ['disabled', 'hidden'],
  });
}

function canHold(element: HTMLElement): boolean {
  return element.getClientRects().length > 0 && !element.matches(':disabled');
}
