// Play button, speed, and the time slider with the phases of the run.

import { speeds } from './clock';
import { fixed, h } from './dom';
import type { PageState } from './page_state';

const icon = (path: string): string =>
  `<svg viewBox="0 0 20 20" width="20" height="20" aria-hidden="true"><path d="${path}" fill="currentColor"/></svg>`;
const playIcon = icon('M6 3.5v13l11-6.5z');
const pauseIcon = icon('M5 3.5h3.6v13H5zM11.4 3.5H15v13h-3.6z');

function segments(state: PageState): HTMLElement[] {
  const { duration } = state.clock;
  return state.phases.map((phase, i) => {
    const segment = h(
      'div',
      {
        class: `segment phase-${i % 6}`,
        title: `${phase.name}: ${fixed(phase.start, 2)} to ${fixed(phase.end, 2)} s`,
      },
      h('span', {}, phase.name),
    );
    segment.style.left = `${(100 * phase.start) / duration}%`;
    segment.style.width = `${(100 * (phase.end - phase.start)) / duration}%`;
    return segment;
  });
}

function marks(state: PageState): HTMLElement[] {
  const { duration } = state.clock;
  const out: HTMLElement[] = [];
  if (state.metricsWindow) {
    const [start, end] = state.metricsWindow;
    const span = h('div', { class: 'span', title: 'Time window of the metrics' });
    span.style.left = `${(100 * start) / duration}%`;
    span.style.width = `${(100 * (end - start)) / duration}%`;
    out.push(span);
  }
  for (const run of state.runs) {
    if (!run.fault) continue;
    const title = `${run.fault.kind}: ${fixed(run.fault.time, 3)} s`;
    const mark = h('div', { class: 'fault-mark', title });
    mark.style.left = `${(100 * run.fault.time) / duration}%`;
    out.push(mark);
  }
  return out;
}

/** Slider over the time of the run. */
function slider(state: PageState): HTMLElement {
  const { clock } = state;
  const head = h('div', { class: 'thumb' });
  const bar = h(
    'div',
    {
      class: 'timeline',
      role: 'slider',
      tabindex: 0,
      'aria-label': 'Time',
      'aria-valuemin': 0,
      'aria-valuemax': fixed(clock.duration, 3),
    },
    h('div', { class: 'track' }, ...segments(state)),
    ...marks(state),
    head,
  );
  const phaseAt = (t: number): string =>
    state.phases.find((phase) => t >= phase.start && t < phase.end)?.name ?? '';
  const show = (): void => {
    head.style.left = `${(100 * clock.time) / clock.duration}%`;
  };
  const updateAria = (): void => {
    bar.setAttribute('aria-valuenow', clock.time.toFixed(3));
    bar.setAttribute('aria-valuetext', `${clock.time.toFixed(3)} s, ${phaseAt(clock.time)}`);
  };
  clock.onTime(show);
  state.onReading(updateAria);
  show();
  updateAria();
  const seek = (event: PointerEvent): void => {
    const bounds = bar.getBoundingClientRect();
    clock.set(((event.clientX - bounds.left) / bounds.width) * clock.duration);
  };
  bar.addEventListener('pointerdown', (event) => {
    bar.setPointerCapture(event.pointerId);
    seek(event);
  });
  bar.addEventListener('pointermove', (event) => {
    if (bar.hasPointerCapture(event.pointerId)) seek(event);
  });
  return bar;
}

export function timeline(state: PageState): HTMLElement {
  const { clock } = state;
  const play = h('button', { type: 'button', class: 'play' });
  play.addEventListener('click', () => clock.toggle());
  const speed = h(
    'select',
    { 'aria-label': 'Speed', class: 'speed' },
    ...speeds.map((s) => h('option', { value: s }, `${s}×`)),
  );
  speed.addEventListener('change', () => clock.setSpeed(Number(speed.value)));
  const now = h('span', { class: 'now' });
  const phase = h('span', { class: 'phase-name' });
  const update = (): void => {
    play.innerHTML = clock.playing ? pauseIcon : playIcon;
    play.setAttribute('aria-label', clock.playing ? 'Pause' : 'Play');
    play.title = clock.playing ? 'Pause (space)' : 'Play (space)';
    speed.value = String(clock.speed);
  };
  const read = (): void => {
    now.textContent = `${clock.time.toFixed(3)} s`;
    const current = state.phases.find((p) => clock.time >= p.start && clock.time < p.end);
    phase.textContent = current?.name ?? '';
  };
  clock.onState(update);
  clock.onTime(read);
  update();
  read();
  const end = h('span', { class: 'end' }, `${clock.duration.toFixed(2)} s`);
  return h(
    'div',
    { class: 'transport', role: 'group', 'aria-label': 'Replay' },
    play,
    h('div', { class: 'clock' }, now, phase),
    slider(state),
    end,
    speed,
  );
}
