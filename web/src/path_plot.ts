// Plot of the path in the plane of the surface, with equal scales on both axes.

import { column, rowAt, rowBefore, type Numbers, type Run } from './data';
import { fixed, h } from './dom';
import { colour, faded, onTheme, runColour } from './theme';
import type { PageState } from './page_state';

interface Drawn {
  name: string;
  colour: string;
  run: Run;
  u: Numbers;
  w: Numbers;
  targetU: Numbers | null;
  targetW: Numbers | null;
}

const margin = { left: 50, right: 12, top: 10, bottom: 36 };

/** Tick distance, 1, 2 or 5 times a power of ten, with at most `maxSteps` steps in `span`. */
export function niceStep(span: number, maxSteps: number): number {
  const power = 10 ** Math.floor(Math.log10(span / maxSteps));
  return power * [1, 2, 5, 10].find((k) => k * power * maxSteps >= span)!;
}

export class PathPlot {
  readonly element: HTMLElement;
  private readonly canvas = h('canvas', {
    role: 'img',
    'aria-label': 'Path in the plane of the surface. Its values are below the title.',
  });
  private readonly box = h('div', { class: 'plot-box path-box' }, this.canvas);
  private readonly legend = h('div', { class: 'legend' });
  private readonly drawn: Drawn[];
  private enlarged = 1;
  private centre: [number, number] = [0, 0];
  /** Distance from the centre to the nearer edge [m] */
  private reach = 0.1;
  private visible = true;
  private dirty = true;
  private drag: { x: number; y: number; centre: [number, number]; moved: boolean } | null = null;

  constructor(private readonly state: PageState) {
    const runs = state.runs;
    this.drawn = runs.flatMap((run, i) => {
      const [u, w] = [column(run, 'path_u'), column(run, 'path_w')];
      if (!u || !w) return [];
      return {
        name: runs.length > 1 ? run.name : 'path of the tool',
        colour: runs.length > 1 ? runColour(i) : 'true',
        run,
        u,
        w,
        targetU: column(run, 'target_u'),
        targetW: column(run, 'target_w'),
      };
    });
    this.element = this.layout();
    this.reset();
    this.listen();
    state.clock.onTime(() => this.invalidate());
    state.onReading(() => this.read());
    onTheme(() => this.invalidate());
    new ResizeObserver(() => this.invalidate()).observe(this.box);
    new IntersectionObserver((entries) => {
      this.visible = entries.some((entry) => entry.isIntersecting);
      this.read();
    }).observe(this.element);
  }

  get empty(): boolean {
    return this.drawn.length === 0;
  }

  private layout(): HTMLElement {
    const choice = h(
      'select',
      { 'aria-label': 'Enlarge the distance from the target' },
      ...[1, 10, 100].map((k) =>
        h('option', { value: k }, k === 1 ? 'errors not enlarged' : `errors × ${k}`),
      ),
    );
    choice.addEventListener('change', () => {
      this.enlarged = Number(choice.value);
      this.invalidate();
    });
    const reset = h('button', { type: 'button', class: 'chip' }, 'Fit');
    reset.addEventListener('click', () => this.reset());
    const about =
      'Tip of the tool in the plane of the surface, seen along the normal; equal scales';
    return h(
      'section',
      { class: 'plot', 'aria-labelledby': 'plot-path', 'data-plot': 'path' },
      h(
        'header',
        {},
        h('div', {}, h('h3', { id: 'plot-path' }, 'Path'), h('p', { class: 'about' }, about)),
        choice,
        reset,
      ),
      this.legend,
      this.box,
    );
  }

  private reset(): void {
    let [lowU, highU, lowW, highW] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const { run } of this.drawn)
      for (let i = 0; i < run.path.u.length; ++i) {
        lowU = Math.min(lowU, run.path.u[i]!);
        highU = Math.max(highU, run.path.u[i]!);
        lowW = Math.min(lowW, run.path.w[i]!);
        highW = Math.max(highW, run.path.w[i]!);
      }
    if (!Number.isFinite(lowU)) [lowU, highU, lowW, highW] = [-0.1, 0.1, -0.1, 0.1];
    this.centre = [(lowU + highU) / 2, (lowW + highW) / 2];
    this.reach = 0.58 * Math.max(highU - lowU, highW - lowW, 0.01);
    this.invalidate();
  }

  invalidate(): void {
    this.dirty = true;
  }

  /** Once per frame of the browser. */
  frame(): void {
    if (!this.dirty || !this.visible) return;
    this.dirty = false;
    this.draw();
  }

  private get scale(): { x: (u: number) => number; y: (w: number) => number; k: number } {
    const width = this.box.clientWidth - margin.left - margin.right;
    const height = this.box.clientHeight - margin.top - margin.bottom;
    const k = Math.min(width, height) / (2 * this.reach);
    return {
      x: (u) => margin.left + width / 2 + (u - this.centre[0]) * k,
      y: (w) => margin.top + height / 2 - (w - this.centre[1]) * k,
      k,
    };
  }

  /** Drawn position of a row, with its distance from the target enlarged. */
  private point(d: Drawn, row: number): [number, number] {
    const [u, w] = [d.u[row]!, d.w[row]!];
    const [tu, tw] = [d.targetU?.[row] ?? NaN, d.targetW?.[row] ?? NaN];
    if (this.enlarged === 1) return [u, w];
    if (!Number.isFinite(tu) || !Number.isFinite(tw)) return [NaN, NaN];
    return [tu + this.enlarged * (u - tu), tw + this.enlarged * (w - tw)];
  }

  private draw(): void {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (width === 0 || height === 0) return;
    const ratio = devicePixelRatio;
    if (
      this.canvas.width !== Math.round(width * ratio) ||
      this.canvas.height !== Math.round(height * ratio)
    ) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    const ctx = this.canvas.getContext('2d')!;
    ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
    ctx.clearRect(0, 0, width, height);
    this.drawAxes(ctx, width, height);
    ctx.save();
    ctx.beginPath();
    ctx.rect(
      margin.left,
      margin.top,
      width - margin.left - margin.right,
      height - margin.top - margin.bottom,
    );
    ctx.clip();
    ctx.lineJoin = 'round';
    for (const d of this.drawn) this.drawPath(ctx, d);
    this.drawTarget(ctx);
    for (const d of this.drawn) this.drawNow(ctx, d);
    ctx.restore();
  }

  private drawAxes(ctx: CanvasRenderingContext2D, width: number, height: number): void {
    const { x, y, k } = this.scale;
    const [right, bottom] = [width - margin.right, height - margin.bottom];
    ctx.font = '11px system-ui, sans-serif';
    ctx.lineWidth = 1;
    ctx.fillStyle = colour('muted');
    ctx.strokeStyle = colour('grid');
    const step = niceStep((right - margin.left) / k, 7);
    const decimals = Math.max(0, -Math.floor(Math.log10(step * 1e3) + 1e-9));
    const lines = (
      low: number,
      high: number,
      draw: (value: number, text: string) => void,
    ): void => {
      for (let i = Math.ceil(low / step); i * step <= high; ++i)
        draw(i * step, fixed(i === 0 ? 0 : i * step * 1e3, decimals));
    };
    const left = this.centre[0] - (x(this.centre[0]) - margin.left) / k;
    const low = this.centre[1] - (bottom - y(this.centre[1])) / k;
    ctx.textAlign = 'center';
    ctx.textBaseline = 'top';
    lines(left, left + (right - margin.left) / k, (value, text) => {
      const px = Math.round(x(value)) + 0.5;
      ctx.beginPath();
      ctx.moveTo(px, margin.top);
      ctx.lineTo(px, bottom);
      ctx.stroke();
      ctx.fillText(text, px, bottom + 5);
    });
    ctx.textAlign = 'right';
    ctx.textBaseline = 'middle';
    lines(low, low + (bottom - margin.top) / k, (value, text) => {
      const py = Math.round(y(value)) + 0.5;
      ctx.beginPath();
      ctx.moveTo(margin.left, py);
      ctx.lineTo(right, py);
      ctx.stroke();
      ctx.fillText(text, margin.left - 5, py);
    });
    ctx.textAlign = 'center';
    ctx.fillText('along t₁ [mm]', (margin.left + right) / 2, height - 8);
    ctx.save();
    ctx.translate(9, (margin.top + bottom) / 2);
    ctx.rotate(-Math.PI / 2);
    ctx.fillText('along t₂ [mm]', 0, 0);
    ctx.restore();
  }

  private drawTarget(ctx: CanvasRenderingContext2D): void {
    const { x, y } = this.scale;
    ctx.setLineDash([7, 5]);
    ctx.lineWidth = 1.5;
    ctx.strokeStyle = colour('target');
    const seen: Run[] = [];
    for (const { run } of this.drawn) {
      const same = (other: Run): boolean =>
        other.path.u.length === run.path.u.length &&
        other.path.u.every((u, i) => Math.abs(u - run.path.u[i]!) < 1e-6);
      if (seen.some(same)) continue;
      seen.push(run);
      ctx.beginPath();
      for (let i = 0; i < run.path.u.length; ++i) ctx.lineTo(x(run.path.u[i]!), y(run.path.w[i]!));
      ctx.stroke();
    }
    ctx.setLineDash([]);
  }

  private drawPath(ctx: CanvasRenderingContext2D, d: Drawn): void {
    const { x, y } = this.scale;
    const now = rowBefore(d.run.time, this.state.clock.time);
    const contact = column(d.run, 'in_contact');
    const stride = Math.max(1, Math.floor(d.run.time.length / 6000));
    const stroke = (from: number, to: number): void => {
      ctx.beginPath();
      let pen = false;
      for (let row = from; row <= to; row += stride) {
        const [u, w] = this.point(d, row);
        const on = contact?.[row] !== 0 && Number.isFinite(u);
        if (on && pen) ctx.lineTo(x(u), y(w));
        else if (on) ctx.moveTo(x(u), y(w));
        pen = on;
      }
      ctx.stroke();
    };
    ctx.lineWidth = 3;
    ctx.strokeStyle = faded(d.colour, 0.22);
    stroke(0, d.run.time.length - 1);
    ctx.strokeStyle = colour(d.colour);
    stroke(0, now);
  }

  private drawNow(ctx: CanvasRenderingContext2D, d: Drawn): void {
    const { x, y } = this.scale;
    const row = rowAt(d.run.time, this.state.clock.time);
    const [u, w] = this.point(d, row);
    const [tu, tw] = [d.targetU?.[row] ?? NaN, d.targetW?.[row] ?? NaN];
    if (Number.isFinite(tu) && Number.isFinite(tw)) {
      ctx.strokeStyle = colour('target');
      ctx.lineWidth = 1.5;
      ctx.beginPath();
      ctx.arc(x(tu), y(tw), 9, 0, 2 * Math.PI);
      ctx.stroke();
    }
    if (!Number.isFinite(u)) return;
    ctx.fillStyle = colour(d.colour);
    ctx.strokeStyle = colour('card');
    ctx.lineWidth = 2;
    ctx.beginPath();
    ctx.arc(x(u), y(w), 5.5, 0, 2 * Math.PI);
    ctx.fill();
    ctx.stroke();
  }

  private listen(): void {
    const { canvas } = this;
    canvas.addEventListener('pointerdown', (event) => {
      if (event.pointerType === 'touch') return;
      canvas.setPointerCapture(event.pointerId);
      this.drag = { x: event.clientX, y: event.clientY, centre: [...this.centre], moved: false };
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!this.drag) return;
      const [dx, dy] = [event.clientX - this.drag.x, event.clientY - this.drag.y];
      if (Math.hypot(dx, dy) > 4) this.drag.moved = true;
      if (!this.drag.moved) return;
      const { k } = this.scale;
      this.centre = [this.drag.centre[0] - dx / k, this.drag.centre[1] + dy / k];
      this.invalidate();
    });
    canvas.addEventListener('pointerup', () => {
      setTimeout(() => (this.drag = null));
    });
    canvas.addEventListener('click', (event) => {
      if (!this.drag?.moved) this.seek(event);
    });
    canvas.addEventListener('dblclick', () => this.reset());
    canvas.addEventListener(
      'wheel',
      (event) => {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        this.reach *= Math.exp(event.deltaY * 4e-3);
        this.reach = Math.min(Math.max(this.reach, 1e-5), 5);
        this.invalidate();
      },
      { passive: false },
    );
  }

  /** Moves the time cursor to the row whose drawn point is nearest to the pointer. */
  private seek(event: MouseEvent): void {
    const bounds = this.canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - bounds.left, event.clientY - bounds.top];
    const { x, y } = this.scale;
    const d = this.drawn[0]!;
    const contact = column(d.run, 'in_contact');
    // Where the path passes twice, the pass nearer in time to the cursor wins.
    let best = { cost: Infinity, time: NaN };
    for (let row = 0; row < d.run.time.length; ++row) {
      if (contact?.[row] === 0) continue;
      const [u, w] = this.point(d, row);
      const distance = Math.hypot(x(u) - px, y(w) - py);
      const cost = distance + 0.2 * Math.abs(d.run.time[row]! - this.state.clock.time);
      if (distance < 25 && cost < best.cost) best = { cost, time: d.run.time[row]! };
    }
    if (Number.isFinite(best.time)) this.state.clock.set(best.time);
  }

  private read(): void {
    if (!this.visible) return;
    const t = this.state.hovered ?? this.state.clock.time;
    const mm = (v: number | undefined): string => fixed((v ?? NaN) * 1e3, 2);
    const items = this.drawn.map((d) => {
      const row = rowAt(d.run.time, t);
      return {
        name: d.name,
        colour: d.colour,
        dash: false,
        text: `${mm(d.u[row])}, ${mm(d.w[row])} mm`,
      };
    });
    const first = this.drawn[0];
    if (first) {
      const row = rowAt(first.run.time, t);
      const text = `${mm(first.targetU?.[row])}, ${mm(first.targetW?.[row])} mm`;
      items.push({ name: 'target', colour: 'target', dash: true, text });
    }
    this.legend.replaceChildren(
      ...items.map((item) => {
        const swatch = h('span', { class: 'swatch' });
        swatch.style.borderTop = `3px ${item.dash ? 'dashed' : 'solid'} ${colour(item.colour)}`;
        const reading = h('span', { class: 'reading' }, item.text);
        return h('span', { class: 'key' }, swatch, h('span', {}, item.name), reading);
      }),
    );
  }
}
