// 3D scene of a robot without a run: solids, frames, inertias.

import {
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  SphereGeometry,
  Vector3,
} from 'three';
import type { Body, Frame, Robot } from './data';
import { ellipsoid, framePlacement, principal } from './kinematics';
import { Label, Triad } from './marks';
import { drawnSolids, place, RobotModel } from './robot_model';
import { colour, onTheme } from './theme';

const axes = (): Vector3[] => [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
export const axisColours = ['x', 'y', 'z'];

function inertiaOf(body: Body): Group | null {
  if (!(body.mass > 0)) return null;
  const { moments, axes: turned } = principal(body.inertia);
  const [a, b, c] = ellipsoid(body.mass, moments);
  const clear = new MeshStandardMaterial({ transparent: true, opacity: 0.38, depthWrite: false });
  const dot = new MeshBasicMaterial({ depthTest: false, transparent: true });
  const paint = (): void => {
    clear.color.set(colour('horizon'));
    dot.color.set(colour('ink'));
  };
  paint();
  onTheme(paint);
  const shape = new Mesh(new SphereGeometry(1, 32, 20), clear);
  const column = (i: number): Vector3 => new Vector3(turned[0]![i], turned[1]![i], turned[2]![i]);
  const turn = new Matrix4().makeBasis(column(0), column(1), column(2));
  shape.quaternion.setFromRotationMatrix(turn);
  shape.scale.set(a, b, c);
  shape.renderOrder = 2;
  const centre = new Mesh(new SphereGeometry(0.007, 16, 12), dot);
  centre.renderOrder = 4;
  const group = new Group();
  group.add(shape, centre);
  group.position.set(...body.com);
  return group;
}

/** Scene with the robot, its frames and its inertias. */
export class RobotScene {
  readonly group = new Group();
  readonly model: RobotModel;
  readonly inertias = new Group();
  readonly joints = new Group();
  readonly users = new Group();
  private readonly chosen = new Group();
  private readonly size: number;
  private readonly inertiaGroups: { body: number; group: Group }[] = [];
  private frame: Frame | null = null;

  constructor(readonly robot: Robot) {
    this.model = new RobotModel(robot, drawnSolids(robot));
    this.size = 0.045 * this.extent().radius;
    robot.bodies.forEach((body, i) => {
      const triad = new Triad(axes(), [], axisColours, this.size, 0.04 * this.size);
      const holder = new Group();
      holder.add(triad.group);
      this.joints.add(holder);
      const inertia = inertiaOf(body);
      if (!inertia) return;
      const follower = new Group();
      follower.add(inertia);
      this.inertias.add(follower);
      this.inertiaGroups.push({ body: i, group: follower });
    });
    for (const frame of robot.frames.filter((f) => f.kind === 'user')) {
      const holder = new Group();
      const triad = new Triad(axes(), [], axisColours, 1.5 * this.size, 0.05 * this.size);
      const label = new Label(frame.name, 'ink', 0.016);
      label.sprite.position.set(0, 0, -0.6 * this.size);
      holder.add(triad.group, label.sprite);
      holder.userData.frame = frame;
      this.users.add(holder);
    }
    this.group.add(this.model.group, this.inertias, this.joints, this.users, this.chosen);
  }

  setPosture(q: number[]): void {
    this.model.setPosture(q);
    const { placements } = this.model;
    this.joints.children.forEach((holder, i) => place(holder, placements[i]!));
    for (const { body, group } of this.inertiaGroups) place(group, placements[body]!);
    for (const holder of this.users.children)
      place(holder, framePlacement(placements, holder.userData.frame as Frame));
    if (this.frame) place(this.chosen, framePlacement(placements, this.frame));
  }

  choose(frame: Frame | null): void {
    this.frame = frame;
    this.chosen.clear();
    if (!frame) return;
    const triad = new Triad(
      axes(),
      ['x', 'y', 'z'],
      axisColours,
      2.6 * this.size,
      0.07 * this.size,
    );
    const label = new Label(frame.name, 'ink');
    label.sprite.position.set(0, 0, -0.7 * this.size);
    this.chosen.add(triad.group, label.sprite);
    place(this.chosen, framePlacement(this.model.placements, frame));
  }

  /** Sphere that contains all bodies and frames. */
  extent(): { centre: Vector3; radius: number } {
    const points = [
      ...this.model.placements,
      ...this.robot.frames.map((frame) => framePlacement(this.model.placements, frame)),
      ...this.robot.visuals.map((v) => framePlacement(this.model.placements, v)),
    ].map((p) => new Vector3(p[0], p[1], p[2]));
    const low = new Vector3(Infinity, Infinity, Infinity);
    const high = low.clone().negate();
    for (const p of points) {
      low.min(p);
      high.max(p);
    }
    if (points.length === 0) return { centre: new Vector3(), radius: 1 };
    const centre = low.clone().add(high).multiplyScalar(0.5);
    return { centre, radius: Math.max(0.6 * high.distanceTo(low), 0.15) + 0.05 };
  }
}
