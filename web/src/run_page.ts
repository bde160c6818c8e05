// Page of one run, or of several runs that are compared.

import { speeds } from './clock';
import { presses, valueAt, type Page, type Run } from './data';
import { fixed, h } from './dom';
import { runHeader, runMark, tiles } from './header';
import { helpDialog, onKeys, type Keys } from './help';
import { PageState } from './page_state';
import { PathPlot } from './path_plot';
import { planSpecs } from './plan_specs';
import {
  allJoints,
  contactSpecs,
  controllerSpecs,
  forceSpec,
  jointSpecs,
  shortJoint,
} from './plot_specs';
import { forceScale, hasLayer, layers, OtherTool, RunScene, type Layer } from './replay';
import { standingSpecs } from './standing_specs';
import { groundHeight, weightScale } from './supports';
import { runColour, toggleTheme } from './theme';
import { TimePlot } from './time_plot';
import { timeline } from './timeline';
import { View3D } from './view3d';

const keys: { title: string; keys: Keys }[] = [
  {
    title: 'Time',
    keys: [
      ['Space', 'play, pause'],
      ['← →', '10 ms back, forward; with Shift: 0.5 s'],
      ['Home, End', 'go to the start, to the end'],
      ['1 … 6', `speed: ${speeds.map((s) => `${s}×`).join(', ')}`],
    ],
  },
  {
    title: 'Plots',
    keys: [
      ['drag', 'zoom all plots to the selected time'],
      ['click', 'move the time cursor'],
      ['+ −', 'zoom about the time cursor'],
      ['0, double click', 'show the whole run'],
      ['M', 'zoom to the time window of the metrics'],
      ['Ctrl + wheel', 'zoom about the pointer; Shift + wheel: scroll in time'],
    ],
  },
  {
    title: '3D view',
    keys: [
      ['drag, wheel', 'rotate, zoom; right button: move'],
      ['W A S D, Q E', 'rotate, zoom, while the view has the focus'],
      ['V', 'next viewpoint'],
      ['F, N, H', 'show or hide forces, normals, predicted horizon'],
      ['G, B', 'show or hide feet with their forces, balance'],
    ],
  },
  {
    title: 'Page',
    keys: [
      ['T', 'light or dark'],
      ['?', 'show this list'],
    ],
  },
];

const layerNames: Record<Layer, string> = {
  forces: 'Forces at the tool',
  feet: 'Feet, their forces and friction cones',
  balance: 'Centre of mass, support polygon',
  pushes: 'Pushes',
  normals: 'Normals, true and estimated',
  triad: 'Axes of the surface',
  path: 'Target path',
  trail: 'Path of the tool',
  horizon: 'Predicted horizon',
  surface: 'Surface',
};

/** The 3D view with its legend, viewpoints and layers. */
class Stage {
  readonly element: HTMLElement;
  readonly view: View3D;
  selected = 0;
  private readonly scenes: (RunScene | null)[];
  private readonly others: OtherTool[] = [];
  private readonly newtons: number;
  private viewpoint = 0;
  private readonly boxes = new Map<Layer, HTMLInputElement>();
  private readonly forces = h('div', { class: 'force-key' });
  private readonly contact = h('div', { class: 'contact-key' });
  private readonly canvasHost = h('div', { class: 'canvas-host' });

  constructor(private readonly state: PageState) {
    const { runs } = state;
    this.newtons = forceScale(runs);
    this.view = new View3D(this.canvasHost);
    this.scenes = runs.map(() => null);
    if (runs.length > 1)
      for (const [i, run] of runs.entries()) {
        const other = new OtherTool(run, runColour(i));
        this.others.push(other);
        this.view.scene.add(other.group);
      }
    this.element = this.layout();
    this.select(0);
    this.lookFrom(0, false);
    this.view.beforeRender = () => this.scene.faceCamera(this.view);
    state.clock.onTime(() => this.update());
    state.onReading(() => this.read());
    this.read();
  }

  private get scene(): RunScene {
    const { selected } = this;
    this.scenes[selected] ??= new RunScene(this.state.runs[selected]!, this.newtons);
    return this.scenes[selected]!;
  }

  private layout(): HTMLElement {
    const views = h('div', { class: 'views', role: 'group', 'aria-label': 'Viewpoint' });
    this.scene.viewpoints().forEach(({ name }, i) => {
      const button = h('button', { type: 'button', class: 'chip' }, name);
      button.addEventListener('click', () => this.lookFrom(i));
      views.append(button);
    });
    const menu = h('div', { class: 'menu' });
    for (const layer of layers) {
      if (!this.state.runs.some((run) => hasLayer(run, layer))) continue;
      const box = h('input', { type: 'checkbox', checked: true });
      box.addEventListener('change', () => this.setLayer(layer, box.checked));
      this.boxes.set(layer, box);
      menu.append(h('label', {}, box, layerNames[layer]));
    }
    const show = h('details', { class: 'layers' }, h('summary', { class: 'chip' }, 'Show'), menu);
    const scale = h(
      'div',
      {
        class: 'scale-key',
        title: 'Force of the surface on the tool, in the axes t₁, t₂, n of the surface',
      },
      h('span', {}, `10 cm = ${this.newtons} N`),
      h('span', {}, 'surface on tool'),
    );
    const standing = this.state.runs.find((run) => (run.supports ?? []).length > 0);
    return h(
      'div',
      { class: 'stage' },
      this.canvasHost,
      h(
        'div',
        { class: 'hud top-left' },
        this.runChoice(),
        (this.state.runs.some(presses) || standing) &&
          h(
            'div',
            { class: 'readings' },
            ...(this.state.runs.some(presses) ? [this.forces, this.contact, scale] : []),
            standing && this.standingKey(standing),
          ),
      ),
      h('div', { class: 'hud top-right' }, views, show),
    );
  }

  /** Legend of the marks of a standing robot. */
  private standingKey(run: Run): HTMLElement {
    const entry = (tint: string, text: string): HTMLElement => {
      const mark = h('span', { class: 'dot' });
      mark.style.background = `var(--${tint})`;
      return h('span', {}, mark, text);
    };
    return h(
      'div',
      { class: 'standing-key' },
      h('span', {}, `10 cm = ${weightScale(run)} N, ground on feet`),
      entry('support', 'force and friction cone'),
      entry('pressure', 'centre of pressure of all feet'),
      entry('mass', 'centre of mass'),
    );
  }

  private runChoice(): HTMLElement | null {
    const { runs } = this.state;
    if (runs.length < 2) return null;
    const group = h('div', {
      class: 'run-choice',
      role: 'radiogroup',
      'aria-label': 'Run in the 3D view',
    });
    runs.forEach((run, i) => {
      const radio = h('input', { type: 'radio', name: 'run', checked: i === 0 });
      radio.addEventListener('change', () => this.select(i));
      group.append(h('label', { class: 'chip' }, radio, runMark(i), run.name));
    });
    return group;
  }

  select(index: number): void {
    this.scenes[this.selected]?.group.removeFromParent();
    const before = this.state.runs[this.selected]!;
    this.selected = index;
    this.view.scene.add(this.scene.group);
    this.view.setFloor(groundHeight(this.state.runs[index]!));
    const here = this.scene.contactPoint;
    this.others.forEach((other, i) => {
      const p = this.state.runs[i]!.path_origin;
      const near = Math.hypot(p[0] - here.x, p[1] - here.y, p[2] - here.z) < 0.1;
      other.group.visible = i !== index && near;
    });
    for (const [layer, box] of this.boxes) this.scene.show(layer, box.checked);
    const after = this.state.runs[index]!;
    const moved = before.path_origin.some((v, i) => Math.abs(v - after.path_origin[i]!) > 0.1);
    if (moved) this.lookFrom(this.viewpoint);
    this.update();
    this.read();
  }

  lookFrom(index: number, fly = true): void {
    const points = this.scene.viewpoints();
    this.viewpoint = index % points.length;
    const { target, from, radius } = points[this.viewpoint]!;
    this.view.look(target, from, radius, fly);
  }

  nextView(): void {
    this.lookFrom(this.viewpoint + 1);
  }

  private setLayer(layer: Layer, on: boolean): void {
    this.scene.show(layer, on);
    this.view.invalidate();
  }

  toggle(layer: Layer): void {
    const box = this.boxes.get(layer);
    if (!box) return;
    box.checked = !box.checked;
    this.setLayer(layer, box.checked);
  }

  drawnTool(): [number, number, number] | null {
    return this.scene.drawnTool();
  }

  private update(): void {
    const t = this.state.clock.time;
    this.scene.update(t);
    for (const other of this.others) if (other.group.visible) other.update(t);
    this.view.invalidate();
  }

  private read(): void {
    const run: Run = this.state.runs[this.selected]!;
    const t = this.state.clock.time;
    const rows: [string, string, string][] = [
      ['true', 'true', 'force_normal'],
      ['estimated', 'estimated', 'force_estimated'],
      ['target', 'target', 'force_target'],
    ];
    this.forces.replaceChildren(
      ...rows
        .filter(([, , name]) => run.columns.has(name))
        .map(([tint, label, name]) => {
          const dot = h('span', { class: 'dot' });
          dot.style.background = `var(--${tint})`;
          const value = h('span', { class: 'reading' }, `${fixed(valueAt(run, name, t), 1)} N`);
          return h('span', {}, dot, label, value);
        }),
    );
    const held = valueAt(run, 'in_contact', t) > 0.5;
    this.contact.textContent = held ? '● in contact' : '○ no contact';
    this.contact.classList.toggle('held', held);
  }
}

/** All plots, with one choice of a joint for the three plots of joints. */
function plots(state: PageState, path: PathPlot): { element: HTMLElement; names: string[] } {
  const { runs } = state;
  const element = h('div', { class: 'plots' });
  const names: string[] = [];
  const add = (id: string, part: HTMLElement): void => {
    names.push(id);
    element.append(part);
  };
  const addAll = (specs: ReturnType<typeof contactSpecs>): void =>
    specs.forEach((spec) => add(spec.id, new TimePlot(spec, state).element));
  if (runs.some(presses)) {
    add('force', new TimePlot(forceSpec(runs), state).element);
    if (!path.empty) add('path', path.element);
    addAll(contactSpecs(runs));
  }

  addAll(planSpecs(runs));

  const standing = standingSpecs(runs);
  if (standing.length > 0)
    element.append(h('div', { class: 'divider' }, h('h2', {}, 'Feet and balance')));
  addAll(standing);

  const joints = runs[0]!.robot.moving;
  const choice = h(
    'select',
    { 'aria-label': 'Joint' },
    h(
      'option',
      { value: allJoints },
      runs.length > 1 ? 'joint nearest to its limit' : 'all joints',
    ),
    ...joints.map((name) => h('option', { value: name }, shortJoint(name))),
  );
  element.append(h('div', { class: 'divider' }, h('h2', {}, 'Joints'), choice));
  const own = jointSpecs(runs, allJoints).map((spec) => new TimePlot(spec, state));
  const fill = (): void =>
    jointSpecs(runs, choice.value).forEach((spec, i) => {
      own[i]!.setSpec(spec);
      own[i]!.element.hidden = spec.curves.length === 0;
    });
  ['tau', 'q', 'v'].forEach((id, i) => add(id, own[i]!.element));
  choice.addEventListener('change', fill);
  fill();

  const controller = controllerSpecs(runs);
  if (controller.length > 0)
    element.append(h('div', { class: 'divider' }, h('h2', {}, 'Controller')));
  addAll(controller);
  return { element, names };
}

function zoomBar(state: PageState): HTMLElement {
  const whole = h('button', { type: 'button', class: 'chip', title: '0' }, 'Whole run');
  whole.addEventListener('click', () => state.window.reset());
  const bar = h('div', { class: 'zoom-bar' }, h('h2', {}, 'Plots'), whole);
  const span = state.runs[0]!.window;
  if (span) {
    const metrics = h('button', { type: 'button', class: 'chip', title: 'M' }, 'Metrics window');
    metrics.addEventListener('click', () => state.window.set(...span));
    bar.append(metrics);
  }
  const shown = h('span', { class: 'shown' });
  const read = (): void => {
    shown.textContent = `${fixed(state.window.min, 2)} to ${fixed(state.window.max, 2)} s`;
    whole.disabled = state.window.whole;
  };
  state.window.onChange(read);
  read();
  bar.append(shown);
  return bar;
}

function listenToKeys(state: PageState, stage: Stage, help: HTMLDialogElement): void {
  const { clock, window } = state;
  onKeys((event) => {
    const step = event.shiftKey ? 0.5 : 0.01;
    const speed = /^[1-6]$/.test(event.key) ? speeds[Number(event.key) - 1] : undefined;
    if (speed !== undefined) return () => clock.setSpeed(speed);
    const span = state.runs[0]!.window;
    const actions: Record<string, (() => void) | undefined> = {
      ' ': () => clock.toggle(),
      arrowleft: () => clock.set(clock.time - step),
      arrowright: () => clock.set(clock.time + step),
      home: () => clock.set(0),
      end: () => clock.set(clock.duration),
      '+': () => window.zoom(0.6, clock.time),
      '=': () => window.zoom(0.6, clock.time),
      '-': () => window.zoom(1 / 0.6, clock.time),
      '0': () => window.reset(),
      m: span ? () => window.set(...span) : undefined,
      v: () => stage.nextView(),
      f: () => stage.toggle('forces'),
      n: () => stage.toggle('normals'),
      h: () => stage.toggle('horizon'),
      g: () => stage.toggle('feet'),
      b: () => stage.toggle('balance'),
      t: toggleTheme,
      '?': () => help.showModal(),
    };
    return actions[event.key.toLowerCase()];
  });
}

function seek(state: PageState, time: number): void {
  state.clock.pause();
  state.clock.set(time);
}

/** Sets window.burnish, the interface of the page for tests and scripts. */
function expose(page: Page, state: PageState, stage: Stage, names: string[]): void {
  window.burnish = {
    ready: false,
    get time() {
      return state.clock.time;
    },
    get playing() {
      return state.clock.playing;
    },
    get renderCount() {
      return stage.view.renderCount;
    },
    get window(): [number, number] {
      return [state.window.min, state.window.max];
    },
    runs: page.runs.length,
    plots: names,
    setTime: (time) => seek(state, time),
    play: () => state.clock.play(),
    pause: () => state.clock.pause(),
    drawnTool: () => stage.drawnTool(),
    value: (name, run = 0) => {
      const chosen = page.runs[run];
      return chosen ? valueAt(chosen, name, state.clock.time) : NaN;
    },
  };
}

export function runPage(page: Page, host: HTMLElement): void {
  const state = new PageState(page.runs);
  const help = helpDialog(keys);
  const path = new PathPlot(state);
  const stage = new Stage(state);
  const drawn = h('div', { class: 'right' }, tiles(page.runs), zoomBar(state));
  host.replaceChildren(
    runHeader(page, help, (time) => seek(state, time)),
    h(
      'main',
      { class: 'split' },
      h('div', { class: 'left' }, stage.element, timeline(state)),
      drawn,
    ),
    help,
  );
  const { element, names } = plots(state, path);
  drawn.append(element);
  listenToKeys(state, stage, help);

  expose(page, state, stage, names);
  const frame = (now: number): void => {
    state.frame(now);
    path.frame();
    stage.view.frame(now);
    if (stage.view.renderCount > 0 || !stage.view.works) window.burnish!.ready = true;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
