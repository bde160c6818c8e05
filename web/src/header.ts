// Head of the page: title, outcome, metrics, facts of the run, and the command that repeats it.

import { copyButton, format, h, readable } from './dom';
import { type Metric, type Page, type Run } from './data';
import { runColour, toggleTheme } from './theme';

/** First line of the page: title and buttons. */
export function pageBar(
  title: (Node | string | false)[],
  actions: HTMLElement[],
  help: HTMLDialogElement,
): HTMLElement {
  const toggle = h(
    'button',
    {
      type: 'button',
      class: 'button icon',
      'aria-label': 'Light or dark',
      title: 'Light or dark (T)',
    },
    '◐',
  );
  toggle.addEventListener('click', toggleTheme);
  const ask = h(
    'button',
    {
      type: 'button',
      class: 'button icon',
      'aria-label': 'Keys and mouse',
      title: 'Keys and mouse (?)',
    },
    '?',
  );
  ask.addEventListener('click', () => help.showModal());
  const logo = h('span', { class: 'logo', 'aria-hidden': 'true' });
  return h(
    'div',
    { class: 'bar' },
    h('div', { class: 'title' }, logo, ...title),
    h('div', { class: 'actions' }, ...actions, toggle, ask),
  );
}

export function dateOf(text: string): string {
  const date = new Date(text);
  if (Number.isNaN(date.getTime())) return text;
  return `${text.slice(0, 10)}, ${text.slice(11, 16)} UTC`;
}

export const runMark = (index: number): HTMLElement => {
  const mark = h('span', { class: 'run-mark', 'aria-hidden': 'true' });
  mark.style.background = `var(--${runColour(index)})`;
  return mark;
};

function badge(run: Run): HTMLElement {
  const well = run.plan ? 'converged' : 'succeeded';
  const [kind, text] = run.fault
    ? ['bad', 'fault']
    : run.succeeded
      ? ['good', run.outcome.includes('cut short: ') ? `${well}, cut short` : well]
      : ['bad', `not ${well}`];
  const sign = kind === 'good' ? '✓' : '✕';
  return h('span', { class: `badge ${kind}` }, `${sign} ${text}`);
}

function facts(run: Run): HTMLElement {
  const all: [string, string][] = [...run.facts];
  const has = (name: string): boolean => all.some(([key]) => key === name);
  if (!has('version')) all.push(['version', run.version]);
  if (!has('date')) all.push(['date', dateOf(run.created)]);
  return h(
    'dl',
    { class: 'facts' },
    ...all.map(([key, value]) => h('div', {}, h('dt', {}, key), h('dd', {}, value))),
  );
}

function faultBanner(run: Run, seek: (time: number) => void): HTMLElement | null {
  if (!run.fault) return null;
  const { kind, time, text } = run.fault;
  const go = h('button', { type: 'button', class: 'button' }, `Go to ${format(time)} s`);
  go.addEventListener('click', () => seek(time));
  return h(
    'div',
    { class: 'fault', role: 'alert' },
    h('p', {}, h('strong', {}, kind), ` in ${run.name} at ${format(time)} s. ${text}`),
    go,
  );
}

/** Metrics for the tiles at the top. A run with fewer than three of them shows its first metrics. */
const preferred = [
  'force_rmse',
  'force_peak',
  'position_rmse',
  'impact_peak',
  'without_contact',
  'solver.p99',
];

/** Values of one metric for all runs, in a common unit. */
function figures(runs: Run[], metric: Metric): { values: (number | null)[]; unit: string } {
  const values = runs.map((run) => run.metrics.find((m) => m.name === metric.name)?.value ?? null);
  const { factor, unit } = readable(metric.unit, Math.max(...values.map((v) => Math.abs(v ?? 0))));
  return { values: values.map((v) => (v === null ? null : v * factor)), unit };
}

export function tiles(runs: Run[]): HTMLElement {
  const all = runs[0]!.metrics;
  const present = preferred.flatMap((name) => all.filter((metric) => metric.name === name));
  const chosen = (present.length >= 3 ? present : all).slice(0, 6);
  const tile = (metric: Metric): HTMLElement => {
    const { values, unit } = figures(runs, metric);
    const lines = values.map((value, i) =>
      h(
        'span',
        { class: 'figure' },
        runs.length > 1 && runMark(i),
        value === null ? '–' : `${format(value, 3)} ${unit}`,
      ),
    );
    const label = h('span', { class: 'label' }, metric.label);
    return h('div', { class: 'tile', title: metric.text }, label, ...lines);
  };
  return h('div', { class: 'tiles' }, ...chosen.map(tile));
}

function metricsTable(runs: Run[]): HTMLElement {
  const names = new Map<string, Metric>();
  for (const run of runs) for (const metric of run.metrics) names.set(metric.name, metric);
  const heads = runs.map((run, i) =>
    h(
      'th',
      { scope: 'col', class: 'number' },
      runs.length > 1 && runMark(i),
      runs.length > 1 ? run.name : 'value',
    ),
  );
  const rows = [...names.values()].map((metric) => {
    const { values, unit } = figures(runs, metric);
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, metric.label),
      ...values.map((value) => h('td', { class: 'number' }, format(value))),
      h('td', { class: 'unit' }, unit),
      h('td', { class: 'meaning' }, metric.text),
    );
  });
  return h(
    'div',
    { class: 'scroll-x' },
    h(
      'table',
      { class: 'metrics' },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, 'metric'),
          ...heads,
          h('th', { scope: 'col' }, 'unit'),
          h('th', { scope: 'col', class: 'meaning' }, 'meaning'),
        ),
      ),
      h('tbody', {}, ...rows),
    ),
  );
}

function factsTable(runs: Run[]): HTMLElement {
  const keys = [...new Set(runs.flatMap((run) => run.facts.map(([key]) => key)))];
  const value = (run: Run, key: string): string => run.facts.find(([k]) => k === key)?.[1] ?? '–';
  const row = (name: string, cells: (Node | string)[]): HTMLElement =>
    h('tr', {}, h('th', { scope: 'row' }, name), ...cells.map((cell) => h('td', {}, cell)));
  return h(
    'div',
    { class: 'scroll-x' },
    h(
      'table',
      { class: 'metrics facts-table' },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          h('th', { scope: 'col' }, 'run'),
          ...runs.map((run, i) => h('th', { scope: 'col' }, runMark(i), run.name)),
        ),
      ),
      h(
        'tbody',
        {},
        row(
          'outcome',
          runs.map((run) => h('span', {}, badge(run), ` ${run.outcome}`)),
        ),
        ...keys.map((key) =>
          row(
            key,
            runs.map((run) => value(run, key)),
          ),
        ),
        row(
          'version',
          runs.map((run) => run.version),
        ),
        row(
          'date',
          runs.map((run) => dateOf(run.created)),
        ),
        row(
          'run again',
          runs.map((run) => copyButton('Copy command', () => run.command, run.command)),
        ),
      ),
    ),
  );
}

/** A button, and the panel that it opens below the head. */
function drawer(label: string, content: HTMLElement, open = false): [HTMLElement, HTMLElement] {
  const id = `drawer-${label.toLowerCase().replace(/\W+/g, '-')}`;
  const body = h('div', { class: 'drawer', id, hidden: !open }, content);
  const button = h(
    'button',
    { type: 'button', class: 'button', 'aria-expanded': String(open), 'aria-controls': id },
    label,
  );
  button.addEventListener('click', () => {
    body.hidden = !body.hidden;
    button.setAttribute('aria-expanded', String(!body.hidden));
  });
  return [button, body];
}

function taskFiles(runs: Run[]): HTMLElement {
  return h(
    'div',
    {},
    ...runs.flatMap((run, i) =>
      [
        runs.length > 1 && h('h3', {}, runMark(i), run.name),
        h('pre', { class: 'task', tabindex: 0 }, run.task_file),
      ].filter((part) => part !== false),
    ),
  );
}

export function runHeader(
  page: Page,
  help: HTMLDialogElement,
  seek: (time: number) => void,
): HTMLElement {
  const { runs } = page;
  const many = runs.length > 1;
  const run = runs[0]!;
  const drawers = [
    ...(many ? [drawer('Runs', factsTable(runs))] : []),
    drawer('Metrics', metricsTable(runs)),
    drawer(many ? 'Task files' : 'Task file', taskFiles(runs)),
  ];
  const actions: HTMLElement[] = drawers.map(([button]) => button);
  if (!many) actions.push(copyButton('Copy command', () => run.command, run.command));
  const title = many
    ? [h('h1', {}, `${runs.length} runs compared`)]
    : [h('h1', {}, page.title), badge(run), h('span', { class: 'outcome' }, run.outcome)];
  const names = h(
    'p',
    { class: 'names' },
    ...runs.map((r, i) => h('span', {}, runMark(i), r.name, badge(r))),
  );
  return h(
    'header',
    { class: 'head' },
    pageBar(title, actions, help),
    many ? names : facts(run),
    ...runs.map((r) => faultBanner(r, seek)),
    ...drawers.map(([, body]) => body),
  );
}
