// Forward kinematics: placements of bodies and frames from a configuration.

import type { Body, Joint, Placement, Robot, Vec3 } from './data';

export const identity = (): Placement => [0, 0, 0, 0, 0, 0, 1];

/** Vector v rotated by the quaternion p[3..6]. */
export function rotate(p: Placement, v: ArrayLike<number>): Vec3 {
  const [x, y, z, w] = [p[3], p[4], p[5], p[6]];
  const [a, b, c] = [v[0]!, v[1]!, v[2]!];
  const tx = 2 * (y * c - z * b);
  const ty = 2 * (z * a - x * c);
  const tz = 2 * (x * b - y * a);
  return [a + w * tx + y * tz - z * ty, b + w * ty + z * tx - x * tz, c + w * tz + x * ty - y * tx];
}

/** Composition of the placements a and b, where b is given in the frame of a. */
export function compose(a: Placement, b: Placement): Placement {
  const [px, py, pz] = rotate(a, b);
  const [ax, ay, az, aw] = [a[3], a[4], a[5], a[6]];
  const [bx, by, bz, bw] = [b[3], b[4], b[5], b[6]];
  return [
    a[0] + px,
    a[1] + py,
    a[2] + pz,
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

function aboutZ(angle: number, x = 0, y = 0, z = 0): Placement {
  return [x, y, z, 0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];
}

/** Angle [rad] or displacement [m] of a joint with one degree of freedom. */
export function jointValue(robot: Robot, joint: Joint, q: ArrayLike<number>): number {
  const { follows, q_index: o } = joint;
  if (follows) {
    const leader = robot.bodies[follows.leader]!.joint;
    return follows.multiplier * jointValue(robot, leader, q) + follows.offset;
  }
  return joint.kind === 'continuous' ? Math.atan2(q[o + 1] ?? 0, q[o] ?? 0) : (q[o] ?? 0);
}

/** Placement of the moving side of a joint in its fixed side. */
export function jointPlacement(robot: Robot, body: Body, q: ArrayLike<number>): Placement {
  const at = (k: number): number => q[body.joint.q_index + k] ?? 0;
  switch (body.joint.kind) {
    case 'revolute':
    case 'continuous':
      return aboutZ(jointValue(robot, body.joint, q));
    case 'prismatic':
      return [0, 0, jointValue(robot, body.joint, q), 0, 0, 0, 1];
    case 'planar':
      return aboutZ(Math.atan2(at(3), at(2)), at(0), at(1));
    case 'free_flyer': {
      const norm = Math.hypot(at(3), at(4), at(5), at(6)) || 1;
      return [at(0), at(1), at(2), at(3) / norm, at(4) / norm, at(5) / norm, at(6) / norm];
    }
    case 'ball': {
      const norm = Math.hypot(at(0), at(1), at(2), at(3)) || 1;
      return [0, 0, 0, at(0) / norm, at(1) / norm, at(2) / norm, at(3) / norm];
    }
  }
}

/** World placements of all bodies; parents come before their children. */
export function forward(robot: Robot, q: ArrayLike<number>): Placement[] {
  const out: Placement[] = [];
  for (const body of robot.bodies) {
    const local = compose(body.placement, jointPlacement(robot, body, q));
    out.push(body.parent < 0 ? local : compose(out[body.parent]!, local));
  }
  return out;
}

/** World placement of a frame; `bodies`: placements as forward() returns them. */
export function framePlacement(
  bodies: Placement[],
  frame: { body: number; placement: Placement },
): Placement {
  return frame.body < 0 ? frame.placement : compose(bodies[frame.body]!, frame.placement);
}

/** Interpolates between two configurations, s from 0 to 1; quaternions take the shorter path. */
export function interpolate(robot: Robot, a: ArrayLike<number>, b: ArrayLike<number>, s: number) {
  const q = new Float64Array(robot.nq);
  for (let i = 0; i < robot.nq; ++i) q[i] = a[i]! + s * (b[i]! - a[i]!);
  for (const { joint } of robot.bodies) {
    if (joint.kind !== 'free_flyer' && joint.kind !== 'ball') continue;
    const o = joint.q_index + joint.nq - 4;
    let dot = 0;
    for (let i = o; i < o + 4; ++i) dot += a[i]! * b[i]!;
    if (dot < 0) for (let i = o; i < o + 4; ++i) q[i] = (1 - s) * a[i]! - s * b[i]!;
  }
  return q;
}

/** Principal moments and axes of a symmetric 3x3 matrix by Jacobi rotations; axes in columns. */
export function principal(inertia: ArrayLike<number>): { moments: Vec3; axes: number[][] } {
  const [xx, yy, zz, xy, xz, yz] = Array.from(inertia) as [
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const a = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let sweep = 0; sweep < 12; ++sweep)
    for (const [p, q] of [
      [0, 1],
      [0, 2],
      [1, 2],
    ] as const) {
      if (Math.abs(a[p]![q]!) < 1e-15) continue;
      const angle = 0.5 * Math.atan2(2 * a[p]![q]!, a[q]![q]! - a[p]![p]!);
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      for (const m of [a, v])
        for (let k = 0; k < 3; ++k) {
          const [mp, mq] = [m[k]![p]!, m[k]![q]!];
          m[k]![p] = c * mp - s * mq;
          m[k]![q] = s * mp + c * mq;
        }
      for (let k = 0; k < 3; ++k) {
        const [ap, aq] = [a[p]![k]!, a[q]![k]!];
        a[p]![k] = c * ap - s * aq;
        a[q]![k] = s * ap + c * aq;
      }
    }
  const handed =
    v[0]![0]! * (v[1]![1]! * v[2]![2]! - v[1]![2]! * v[2]![1]!) -
    v[0]![1]! * (v[1]![0]! * v[2]![2]! - v[1]![2]! * v[2]![0]!) +
    v[0]![2]! * (v[1]![0]! * v[2]![1]! - v[1]![1]! * v[2]![0]!);
  if (handed < 0) for (let k = 0; k < 3; ++k) v[k]![2] = -v[k]![2]!;
  return { moments: [a[0]![0]!, a[1]![1]!, a[2]![2]!], axes: v };
}

/** Semi-axes of the ellipsoid of uniform density with this mass and these principal moments. */
export function ellipsoid(mass: number, [ix, iy, iz]: Vec3): Vec3 {
  const axis = (sum: number): number =>
    mass > 0 ? Math.sqrt(Math.max((2.5 * sum) / mass, 1e-8)) : 0;
  return [axis(iy + iz - ix), axis(ix + iz - iy), axis(ix + iy - iz)];
}
