// Plot over time (uPlot) that follows the time cursor and time window; its legend shows values.

import uPlot from 'uplot';
import { rowAt } from './data';
import { fixed, format, h } from './dom';
import { spanOf } from './plot_span';
import { colour, faded, onTheme } from './theme';
import type { PageState } from './page_state';

type Values = ArrayLike<number>;

export interface Curve {
  label: string;
  colour: string;
  time: Values;
  values: Values;
  dash?: number[];
  width?: number;
  /** Smallest and largest sample between two rows, drawn as a band */
  band?: { min: Values; max: Values };
  hidden?: boolean;
  stepped?: boolean;
  /** Draws points instead of a line */
  points?: boolean;
  fill?: boolean;
  decimals: number;
  unit: string;
  /** Position in the legend; curves with equal ranks keep their drawing order */
  rank?: number;
}

export interface Level {
  value: number;
  label: string;
  colour: string;
}

export interface PlotSpec {
  id: string;
  title: string;
  /** Meaning of the plotted quantity: acting body, body acted on, frame */
  about: string;
  axis: string;
  curves: Curve[];
  levels?: Level[];
  /** Fixed range of the vertical axis; the button "Fit" switches to the range of the curves */
  range?: [number, number];
  log?: boolean;
  height: number;
}

/** Replaces NaN, and nonpositive values on a log scale, by null, which uPlot draws as a gap. */
function gapped(values: Values, log: boolean): ArrayLike<number | null> {
  for (let i = 0; i < values.length; ++i)
    if (Number.isNaN(values[i]) || (log && !(values[i]! > 0)))
      return Array.from(values, (v) => (Number.isNaN(v) || (log && !(v > 0)) ? null : v));
  return values;
}

interface Drawn {
  curve: Curve;
  /** Indices of the series in uPlot: the curve, then the edges of its band */
  series: number[];
}

export class TimePlot {
  readonly element: HTMLElement;
  private plot: uPlot | null = null;
  private drawn: Drawn[] = [];
  private readings: HTMLElement[] = [];
  private readonly hidden = new Set<string>();
  private readonly box = h('div', { class: 'plot-box' });
  private readonly legend = h('div', { class: 'legend' });
  private readonly playhead = h('div', { class: 'playhead' });
  private readonly hoverline = h('div', { class: 'hoverline' });
  private readonly fit = h('button', { type: 'button', class: 'chip fit' }, 'Fit');
  private fitted = false;
  private visible = true;
  private stale = false;

  constructor(
    private spec: PlotSpec,
    private readonly state: PageState,
    extra?: HTMLElement,
  ) {
    const heading = h('h3', { id: `plot-${spec.id}` }, spec.title);
    const about = h('p', { class: 'about' }, spec.about);
    this.element = h(
      'section',
      { class: 'plot', 'aria-labelledby': heading.id, 'data-plot': spec.id },
      h('header', {}, h('div', {}, heading, about), extra, this.fit),
      this.legend,
      this.box,
    );
    this.fit.addEventListener('click', () => {
      this.fitted = !this.fitted;
      this.fit.setAttribute('aria-pressed', String(this.fitted));
      this.rescale();
    });
    for (const curve of spec.curves) if (curve.hidden) this.hidden.add(curve.label);
    this.build();
    state.window.onChange(() => this.rescale());
    state.clock.onTime(() => this.movePlayhead());
    state.onHover(() => this.movePlayhead());
    state.onReading(() => this.read());
    onTheme(() => {
      this.plot?.redraw();
      this.paintLegend();
    });
    new ResizeObserver(() => this.resize()).observe(this.box);
    new IntersectionObserver(
      (entries) => {
        this.visible = entries.some((entry) => entry.isIntersecting);
        if (!this.visible) return;
        if (this.stale) this.rescale();
        this.movePlayhead();
        this.read();
      },
      { rootMargin: '200px' },
    ).observe(this.element);
  }

  /** Replaces the curves of the plot. */
  setSpec(spec: PlotSpec): void {
    this.spec = spec;
    this.element.querySelector('.about')!.textContent = spec.about;
    this.hidden.clear();
    for (const curve of spec.curves) if (curve.hidden) this.hidden.add(curve.label);
    this.build();
    this.resize();
  }

  private resize(): void {
    const width = this.box.clientWidth;
    if (this.plot && width > 0 && width !== this.plot.width) {
      this.plot.setSize({ width, height: this.spec.height });
      this.movePlayhead();
    }
  }

  private build(): void {
    const { spec, state } = this;
    this.fit.hidden = spec.range === undefined;
    const width = Math.max(this.box.clientWidth, 200);
    const [data, series, bands] = this.series();
    const axis = {
      stroke: () => colour('muted'),
      grid: { stroke: () => colour('grid'), width: 1 },
      ticks: { show: false },
      font: '11px system-ui, sans-serif',
      labelFont: '11px system-ui, sans-serif',
      labelSize: 16,
    };
    const options: uPlot.Options = {
      width,
      height: spec.height,
      legend: { show: false },
      padding: [8, 10, 0, 0],
      cursor: { x: false, y: false, points: { show: false }, drag: { x: true, setScale: false } },
      scales: {
        x: { time: false, range: () => [state.window.min, state.window.max] },
        y: spec.log ? { distr: 3 } : { range: (_u, min, max) => this.range(min, max) },
      },
      axes: [
        { ...axis, label: 'time [s]', size: 26, gap: 4, space: 56 },
        { ...axis, label: spec.axis, size: 44, gap: 4, space: 30, values: ticks(spec.log) },
      ],
      series,
      bands,
      hooks: {
        drawClear: [(u) => this.drawBackground(u)],
        draw: [(u) => this.drawLevels(u)],
        setSelect: [(u) => this.select(u)],
      },
    };
    this.plot?.destroy();
    this.plot = new uPlot(options, data, this.box);
    this.plot.over.append(this.hoverline, this.playhead);
    this.listen(this.plot);
    this.fillLegend();
    this.movePlayhead();
    this.read();
  }

  private series(): [uPlot.AlignedData, uPlot.Series[], uPlot.Band[]] {
    const { spec } = this;
    const series: uPlot.Series[] = [{}];
    const bands: uPlot.Band[] = [];
    const tables: { time: Values; columns: ArrayLike<number | null>[]; index: number[] }[] = [];
    this.drawn = [];
    const add = (curve: Curve, values: Values, options: uPlot.Series): number => {
      let table = tables.find((t) => t.time === curve.time);
      if (!table) tables.push((table = { time: curve.time, columns: [], index: [] }));
      table.columns.push(gapped(values, spec.log === true));
      table.index.push(series.length);
      series.push({ points: { show: false }, ...options, show: !this.hidden.has(curve.label) });
      return series.length - 1;
    };
    for (const curve of spec.curves) {
      const own: number[] = [];
      if (curve.band) {
        const high = add(curve, curve.band.max, { stroke: 'transparent', width: 0 });
        const low = add(curve, curve.band.min, { stroke: 'transparent', width: 0 });
        bands.push({ series: [high, low], fill: () => faded(curve.colour, 0.28) });
        own.push(high, low);
      }
      const line: uPlot.Series = {
        stroke: () => colour(curve.colour),
        width: curve.width ?? 1.5,
        ...(curve.dash && curve.dash.length > 0 ? { dash: curve.dash } : {}),
        ...(curve.stepped ? { paths: uPlot.paths.stepped!({ align: 1 }) } : {}),
        ...(curve.fill ? { fill: () => faded(curve.colour, 0.22) } : {}),
      };
      if (curve.points) {
        line.paths = () => null;
        line.points = { show: true, size: 6, fill: () => colour(curve.colour) };
      }
      own.unshift(add(curve, curve.values, line));
      this.drawn.push({ curve, series: own });
    }
    return [joined(tables, series.length), series, bands];
  }

  private range(min: number | null, max: number | null): [number, number] {
    const { spec } = this;
    if (spec.range && !this.fitted) return spec.range;
    if (min === null || max === null) return spec.range ?? [0, 1];
    return spanOf(min, max, spec.curves[0]?.unit ?? '');
  }

  private drawBackground(u: uPlot): void {
    const { ctx, bbox } = u;
    const at = (t: number): number =>
      Math.min(Math.max(u.valToPos(t, 'x', true), bbox.left), bbox.left + bbox.width);
    ctx.save();
    const span = this.state.metricsWindow;
    if (span) {
      ctx.fillStyle = colour('window');
      ctx.fillRect(at(span[0]), bbox.top, at(span[1]) - at(span[0]), bbox.height);
    }
    ctx.strokeStyle = colour('boundary');
    ctx.lineWidth = devicePixelRatio;
    ctx.beginPath();
    for (const phase of this.state.phases.slice(1)) {
      const x = Math.round(u.valToPos(phase.start, 'x', true));
      if (x < bbox.left || x > bbox.left + bbox.width) continue;
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
    }
    ctx.stroke();
    ctx.restore();
  }

  private drawLevels(u: uPlot): void {
    const { ctx, bbox } = u;
    ctx.save();
    ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.lineJoin = 'round';
    ctx.textAlign = 'right';
    for (const level of this.spec.levels ?? []) {
      const y = u.valToPos(level.value, 'y', true);
      if (!(y >= bbox.top - 1 && y <= bbox.top + bbox.height + 1)) continue;
      ctx.strokeStyle = ctx.fillStyle = colour(level.colour);
      ctx.lineWidth = 1.5 * devicePixelRatio;
      ctx.setLineDash([5 * devicePixelRatio, 4 * devicePixelRatio]);
      ctx.beginPath();
      ctx.moveTo(bbox.left, y);
      ctx.lineTo(bbox.left + bbox.width, y);
      ctx.stroke();
      const below = y < bbox.top + 16 * devicePixelRatio;
      ctx.textBaseline = below ? 'top' : 'bottom';
      const offset = (below ? 3 : -3) * devicePixelRatio;
      const x = bbox.left + bbox.width - 4 * devicePixelRatio;
      ctx.setLineDash([]);
      ctx.strokeStyle = colour('card');
      ctx.lineWidth = 4 * devicePixelRatio;
      ctx.strokeText(level.label, x, y + offset);
      ctx.fillText(level.label, x, y + offset);
    }
    ctx.restore();
  }

  private select(u: uPlot): void {
    const { left, width } = u.select;
    if (width > 4) this.state.window.set(u.posToVal(left, 'x'), u.posToVal(left + width, 'x'));
    u.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  private listen(u: uPlot): void {
    const { clock, window } = this.state;
    const timeOf = (event: MouseEvent): number =>
      u.posToVal(event.clientX - u.over.getBoundingClientRect().left, 'x');
    let down = 0;
    u.over.addEventListener('mousedown', (event) => (down = event.clientX));
    u.over.addEventListener('click', (event) => {
      if (Math.abs(event.clientX - down) < 4) clock.set(timeOf(event));
    });
    u.over.addEventListener('mousemove', (event) => this.state.hover(timeOf(event)));
    u.over.addEventListener('mouseleave', () => this.state.hover(null));
    u.over.addEventListener('dblclick', () => window.reset());
    u.over.addEventListener('touchmove', (event) => this.touch(event, timeOf), { passive: true });
    u.over.addEventListener(
      'wheel',
      (event) => {
        if (event.ctrlKey || event.metaKey)
          window.zoom(Math.exp(event.deltaY * 4e-3), timeOf(event));
        else if (event.shiftKey || Math.abs(event.deltaX) > 2 * Math.abs(event.deltaY))
          window.pan(
            ((event.deltaX || event.deltaY) / u.over.clientWidth) * (window.max - window.min),
          );
        else return;
        event.preventDefault();
      },
      { passive: false },
    );
  }

  private touch(event: TouchEvent, timeOf: (event: MouseEvent) => number): void {
    if (event.touches.length !== 1) return;
    this.state.clock.set(timeOf(event.touches[0]! as unknown as MouseEvent));
  }

  private rescale(): void {
    this.stale = !this.visible;
    if (this.stale || !this.plot) return;
    const { min, max } = this.state.window;
    this.plot.setScale('x', { min, max });
    this.movePlayhead();
  }

  private movePlayhead(): void {
    if (!this.plot || !this.visible) return;
    const width = this.plot.over.clientWidth;
    const move = (line: HTMLElement, t: number | null): void => {
      const x = t === null ? -1 : this.plot!.valToPos(t, 'x');
      const shown = x >= -0.5 && x <= width + 0.5;
      line.style.display = shown ? '' : 'none';
      if (shown) line.style.transform = `translateX(${x.toFixed(1)}px)`;
    };
    move(this.playhead, this.state.clock.time);
    move(this.hoverline, this.state.hovered);
  }

  private fillLegend(): void {
    this.legend.replaceChildren();
    this.readings = [];
    this.drawn.sort((a, b) => (a.curve.rank ?? 0) - (b.curve.rank ?? 0));
    for (const { curve, series } of this.drawn) {
      const reading = h('span', { class: 'reading' });
      this.readings.push(reading);
      const swatch = h('span', { class: 'swatch' });
      const button = h(
        'button',
        { type: 'button', class: 'key', 'aria-pressed': String(!this.hidden.has(curve.label)) },
        swatch,
        h('span', {}, curve.label),
        reading,
      );
      button.addEventListener('click', () => {
        const show = this.hidden.has(curve.label);
        if (show) this.hidden.delete(curve.label);
        else this.hidden.add(curve.label);
        button.setAttribute('aria-pressed', String(show));
        this.plot?.batch(() => series.forEach((i) => this.plot!.setSeries(i, { show })));
      });
      this.legend.append(button);
    }
    this.paintLegend();
  }

  private paintLegend(): void {
    this.legend.querySelectorAll<HTMLElement>('.swatch').forEach((swatch, i) => {
      const { curve } = this.drawn[i]!;
      const style = curve.points ? 'dotted' : (curve.dash ?? []).length > 0 ? 'dashed' : 'solid';
      swatch.style.borderTop = `3px ${style} ${colour(curve.colour)}`;
    });
  }

  /** Shows values at the pointer, or at the time cursor without a pointer. */
  private read(): void {
    if (!this.visible) return;
    const t = this.state.hovered ?? this.state.clock.time;
    this.drawn.forEach(({ curve }, i) => {
      const value = curve.values[rowAt(curve.time, t)] ?? NaN;
      const written = this.spec.log ? format(value, 3) : fixed(value, curve.decimals);
      const text = curve.points ? '' : `${written} ${curve.unit}`;
      if (this.readings[i]!.textContent !== text) this.readings[i]!.textContent = text;
    });
  }
}

/** Joins series with different times on one time base; uPlot skips missing values. */
function joined(
  tables: { time: Values; columns: ArrayLike<number | null>[]; index: number[] }[],
  count: number,
): uPlot.AlignedData {
  const out: unknown[] = new Array(count);
  if (tables.length === 1) {
    out[0] = tables[0]!.time;
    tables[0]!.columns.forEach((values, i) => (out[tables[0]!.index[i]!] = values));
    return out as uPlot.AlignedData;
  }
  const all = uPlot.join(tables.map((t) => [t.time, ...t.columns] as unknown as uPlot.AlignedData));
  out[0] = all[0];
  let next = 1;
  for (const table of tables) for (const index of table.index) out[index] = all[next++];
  return out as uPlot.AlignedData;
}

function ticks(log = false): uPlot.Axis.DynamicValues {
  return (_u, splits) =>
    splits.map((v) => {
      if (v === null || v === undefined) return '';
      if (log) {
        const power = Math.log10(v);
        return Math.abs(power - Math.round(power)) < 1e-9 ? superscript(Math.round(power)) : '';
      }
      return String(Number(v.toPrecision(6))).replace('-', '−');
    });
}

const digits = '⁰¹²³⁴⁵⁶⁷⁸⁹';
const superscript = (power: number): string =>
  power === 0
    ? '1'
    : `10${power < 0 ? '⁻' : ''}${[...String(Math.abs(power))].map((d) => digits[Number(d)]).join('')}`;
