// Supports of a standing robot: forces, centres of pressure, support polygon.

import { column, type Placement, type Push, type Run, type Support, type Vec3 } from './data';
import { framePlacement, rotate } from './kinematics';

export interface FootLoad {
  /** Force of the ground on the foot, in world axes [N] */
  force: Vec3;
  /** Centre of pressure of a sole, or lowest point of a ball, in the world [m] */
  point: Vec3;
  /** Component of the force along the normal of the ground [N] */
  normal: number;
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const from = (p: Placement, v: Vec3): Vec3 => {
  const turned = rotate(p, v);
  return [p[0] + turned[0], p[1] + turned[1], p[2] + turned[2]];
};

export const isSole = (support: Support): boolean => support.half_x > 0 && support.half_y > 0;
/** Whether the support is a foot on level ground; other supports are hands on a wall. */
export const isLevel = (support: Support): boolean => support.normal[2] > 0.9;
/** Smallest load of a foot that counts for the support polygon [N]. */
export const minPressureLoad = 20;

/** World placement of the frame of a support; null if the robot has no such frame. `bodies`:
 * placements as forward() returns them. */
export function footPlacement(run: Run, bodies: Placement[], support: Support): Placement | null {
  const frame = run.robot.frames.find(({ name }) => name === support.frame);
  return frame ? framePlacement(bodies, frame) : null;
}

/** Load of a foot with the placement `foot` in a row; NaN if the run has no columns for it. */
export function footLoad(run: Run, support: Support, foot: Placement, row: number): FootLoad {
  const [fx, fy, fz, mx, my] = ['fx', 'fy', 'fz', 'mx', 'my'].map(
    (name) => column(run, `support_${support.frame}_${name}`)?.[row] ?? NaN,
  ) as [number, number, number, number, number];
  const force = rotate(foot, [fx, fy, fz]);
  const { normal, radius } = support;
  const lowest: Vec3 = [
    foot[0] - radius * normal[0],
    foot[1] - radius * normal[1],
    foot[2] - radius * normal[2],
  ];
  const acts = Math.abs(fz) > 1e-9 ? from(foot, [-my / fz, mx / fz, 0]) : from(foot, [0, 0, 0]);
  return { force, point: isSole(support) ? acts : lowest, normal: dot(force, normal) };
}

/** Corners of a sole, in order, or the lowest point of a ball. */
export function corners(support: Support, foot: Placement): Vec3[] {
  const { half_x: x, half_y: y, radius, normal } = support;
  if (!isSole(support))
    return [
      [foot[0] - radius * normal[0], foot[1] - radius * normal[1], foot[2] - radius * normal[2]],
    ];
  return (
    [
      [-x, -y, 0],
      [x, -y, 0],
      [x, y, 0],
      [-x, y, 0],
    ] as Vec3[]
  ).map((corner) => from(foot, corner));
}

/** Centre of pressure of all feet: mean of their points, weighted by load; null below 20 N. */
export function pressureOfAll(loads: FootLoad[]): Vec3 | null {
  const loaded = loads.filter(({ normal }) => normal > 0);
  const whole = loaded.reduce((sum, { normal }) => sum + normal, 0);
  if (!(whole > minPressureLoad)) return null;
  const mean = (k: 0 | 1 | 2): number =>
    loaded.reduce((sum, { normal, point }) => sum + (normal * point[k]) / whole, 0);
  return [mean(0), mean(1), mean(2)];
}

/** The convex hull as seen from above, counterclockwise (Andrew's monotone chain). */
export function hull(points: Vec3[]): Vec3[] {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  if (sorted.length < 3) return sorted;
  const turns = (o: Vec3, a: Vec3, b: Vec3): number =>
    (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
  const half = (some: Vec3[]): Vec3[] => {
    const chain: Vec3[] = [];
    for (const p of some) {
      while (chain.length > 1 && turns(chain.at(-2)!, chain.at(-1)!, p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

/** Height of the lowest ground under the feet [m]; 0 without feet. */
export function groundHeight(run: Run): number {
  const heights = (run.supports ?? []).filter(isLevel).map(({ point }) => point[2]);
  return heights.length > 0 ? Math.min(...heights) : 0;
}

/** Pushes that act at time t. */
export const pushesAt = (pushes: Push[], t: number): Push[] =>
  pushes.filter(({ start, duration }) => t >= start && t < start + duration);

/** Name of a frame without the ending "_link", "_frame" or "_joint". */
export const shortFoot = (name: string): string =>
  name.replace(/_(link|frame|joint)$/, '').replace(/_/g, ' ');

/** Force per 10 cm of arrow [N]; an arrow of the robot's weight is about 0.5 m long. */
export function weightScale(run: Run): number {
  const weight = run.robot.total_mass * Math.hypot(...run.robot.gravity);
  if (!(weight > 0)) return 100;
  const power = 10 ** Math.floor(Math.log10(weight / 5));
  return power * [1, 2, 5, 10].find((k) => k * power >= 0.8 * (weight / 5))!;
}
