// Marks of a standing robot in the 3D view: feet, their forces and friction cones, balance, pushes.

import {
  ConeGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  SphereGeometry,
  Vector3,
} from 'three';
import {
  column,
  rowAt,
  type Placement,
  type Push,
  type Run,
  type Support,
  type Vec3,
} from './data';
import { framePlacement } from './kinematics';
import { Arrow, Label, Line } from './marks';
import {
  corners,
  footLoad,
  footPlacement,
  hull,
  isLevel,
  isSole,
  minPressureLoad,
  pressureOfAll,
  pushesAt,
  weightScale,
  type FootLoad,
} from './supports';
import { colour, onTheme } from './theme';

const vector = (v: ArrayLike<number>): Vector3 => new Vector3(v[0], v[1], v[2]);
const up = new Vector3(0, 1, 0);
const above = 0.002; // height of marks over the ground, so that the ground does not hide them [m]

function painted(opacity: number, colourName: string, onTop = false): MeshBasicMaterial {
  const material = new MeshBasicMaterial({
    transparent: true,
    opacity,
    side: DoubleSide,
    depthWrite: false,
    depthTest: !onTop,
  });
  const paint = (): void => void material.color.set(colour(colourName));
  paint();
  onTheme(paint);
  return material;
}

function dot(radius: number, colourName: string): Mesh {
  const mesh = new Mesh(new SphereGeometry(radius, 20, 14), painted(1, colourName, true));
  mesh.renderOrder = 4;
  return mesh;
}

/** Ring of points around the contact point of a point foot. */
function ringAbout(middle: Vec3, radius: number): Vector3[] {
  return Array.from({ length: 33 }, (_, k) => {
    const angle = (2 * Math.PI * k) / 32;
    return new Vector3(
      middle[0] + radius * Math.cos(angle),
      middle[1] + radius * Math.sin(angle),
      middle[2],
    );
  });
}

/** Marks of one foot: its outline on the ground, its force, and its friction cone. */
class FootMarks {
  readonly group = new Group();
  private readonly outline = new Line('support', 3);
  private readonly arrow = new Arrow(0.008, 'support');
  private readonly cone: Mesh;
  private readonly pressure = dot(0.008, 'support');

  constructor(
    private readonly support: Support,
    private readonly perNewton: number,
  ) {
    // Cone with its apex at the origin, opening along y; height 1, radius of the rim 1.
    const shape = new ConeGeometry(1, 1, 40, 1, true).rotateX(Math.PI).translate(0, 0.5, 0);
    this.cone = new Mesh(shape, painted(0.16, 'support'));
    this.cone.renderOrder = 2;
    this.group.add(this.outline.object, this.arrow.group, this.cone, this.pressure);
  }

  update(foot: Placement, load: FootLoad): void {
    const { support } = this;
    const normal = vector(support.normal);
    const rim = corners(support, foot);
    const points = isSole(support)
      ? [...rim, rim[0]!].map(vector)
      : ringAbout(rim[0]!, support.radius);
    this.outline.setPoints(points.map((p) => p.addScaledVector(normal, above)));
    const loaded = load.normal > 1; // 1 N; chosen by hand
    this.arrow.group.visible = this.cone.visible = this.pressure.visible = loaded;
    if (!loaded) return;
    const point = vector(load.point);
    this.pressure.position.copy(point);
    this.arrow.set(point, vector(load.force).multiplyScalar(this.perNewton));
    // While the foot sticks, the head of the force arrow is inside the rim of the cone.
    const height = load.normal * this.perNewton;
    this.cone.position.copy(point);
    this.cone.quaternion.copy(new Quaternion().setFromUnitVectors(up, normal));
    this.cone.scale.set(support.friction * height, height, support.friction * height);
  }
}

/** Marks of the centre of mass, its projection, the support polygon, and the centre of pressure. */
class BalanceMarks {
  readonly group = new Group();
  private readonly mass = dot(0.02, 'mass');
  private readonly below = dot(0.011, 'mass');
  private readonly plumb = new Line('mass', 2, [0.02, 0.014], true);
  private readonly pressure = dot(0.013, 'pressure');
  private readonly polygon = new Line('polygon', 2.5, undefined, true);

  constructor() {
    const { mass, below, plumb, pressure, polygon } = this;
    this.group.add(mass, below, plumb.object, pressure, polygon.object);
  }

  update(com: Vec3, feet: { support: Support; foot: Placement; load: FootLoad }[]): void {
    const level = feet.filter(({ support }) => isLevel(support));
    const loaded = level.filter(({ load }) => load.normal > minPressureLoad);
    const ring = hull(loaded.flatMap(({ support, foot }) => corners(support, foot)));
    this.polygon.setPoints(
      [...ring, ...ring.slice(0, 1)].map((p) => vector(p).add(new Vector3(0, 0, 2 * above))),
    );
    const whole = pressureOfAll(level.map(({ load }) => load));
    this.pressure.visible = whole !== null;
    if (whole) this.pressure.position.set(...whole);
    const seen = com.every(Number.isFinite);
    this.mass.visible = this.below.visible = this.plumb.object.visible = seen;
    if (!seen) return;
    const ground = whole?.[2] ?? level[0]?.support.point[2] ?? 0;
    this.mass.position.set(...com);
    this.below.position.set(com[0], com[1], ground);
    this.plumb.setPoints([vector(com), new Vector3(com[0], com[1], ground)]);
  }
}

/** Arrows of pushes; each arrow ends at the point where its force acts. */
class PushMarks {
  readonly group = new Group();
  private readonly marks: { push: Push; arrow: Arrow; label: Label }[];

  constructor(
    private readonly run: Run,
    private readonly perNewton: number,
  ) {
    this.marks = (run.pushes ?? []).map((push) => {
      const arrow = new Arrow(0.009, 'alarm');
      const label = new Label(`${Math.hypot(...push.force).toFixed(0)} N`, 'alarm');
      this.group.add(arrow.group, label.sprite);
      return { push, arrow, label };
    });
  }

  update(t: number, bodies: Placement[]): void {
    const acting = pushesAt(this.run.pushes ?? [], t);
    for (const { push, arrow, label } of this.marks) {
      const frame = this.run.robot.frames.find(({ name }) => name === push.frame);
      label.sprite.visible = arrow.group.visible = frame !== undefined && acting.includes(push);
      if (!frame || !arrow.group.visible) continue;
      const force = vector(push.force);
      // At least 0.25 m long, so that small forces stay visible.
      const length = Math.max(this.perNewton * force.length(), 0.25);
      const along = force.normalize().multiplyScalar(length);
      const start = vector(framePlacement(bodies, frame)).sub(along);
      arrow.set(start, along);
      label.sprite.position.copy(start).addScaledVector(along, -0.12);
    }
  }
}

/** All marks of a run with supports or pushes. */
export class StandingScene {
  readonly feet = new Group();
  readonly balance = new Group();
  readonly pushes = new Group();
  private readonly marks: { support: Support; marks: FootMarks }[];
  private readonly balanceMarks: BalanceMarks | null;
  private readonly pushMarks: PushMarks;

  constructor(private readonly run: Run) {
    const perNewton = 0.1 / weightScale(run);
    this.marks = (run.supports ?? []).map((support) => ({
      support,
      marks: new FootMarks(support, perNewton),
    }));
    for (const { marks } of this.marks) this.feet.add(marks.group); // add() without arguments is an error
    this.balanceMarks = this.marks.length > 0 ? new BalanceMarks() : null;
    if (this.balanceMarks) this.balance.add(this.balanceMarks.group);
    this.pushMarks = new PushMarks(run, perNewton);
    this.pushes.add(this.pushMarks.group);
  }

  /** Updates all marks to time t; `bodies`: placements as forward() returns them. */
  update(t: number, bodies: Placement[]): void {
    const { run } = this;
    this.pushMarks.update(t, bodies);
    if (!this.balanceMarks) return;
    const row = rowAt(run.time, t);
    const feet = this.marks.flatMap(({ support, marks }) => {
      const foot = footPlacement(run, bodies, support);
      marks.group.visible = foot !== null;
      if (!foot) return [];
      const load = footLoad(run, support, foot, row);
      marks.update(foot, load);
      return [{ support, foot, load }];
    });
    const com = ['x', 'y', 'z'].map((axis) => column(run, `com_${axis}`)?.[row] ?? NaN) as Vec3;
    this.balanceMarks.update(com, feet);
  }
}
