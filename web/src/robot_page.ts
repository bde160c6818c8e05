// Page of a robot without a run: sliders for its joints, its frames, its inertias.

import { Vector3 } from 'three';
import type { Body, Frame, Page, Robot } from './data';
import { copyButton, fixed, format, h } from './dom';
import { dateOf, pageBar } from './header';
import { helpDialog, onKeys, type Keys } from './help';
import { slidersOf, type Slider } from './joint_sliders';
import { framePlacement, jointValue, principal } from './kinematics';
import { axisColours, RobotScene } from './robot_scene';
import { toggleTheme } from './theme';
import { View3D } from './view3d';

const keys: { title: string; keys: Keys }[] = [
  {
    title: '3D view',
    keys: [
      ['drag, wheel', 'rotate, zoom; right button: move'],
      ['W A S D, Q E', 'rotate, zoom, while the view has the focus'],
      ['V', 'show the whole robot'],
    ],
  },
  {
    title: 'Page',
    keys: [
      ['Tab, ← →', 'go to the next joint, move it'],
      ['F, I', 'show or hide joint frames, inertias'],
      ['T', 'light or dark'],
      ['?', 'show this list'],
    ],
  },
];

function bodyTable(robot: Robot): HTMLElement {
  const row = (body: Body): HTMLElement => {
    const { moments } = principal(body.inertia);
    const cell = (text: string): HTMLElement => h('td', { class: 'number' }, text);
    return h(
      'tr',
      {},
      h('th', { scope: 'row' }, body.joint.name),
      h('td', {}, body.joint.kind.replace('_', ' ')),
      cell(`${format(body.joint.lower, 3)} … ${format(body.joint.upper, 3)}`),
      cell(format(body.joint.velocity, 3)),
      cell(format(body.joint.effort, 3)),
      cell(format(body.mass)),
      cell(body.com.map((v) => fixed(v, 3)).join(', ')),
      cell(moments.map((v) => format(v, 3)).join(', ')),
    );
  };
  const heads = [
    'joint',
    'kind',
    'q limits [rad, m]',
    'v limit [rad/s, m/s]',
    'effort limit [N m, N]',
    'mass [kg]',
  ];
  heads.push('centre of mass in the joint frame [m]', 'principal moments [kg m²]');
  return h(
    'div',
    { class: 'scroll-x' },
    h(
      'table',
      { class: 'metrics bodies' },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          ...heads.map((text, i) => h('th', { scope: 'col', class: i > 1 ? 'number' : '' }, text)),
        ),
      ),
      h('tbody', {}, ...robot.bodies.map(row)),
    ),
  );
}

/** Selection of a frame, and the placement of the selected frame. */
class FramePanel {
  readonly element: HTMLElement;
  private readonly where = h('p', { class: 'where' });
  private chosen: Frame | null = null;

  constructor(
    private readonly robot: Robot,
    private readonly scene: RobotScene,
    changed: () => void,
  ) {
    const choice = h('select', { 'aria-label': 'Frame' }, h('option', { value: -1 }, 'none'));
    for (const kind of ['user', 'link', 'joint'] as const) {
      const own = robot.frames.flatMap((frame, i) => (frame.kind === kind ? [{ frame, i }] : []));
      if (own.length === 0) continue;
      const label = { user: 'user frames', link: 'links', joint: 'joints' }[kind];
      const options = own.map(({ frame, i }) => h('option', { value: i }, frame.name));
      choice.append(h('optgroup', { label }, ...options));
    }
    choice.addEventListener('change', () => {
      this.chosen = this.robot.frames[Number(choice.value)] ?? null;
      this.scene.choose(this.chosen);
      changed();
    });
    this.element = h(
      'div',
      { class: 'panel' },
      h('div', { class: 'row' }, h('h2', {}, 'Frames')),
      h('div', { class: 'frame-choice' }, h('label', {}, 'Frame ', choice), this.where),
    );
  }

  show(): void {
    this.where.textContent = '';
    if (!this.chosen) return;
    const p = framePlacement(this.scene.model.placements, this.chosen);
    const text = (part: number[]): string => part.map((v) => fixed(v, 4)).join(', ');
    this.where.textContent = `position in the world: (${text(p.slice(0, 3))}) m; quaternion x y z w (${text(p.slice(3))})`;
  }
}

/** Check boxes for the parts of the robot that are drawn. */
function showPanel(
  robot: Robot,
  scene: RobotScene,
  view: View3D,
): { element: HTMLElement; press: (label: string) => void } {
  const boxes = new Map<string, HTMLInputElement>();
  const toggle = (label: string, on: boolean, apply: (shown: boolean) => void): HTMLElement => {
    const box = h('input', { type: 'checkbox', checked: on });
    box.addEventListener('change', () => {
      apply(box.checked);
      view.invalidate();
    });
    apply(on);
    boxes.set(label, box);
    return h('label', { class: 'chip' }, box, label);
  };
  const element = h(
    'div',
    { class: 'views' },
    toggle('User frames', true, (on) => (scene.users.visible = on)),
    toggle('Joint frames', false, (on) => (scene.joints.visible = on)),
    toggle('Inertias', robot.visuals.length === 0, (on) => (scene.inertias.visible = on)),
    toggle('Transparent', false, (on) => scene.model.setOpacity(on ? 0.3 : 1)),
  );
  return { element, press: (label) => boxes.get(label)?.click() };
}

/** Panel with the sliders of the joints, a choice of postures, and buttons to reset and copy q. */
function jointPanel(
  robot: Robot,
  q: number[],
  sliders: Slider[],
  changed: () => void,
): HTMLElement {
  const setAll = (values: number[]): void => {
    values.forEach((value, i) => (q[i] = value));
    changed();
  };
  const postures = h(
    'select',
    { 'aria-label': 'Posture' },
    h('option', { value: '' }, 'Posture …'),
    ...robot.postures.map((posture, i) => h('option', { value: i }, posture.name)),
  );
  postures.addEventListener('change', () => {
    const posture = robot.postures[Number(postures.value)];
    if (posture && postures.value !== '') setAll(posture.q);
  });
  const reset = h('button', { type: 'button', class: 'button' }, 'Reset');
  reset.addEventListener('click', () => setAll(robot.q));
  const asText = (): string => `[${q.map((v) => Number(v.toFixed(6))).join(', ')}]`;
  const filter = h('input', {
    type: 'search',
    placeholder: 'Find a joint',
    'aria-label': 'Find a joint',
  });
  filter.addEventListener('input', () => {
    const wanted = filter.value.toLowerCase();
    for (const { element } of sliders)
      element.hidden = !element.textContent!.toLowerCase().includes(wanted);
  });
  const heading = h('h2', {}, 'Joints');
  return h(
    'div',
    { class: 'panel' },
    h('div', { class: 'row' }, heading, postures, reset, copyButton('Copy q', asText)),
    sliders.length > 12 && filter,
    h('div', { class: 'joints' }, ...sliders.map((one) => one.element)),
  );
}

function robotFacts(page: Page, robot: Robot): HTMLElement {
  const all: [string, string][] = [
    ['moving joints', String(robot.moving.length)],
    ['configuration', `${robot.nq} numbers`],
    ['moving mass', `${format(robot.total_mass)} kg`],
    ['gravity', `(${robot.gravity.map((v) => format(v, 3)).join(', ')}) m/s²`],
    ['frames', String(robot.frames.length)],
    ['version', page.version],
    ['date', dateOf(page.created)],
  ];
  return h(
    'dl',
    { class: 'facts' },
    ...all.map(([key, value]) => h('div', {}, h('dt', {}, key), h('dd', {}, value))),
  );
}

function axisKey(): HTMLElement {
  const entries = axisColours.map((name) => {
    const dot = h('span', { class: 'dot' });
    dot.style.background = `var(--${name})`;
    return h('span', {}, dot, name);
  });
  return h('div', { class: 'hud top-left' }, h('div', { class: 'axis-key' }, ...entries));
}

export function robotPage(page: Page, robot: Robot, host: HTMLElement): void {
  const help = helpDialog(keys);
  const q = [...robot.q];
  const canvasHost = h('div', { class: 'canvas-host' });
  const view = new View3D(canvasHost);
  const scene = new RobotScene(robot);
  view.scene.add(scene.group);
  const sliders = robot.bodies.flatMap((body) => slidersOf(body, q, () => changed()));
  const frames = new FramePanel(robot, scene, () => changed());
  const changed = (): void => {
    scene.setPosture(q);
    for (const one of sliders) one.show();
    frames.show();
    view.invalidate();
  };
  const shown = showPanel(robot, scene, view);
  const hud = h('div', { class: 'hud top-right' }, shown.element);
  const stage = h('div', { class: 'stage' }, canvasHost, axisKey(), hud);
  const joints = jointPanel(robot, q, sliders, changed);
  const bar = pageBar([h('h1', {}, page.title)], [], help);
  host.replaceChildren(
    h('header', { class: 'head' }, bar, robotFacts(page, robot)),
    h(
      'main',
      { class: 'split robot' },
      h('div', { class: 'left' }, stage),
      h('div', { class: 'right' }, frames.element, joints),
    ),
    h('section', { class: 'below' }, h('h2', {}, 'Bodies'), bodyTable(robot)),
    help,
  );
  changed();
  const whole = (fly = true): void => {
    const { centre, radius } = scene.extent();
    view.look(centre, new Vector3(1, -0.75, 0.35), radius, fly);
  };
  whole(false);
  onKeys((event) => {
    const actions: Record<string, () => void> = {
      f: () => shown.press('Joint frames'),
      i: () => shown.press('Inertias'),
      v: () => whole(),
      t: toggleTheme,
      '?': () => help.showModal(),
    };
    return actions[event.key.toLowerCase()];
  });
  exposeRobot(robot, q, view, changed);
}

function exposeRobot(robot: Robot, q: number[], view: View3D, changed: () => void): void {
  window.burnish = {
    ready: false,
    time: 0,
    playing: false,
    window: [0, 0],
    get renderCount() {
      return view.renderCount;
    },
    runs: 0,
    plots: [],
    setTime: () => changed(),
    play: () => {},
    pause: () => {},
    drawnTool: () => null,
    value: (name) => {
      const found = robot.bodies.find((b) => b.joint.name === name);
      return found ? jointValue(robot, found.joint, q) : NaN;
    },
  };
  const frame = (now: number): void => {
    view.frame(now);
    if (view.renderCount > 0 || !view.works) window.burnish!.ready = true;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}
