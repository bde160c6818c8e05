// What a robot stands on: forces and centres of pressure of its feet, the polygon between them.

import { column, type Placement, type Push, type Run, type Support, type Vec3 } from './data';
import { framePlacement, rotate } from './kinematics';

export interface FootLoad {
  /** by the ground on the foot, N, world */
  force: Vec3;
  /** where it acts in the plane of the sole, or at the point of a ball that is the lowest, m, world */
  point: Vec3;
  /** N, along the normal of the ground */
  normal: number;
}

const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const from = (p: Placement, v: Vec3): Vec3 => {
  const turned = rotate(p, v);
  return [p[0] + turned[0], p[1] + turned[1], p[2] + turned[2]];
};

export const isSole = (support: Support): boolean => support.half_x > 0 && support.half_y > 0;
/** Feet stand on it and hands do not: a polygon on the ground is theirs. */
export const isLevel = (support: Support): boolean => support.normal[2] > 0.9;
/** N, below which a foot is not one that the robot stands on. */
export const leastBearing = 20;

/** World placement of a support's frame, bodies placed as by forward(); null where it has none. */
export function footPlacement(run: Run, bodies: Placement[], support: Support): Placement | null {
  const frame = run.robot.frames.find(({ name }) => name === support.frame);
  return frame ? framePlacement(bodies, frame) : null;
}

/** The wrench of a row on a foot that is there; its numbers are NaN where the run has none. */
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

/** Corners of a sole in order, or of a ball the lowest point. */
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

/** Where the forces of all feet act together, weighed by what each bears; null of none. */
export function pressureOfAll(loads: FootLoad[]): Vec3 | null {
  const bearing = loads.filter(({ normal }) => normal > 0);
  const whole = bearing.reduce((sum, { normal }) => sum + normal, 0);
  if (!(whole > leastBearing)) return null;
  const mean = (k: 0 | 1 | 2): number =>
    bearing.reduce((sum, { normal, point }) => sum + (normal * point[k]) / whole, 0);
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

/** m, of the ground that a robot stands on; 0 where it stands on none. */
export function groundHeight(run: Run): number {
  const heights = (run.supports ?? []).filter(isLevel).map(({ point }) => point[2]);
  return heights.length > 0 ? Math.min(...heights) : 0;
}

/** Those that act at a time. */
export const pushesAt = (pushes: Push[], t: number): Push[] =>
  pushes.filter(({ start, duration }) => t >= start && t < start + duration);

/** A frame's name without what all of them have. */
export const shortFoot = (name: string): string =>
  name.replace(/_(link|frame|joint)$/, '').replace(/_/g, ' ');

/** Newton per 10 cm of arrow, such that the whole weight is about half a metre. */
export function weightScale(run: Run): number {
  const weight = run.robot.total_mass * Math.hypot(...run.robot.gravity);
  if (!(weight > 0)) return 100;
  const power = 10 ** Math.floor(Math.log10(weight / 5));
  return power * [1, 2, 5, 10].find((k) => k * power >= 0.8 * (weight / 5))!;
}
