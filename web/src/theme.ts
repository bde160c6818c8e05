// Light and dark theme, and the colours of the style sheet for canvases.

type Theme = 'light' | 'dark';
const listeners = new Set<() => void>();
let cache = new Map<string, string>();

const root = document.documentElement;
const system = matchMedia('(prefers-color-scheme: dark)');

let chosen: Theme | null = null;
export const theme = (): Theme => chosen ?? (system.matches ? 'dark' : 'light');

/** Colour of the style sheet; `name` is the name of the CSS variable without "--". */
export function colour(name: string): string {
  let value = cache.get(name);
  if (value === undefined) {
    value = getComputedStyle(root).getPropertyValue(`--${name}`).trim();
    cache.set(name, value);
  }
  return value;
}

/** Colour with an opacity, 0 to 1, as #rrggbbaa. */
export function faded(name: string, alpha: number): string {
  const byte = Math.round(alpha * 255);
  return `${colour(name)}${byte.toString(16).padStart(2, '0')}`;
}

export function onTheme(listener: () => void): void {
  listeners.add(listener);
}

function changed(): void {
  root.dataset.theme = theme();
  cache = new Map();
  for (const listener of listeners) listener();
}

export function toggleTheme(): void {
  chosen = theme() === 'dark' ? 'light' : 'dark';
  changed();
}

system.addEventListener('change', changed);
changed();

const joints = ['c1', 'c2', 'c3', 'c4', 'c5', 'c6', 'c7'];
/** Colour and dashes for the curve number `index`: seven colours, then the same with dashes. */
export const categorical = (index: number): { colour: string; dash: number[] } => ({
  colour: joints[index % joints.length]!,
  dash: [[], [6, 3], [2, 2], [8, 3, 2, 3], [1, 4]][Math.floor(index / joints.length) % 5]!,
});
/** Colour name of run number `index` in a comparison. */
export const runColour = (index: number): string => categorical(index).colour;
