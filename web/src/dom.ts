// Helpers for HTML elements, formatted numbers and the clipboard.

type Child = Node | string | null | undefined | false;
interface Props {
  class?: string;
  title?: string;
  id?: string;
  on?: Record<string, (event: never) => void>;
  [attribute: string]: unknown;
}

/** Makes an element with attributes, listeners (`on`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(props)) {
    if (key === 'on')
      for (const [name, listener] of Object.entries(props.on!))
        element.addEventListener(name, listener as EventListener);
    else if (value === true) element.setAttribute(key, '');
    else if (value !== false && value !== undefined && value !== null)
      element.setAttribute(key, String(value));
  }
  for (const child of children) if (child) element.append(child);
  return element;
}

/** Formats a number with `digits` significant digits; a dash for a missing or infinite value. */
export function format(value: number | null | undefined, digits = 4): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-4)
    return value.toExponential(Math.max(digits - 2, 0)).replace(/-/g, '−');
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  return value.toFixed(Math.min(decimals, 6)).replace('-', '−');
}

/** Formats a number with a fixed number of decimals, so that a changing value does not jump. */
export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return '–';
  const text = value.toFixed(decimals);
  return /[1-9]/.test(text) ? text.replace('-', '−') : text.replace('-', '');
}

/** Display unit, and the factor from `unit` to it: mm and ms for lengths and times below 1. */
export function readable(unit: string, largest: number): { factor: number; unit: string } {
  if (unit === 'm' && largest < 1) return { factor: 1e3, unit: 'mm' };
  if (unit === 's' && largest < 1) return { factor: 1e3, unit: 'ms' };
  if (unit === 'Nm') return { factor: 1, unit: 'N m' };
  if (unit === 'deg') return { factor: 1, unit: '°' };
  return { factor: 1, unit: unit === '1' || unit === '-' ? '' : unit };
}

export const reducedMotion = (): boolean => matchMedia('(prefers-reduced-motion: reduce)').matches;

/** Copies text to the clipboard; false if the browser refuses. */
export async function copyText(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const area = h('textarea', { class: 'offscreen' });
    area.value = text;
    document.body.append(area);
    area.select();
    const copied = document.execCommand('copy');
    area.remove();
    return copied;
  }
}

/** A button that copies a text and confirms it. */
export function copyButton(label: string, text: () => string, title = ''): HTMLButtonElement {
  const button = h('button', { type: 'button', class: 'button', title }, label);
  button.addEventListener('click', async () => {
    button.textContent = (await copyText(text())) ? 'Copied' : 'Could not copy';
    setTimeout(() => (button.textContent = label), 1600);
  });
  return button;
}
