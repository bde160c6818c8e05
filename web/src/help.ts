// Dialog that lists keys and gestures, and the listener for keys.

import { h } from './dom';

export type Keys = [string, string][];

export function helpDialog(sections: { title: string; keys: Keys }[]): HTMLDialogElement {
  const close = h('button', { type: 'submit', class: 'button' }, 'Close');
  const lists = sections.map(({ title, keys }) =>
    h(
      'section',
      {},
      h('h3', {}, title),
      h('dl', {}, ...keys.flatMap(([key, what]) => [h('dt', {}, key), h('dd', {}, what)])),
    ),
  );
  const dialog = h(
    'dialog',
    { class: 'help', 'aria-label': 'Keys and mouse' },
    h(
      'form',
      { method: 'dialog' },
      h('header', {}, h('h2', {}, 'Keys and mouse'), close),
      ...lists,
    ),
  );
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}

const typing = 'input:not([type=checkbox]):not([type=range]), select, textarea, dialog';

/** Runs the action of a pressed key, except while the user types in an input or the focused element
 * uses the key itself. */
export function onKeys(actions: (event: KeyboardEvent) => (() => void) | undefined): void {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const target = event.target as HTMLElement;
    if (target.closest(typing)) return;
    if (event.key === ' ' && target.closest('button, summary, label')) return;
    if (target.closest('input[type=range]') && /Arrow|Home|End|Page/.test(event.key)) return;
    const action = actions(event);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
