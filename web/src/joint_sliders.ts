// Sliders for the entries of a configuration q.

import type { Body } from './data';
import { fixed, h } from './dom';

export interface Slider {
  element: HTMLElement;
  show: () => void;
}

/** Slider of one entry of the configuration. */
function slider(
  label: string,
  unit: string,
  low: number,
  high: number,
  read: () => number,
  write: (value: number) => void,
): Slider {
  const range = h('input', {
    type: 'range',
    min: low,
    max: high,
    step: 'any',
    'aria-label': label,
  });
  const value = h('output', { class: 'reading' });
  const show = (): void => {
    const now = read();
    range.value = String(now);
    const text =
      unit === 'rad'
        ? `${fixed(now, 3)} rad, ${fixed((now * 180) / Math.PI, 1)}°`
        : `${fixed(now, 3)} ${unit}`;
    value.textContent = text;
    range.setAttribute('aria-valuetext', text);
  };
  range.addEventListener('input', () => write(Number(range.value)));
  const shown = h('span', { class: 'joint-name' }, label);
  return { element: h('label', { class: 'joint' }, shown, value, range), show };
}

/** Sliders of a joint, which write into q and call `changed`. */
export function slidersOf(body: Body, q: number[], changed: () => void): Slider[] {
  const { joint } = body;
  if (joint.follows) return [];
  const o = joint.q_index;
  const one = (k: number, label: string, unit: string, low: number, high: number): Slider =>
    slider(
      label,
      unit,
      low,
      high,
      () => q[o + k]!,
      (value) => {
        q[o + k] = value;
        changed();
      },
    );
  const angle = (k: number, label: string): Slider =>
    slider(
      label,
      'rad',
      -Math.PI,
      Math.PI,
      () => Math.atan2(q[o + k + 1]!, q[o + k]!),
      (value) => {
        q[o + k] = Math.cos(value);
        q[o + k + 1] = Math.sin(value);
        changed();
      },
    );
  switch (joint.kind) {
    case 'revolute':
      return [one(0, joint.name, 'rad', joint.lower ?? -Math.PI, joint.upper ?? Math.PI)];
    case 'prismatic':
      return [one(0, joint.name, 'm', joint.lower ?? -1, joint.upper ?? 1)];
    case 'continuous':
      return [angle(0, joint.name)];
    case 'planar':
      return [
        one(0, `${joint.name}, x`, 'm', -2, 2),
        one(1, `${joint.name}, y`, 'm', -2, 2),
        angle(2, `${joint.name}, about z`),
      ];
    case 'free_flyer':
      return [
        ...['x', 'y', 'z'].map((name, k) => one(k, `${joint.name}, ${name}`, 'm', -2, 2)),
        ...eulerSliders(joint.name, q, o + 3, changed),
      ];
    case 'ball':
      return eulerSliders(joint.name, q, o, changed);
  }
}

/** Sliders of roll, pitch and yaw for the quaternion (x, y, z, w) at an offset of q. */
function eulerSliders(name: string, q: number[], o: number, changed: () => void): Slider[] {
  const read = (): number[] => {
    const [x, y, z, w] = [q[o]!, q[o + 1]!, q[o + 2]!, q[o + 3]!];
    return [
      Math.atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y)),
      Math.asin(Math.min(Math.max(2 * (w * y - z * x), -1), 1)),
      Math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z)),
    ];
  };
  const write = ([roll, pitch, yaw]: number[]): void => {
    const [cr, cp, cy] = [roll!, pitch!, yaw!].map((a) => Math.cos(a / 2)) as [
      number,
      number,
      number,
    ];
    const [sr, sp, sy] = [roll!, pitch!, yaw!].map((a) => Math.sin(a / 2)) as [
      number,
      number,
      number,
    ];
    q[o] = sr * cp * cy - cr * sp * sy;
    q[o + 1] = cr * sp * cy + sr * cp * sy;
    q[o + 2] = cr * cp * sy - sr * sp * cy;
    q[o + 3] = cr * cp * cy + sr * sp * sy;
    changed();
  };
  return ['roll', 'pitch', 'yaw'].map((label, k) => {
    const most = k === 1 ? Math.PI / 2 - 0.01 : Math.PI;
    return slider(
      `${name}, ${label}`,
      'rad',
      -most,
      most,
      () => read()[k]!,
      (value) => {
        const angles = read();
        angles[k] = value;
        write(angles);
      },
    );
  });
}
