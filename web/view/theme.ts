/** Light and dark as the system asks; the stylesheet does the rest. */
import type { View } from './view';

/** Lighter than the model's shadow side, so that both white and black stripes stand out. */
const LIGHT = { top: '#eef1f3', bottom: '#c9d1d6' };
const DARK = { top: '#4b535a', bottom: '#2b3136' };

export function followTheme(view: View): void {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const apply = () => {
    const { top, bottom } = dark.matches ? DARK : LIGHT;
    view.setBackground(top, bottom);
  };
  dark.addEventListener('change', apply);
  apply();
}
