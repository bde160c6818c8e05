// 3D scene of a run: robot, tool, surface, paths, forces, contact, horizon.

import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  RingGeometry,
  Sphere,
  SphereGeometry,
  Vector3,
} from 'three';
import {
  column,
  configurationColumns,
  gridTriangles,
  normalAt,
  presses,
  rowAt,
  rowBefore,
  valueAt,
  type Run,
  type Vec3,
} from './data';
import { forward, framePlacement, interpolate } from './kinematics';
import { Arrow, Line, Triad } from './marks';
import { drawnSolids, ghostMaterial, RobotModel } from './robot_model';
import { StandingScene } from './standing_scene';
import { isLevel } from './supports';
import { colour, onTheme } from './theme';
import type { View3D } from './view3d';

export const layers = [
  'forces',
  'feet',
  'balance',
  'pushes',
  'normals',
  'triad',
  'path',
  'trail',
  'horizon',
  'surface',
] as const;
export type Layer = (typeof layers)[number];

/** Whether a run has data for a layer. The layer of normals needs two normals that can differ. */
export function hasLayer(run: Run, layer: Layer): boolean {
  if (layer === 'horizon') return run.horizon !== null;
  if (layer === 'feet' || layer === 'balance') return (run.supports ?? []).length > 0;
  if (layer === 'trail' || layer === 'path') {
    if (run.plan) return run.plan.frames.length > 0;
  }
  if (layer === 'surface') return !run.plan;
  if (layer === 'pushes') return (run.pushes ?? []).length > 0;
  if (['forces', 'normals', 'triad', 'path'].includes(layer) && !presses(run)) return false;
  if (layer !== 'normals') return true;
  const { surface } = run;
  const moves = ['surface_normal_x', 'estimated_normal_x'].some((name) => column(run, name));
  return (
    moves || !!surface.patch || axisOf(surface.axes, 2).angleTo(axisOf(surface.true_axes, 2)) > 2e-3
  );
}

const vector = (v: ArrayLike<number>): Vector3 => new Vector3(v[0], v[1], v[2]);
const axisOf = (axes: number[], i: number): Vector3 => vector(axes.slice(3 * i, 3 * i + 3));

/** Force per 10 cm of arrow [N]: a round number near the largest target force. */
export function forceScale(runs: Run[]): number {
  let largest = 0;
  for (const run of runs)
    for (const f of column(run, 'force_target') ?? []) if (f > largest) largest = f;
  if (!(largest > 0)) return 30;
  const power = 10 ** Math.floor(Math.log10(largest));
  return power * [1, 2, 3, 5, 10].find((k) => k * power >= 0.85 * largest)!;
}

/** Position of the tool in a row of the trace. */
export function toolAt(run: Run, row: number): Vector3 {
  if (run.plan) return plannedPoint(run, run.tool.frame, '', row);
  const [x, y, z] = ['tool_x', 'tool_y', 'tool_z'].map((name) => column(run, name)?.[row] ?? NaN);
  return new Vector3(x, y, z);
}

/** Position of a frame of a planned motion in a row, or of its target (suffix '_target'). */
function plannedPoint(run: Run, frame: string, suffix: '' | '_target', row: number): Vector3 {
  const [x, y, z] = ['x', 'y', 'z'].map(
    (axis) => column(run, `${frame}_${axis}_world${suffix}`)?.[row] ?? NaN,
  );
  return new Vector3(x, y, z);
}

/** Pieces of the paths of all frames of a planned motion, or of their targets, in the order of time. */
function plannedPaths(run: Run, suffix: '' | '_target'): { pieces: Float32Array; times: number[] } {
  const pieces: number[] = [];
  const times: number[] = [];
  for (let row = 0; row + 1 < run.time.length; ++row)
    for (const frame of run.plan?.frames ?? []) {
      const piece = [row, row + 1].flatMap((at) => plannedPoint(run, frame, suffix, at).toArray());
      if (!piece.every(Number.isFinite)) continue;
      pieces.push(...piece);
      times.push(run.time[row + 1]!);
    }
  return { pieces: new Float32Array(pieces), times };
}

interface Trail {
  line: Line;
  /** Time at which each piece is complete [s] */
  times: number[];
}

/** Path of the tip on the surface during contact, in at most 3000 pieces. */
function trailOf(run: Run, width: number, colourName: string): Trail {
  if (run.plan) {
    const { pieces, times } = plannedPaths(run, '');
    const line = new Line(colourName, width);
    line.setPieces(pieces);
    return { line, times };
  }
  const contact = column(run, 'in_contact');
  const stride = Math.max(1, Math.ceil(run.time.length / 3000));
  const pieces: number[] = [];
  const times: number[] = [];
  const tip = (row: number): Vector3 =>
    toolAt(run, row).addScaledVector(
      vector(normalAt(run, 'surface', row)),
      0.0012 - run.tool.tip_radius,
    );
  for (let row = 0; row + stride < run.time.length; row += stride) {
    if (!(contact?.[row] && contact[row + stride])) continue;
    pieces.push(...tip(row).toArray(), ...tip(row + stride).toArray());
    times.push(run.time[row + stride]!);
  }
  const line = new Line(colourName, width);
  line.setPieces(new Float32Array(pieces));
  return { line, times };
}

/** 3D scene of one run. */
export class RunScene {
  readonly group = new Group();
  readonly contactPoint: Vector3;
  readonly normal: Vector3;
  readonly extent: number;
  private readonly parts = Object.fromEntries(layers.map((name) => [name, new Group()])) as Record<
    Layer,
    Group
  >;
  private readonly robot: RobotModel;
  private readonly ghost: RobotModel;
  private readonly ghostLine = new Line('horizon-line', 3, undefined, true);
  private readonly ball: Mesh;
  private readonly trail: Trail;
  private readonly triad: Triad;
  private readonly arrows = {
    true: new Arrow(0.0062, 'true'),
    estimated: new Arrow(0.0042, 'estimated'),
    target: new Arrow(0.0042, 'target'),
  };
  private readonly normals = {
    true: new Arrow(0.003, 'true', 0.85),
    estimated: new Arrow(0.003, 'estimated', 0.85),
  };
  private readonly standing: StandingScene;
  private readonly ring = new Group();
  private readonly held: Mesh;
  private readonly open: Mesh;
  private readonly plate = new Group();
  private readonly columns: Float32Array[] | null;
  private readonly tool: { body: number; placement: Run['robot']['frames'][0]['placement'] } | null;
  private plan = -1;
  private planned = false;
  private readonly shown: Record<Layer, boolean>;

  constructor(
    readonly run: Run,
    private readonly newtons: number,
  ) {
    const { surface, tool } = run;
    this.normal = axisOf(surface.true_axes, 2);
    const origin = vector(run.path_origin);
    this.contactPoint = origin.clone().addScaledVector(axisOf(surface.axes, 2), -tool.tip_radius);
    const reach = [...run.path.u, ...run.path.w].map(Math.abs).filter(Number.isFinite);
    this.extent = Math.max(0.05, ...reach);
    this.columns = configurationColumns(run);
    this.tool = run.robot.frames.find((frame) => frame.name === tool.frame) ?? null;
    this.shown = Object.fromEntries(layers.map((name) => [name, true])) as Record<Layer, boolean>;

    const solids = drawnSolids(run.robot);
    this.robot = new RobotModel(run.robot, solids);
    const clear = ghostMaterial();
    const paint = (): void => void clear.color.set(colour('horizon'));
    paint();
    onTheme(paint);
    this.ghost = new RobotModel(run.robot, solids, clear);
    this.ball = this.tipBall();
    this.trail = trailOf(run, 4, 'trail');
    this.triad = this.surfaceTriad();
    [this.held, this.open] = this.contactRings();
    this.standing = new StandingScene(run);
    this.drawPlate();
    this.assemble();
  }

  private tipBall(): Mesh {
    const material = new MeshStandardMaterial({ color: 0xb9c0c8, roughness: 0.35, metalness: 0.3 });
    const ball = new Mesh(new SphereGeometry(this.run.tool.tip_radius, 36, 24), material);
    ball.castShadow = true;
    return ball;
  }

  private surfaceTriad(): Triad {
    const axes = [0, 1, 2].map((i) => axisOf(this.run.surface.axes, i));
    return new Triad(axes, ['t₁', 't₂', 'n'], ['ink', 'ink', 'ink'], 0.125, 0.0013);
  }

  private contactRings(): [Mesh, Mesh] {
    const radius = Math.max(0.7 * this.run.tool.tip_radius, 0.008);
    const flat = (inner: number, outer: number, opacity: number): Mesh =>
      new Mesh(
        new RingGeometry(inner, outer, 48),
        new MeshBasicMaterial({
          transparent: true,
          opacity,
          side: DoubleSide,
          depthWrite: false,
        }),
      );
    const held = flat(1.15 * radius, 1.75 * radius, 1);
    const open = flat(1.6 * radius, 1.75 * radius, 0.8);
    held.renderOrder = open.renderOrder = 3;
    const paint = (): void => {
      (held.material as MeshBasicMaterial).color.set(colour('contact'));
      (open.material as MeshBasicMaterial).color.set(colour('muted'));
    };
    paint();
    onTheme(paint);
    this.ring.add(held, open);
    return [held, open];
  }

  /** Draws the patch of a curved surface, visible from both sides. */
  private drawPatch(patch: NonNullable<Run['surface']['patch']>): void {
    const shape = new BufferGeometry();
    shape.setAttribute('position', new BufferAttribute(patch.points, 3));
    shape.setIndex(new BufferAttribute(gridTriangles(patch.side), 1));
    shape.computeVertexNormals();
    const material = new MeshStandardMaterial({
      roughness: 0.9,
      transparent: true,
      side: DoubleSide,
    });
    const solid = new Mesh(shape, material);
    solid.receiveShadow = true;
    const { side, points } = patch;
    const lines: number[] = [];
    const corner = (i: number, k: number): number[] =>
      Array.from(points.subarray(3 * (i * side + k), 3 * (i * side + k) + 3));
    const every = Math.max(1, (side - 1) >> 3);
    for (let i = 0; i < side; i += every)
      for (let k = 0; k + 1 < side; ++k)
        lines.push(...corner(i, k), ...corner(i, k + 1), ...corner(k, i), ...corner(k + 1, i));
    const net = new BufferGeometry();
    net.setAttribute('position', new BufferAttribute(new Float32Array(lines), 3));
    const edge = new LineBasicMaterial({ transparent: true, opacity: 0.25 });
    const paint = (): void => {
      material.color.set(colour('plate'));
      edge.color.set(colour('ink'));
    };
    paint();
    onTheme(paint);
    this.plate.add(solid, new LineSegments(net, edge));
    this.parts.surface.add(this.plate);
  }

  /** Draws the surface as a plate, as large as the path if the surface is unbounded. Adds the outline
   * of the controller's nominal plane if the two differ. */
  private drawPlate(): void {
    const { surface } = this.run;
    if (surface.patch) return this.drawPatch(surface.patch);
    const half = surface.extent ?? this.extent + 0.11;
    const frame = (axes: number[], at: Vector3): Matrix4 =>
      new Matrix4().makeBasis(axisOf(axes, 0), axisOf(axes, 1), axisOf(axes, 2)).setPosition(at);
    const box = new BoxGeometry(2 * half, 2 * half, 0.018).translate(0, 0, -0.009);
    const material = new MeshStandardMaterial({ roughness: 0.9, transparent: true });
    const solid = new Mesh(box, material);
    solid.receiveShadow = true;
    const edge = new LineBasicMaterial({ transparent: true, opacity: 0.35 });
    const edges = new LineSegments(new EdgesGeometry(box), edge);
    const paint = (): void => {
      material.color.set(colour('plate'));
      edge.color.set(colour('ink'));
    };
    paint();
    onTheme(paint);
    this.plate.add(solid, edges);
    const level = vector(surface.true_point).sub(this.contactPoint).dot(this.normal);
    const middle = this.contactPoint.clone().addScaledVector(this.normal, level);
    this.plate.applyMatrix4(frame(surface.true_axes, middle));
    this.parts.surface.add(this.plate);

    const nominal = axisOf(surface.axes, 2);
    if (nominal.angleTo(this.normal) < 2e-3 && Math.abs(level) < 5e-4) return;
    const [t1, t2] = [axisOf(surface.axes, 0), axisOf(surface.axes, 1)];
    const corners = [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
      [-1, -1],
    ].map(([a, b]) =>
      this.contactPoint
        .clone()
        .addScaledVector(t1, a! * half)
        .addScaledVector(t2, b! * half),
    );
    const outline = new Line('estimated', 2, [0.012, 0.008]);
    outline.setPoints(corners);
    this.parts.surface.add(outline.object);
  }

  private assemble(): void {
    const { path, surface } = this.run;
    const [t1, t2, n] = [0, 1, 2].map((i) => axisOf(surface.axes, i)) as [
      Vector3,
      Vector3,
      Vector3,
    ];
    const stride = Math.max(1, Math.ceil(path.u.length / 1500));
    const points: Vector3[] = [];
    for (let i = 0; i < path.u.length; i += stride)
      points.push(
        this.contactPoint
          .clone()
          .addScaledVector(t1, path.u[i]!)
          .addScaledVector(t2, path.w[i]!)
          .addScaledVector(n, 0.002 + (path.h?.[i] ?? 0)),
      );
    const target = new Line('target', 2, [0.006, 0.004]);
    if (this.run.plan) target.setPieces(plannedPaths(this.run, '_target').pieces);
    else target.setPoints(points);
    target.object.renderOrder = 3;
    this.parts.path.add(target.object);
    this.parts.trail.add(this.trail.line.object);
    this.parts.triad.add(this.triad.group);
    const { arrows } = this;
    this.parts.forces.add(arrows.true.group, arrows.estimated.group, arrows.target.group);
    this.parts.normals.add(this.normals.true.group, this.normals.estimated.group);
    for (const name of ['forces', 'normals', 'triad', 'path', 'surface'] as const)
      this.parts[name].visible = this.has(name);
    this.ball.visible = this.ring.visible = presses(this.run);
    this.parts.feet.add(this.standing.feet);
    this.parts.balance.add(this.standing.balance);
    this.parts.pushes.add(this.standing.pushes);
    this.parts.horizon.add(this.ghost.group, this.ghostLine.object);
    this.group.add(this.robot.group, this.ball, this.ring, ...Object.values(this.parts));
  }

  has(layer: Layer): boolean {
    return hasLayer(this.run, layer);
  }

  show(layer: Layer, on: boolean): void {
    this.shown[layer] = on;
    this.parts[layer].visible = on && this.has(layer) && (layer !== 'horizon' || this.planned);
  }

  update(t: number): void {
    const { run } = this;
    const row = rowBefore(run.time, t);
    const next = Math.min(row + 1, run.time.length - 1);
    const gap = run.time[next]! - run.time[row]!;
    const s = gap > 0 ? Math.min(Math.max((t - run.time[row]!) / gap, 0), 1) : 0;
    if (this.columns) {
      const at = (r: number): number[] => this.columns!.map((c) => c[r]!);
      this.robot.setPosture(interpolate(run.robot, at(row), at(next), s));
    }
    this.standing.update(t, this.robot.placements);
    const tool = toolAt(run, row).lerp(toolAt(run, next), s);
    if (Number.isFinite(tool.x)) this.ball.position.copy(tool);
    if (!run.plan) this.updateContact(t, tool);
    const count = this.trail.times.length === 0 || t < this.trail.times[0]! ? 0 : 1;
    this.trail.line.upTo(count && rowBefore(this.trail.times, t) + 1);
    this.updateHorizon(t);
  }

  /** Signed distance of a point from the surface along the normal [m]. */
  private above(point: Vector3, normal: Vector3): number {
    const { patch, true_point: origin } = this.run.surface;
    const nearest = vector(origin);
    if (patch) {
      const candidate = new Vector3();
      for (let i = 0; i < patch.points.length; i += 3) {
        candidate.fromArray(patch.points, i);
        if (candidate.distanceToSquared(point) < nearest.distanceToSquared(point))
          nearest.copy(candidate);
      }
    }
    return point.clone().sub(nearest).dot(normal);
  }

  private updateContact(t: number, tool: Vector3): void {
    const { run } = this;
    const row = rowAt(run.time, t);
    const normal = vector(normalAt(run, 'surface', row)).normalize();
    const contact = valueAt(run, 'in_contact', t) > 0.5;
    const point = tool.clone().addScaledVector(normal, -run.tool.tip_radius);
    const above = this.above(point, normal);
    const foot = point.clone().addScaledVector(normal, -above);
    this.held.visible = contact;
    this.open.visible = !contact;
    this.ring.position.copy(foot).addScaledVector(normal, 0.0016);
    this.ring.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
    this.triad.group.position.copy(contact ? point : foot);

    const perNewton = 0.1 / this.newtons;
    const force = (name: string): number => {
      const f = valueAt(run, name, t);
      return Number.isFinite(f) ? f * perNewton : 0;
    };
    // The columns are components along the normal at this time and two fixed tangents of the surface.
    const [a1, a2] = [axisOf(run.surface.true_axes, 0), axisOf(run.surface.true_axes, 1)];
    const [b1, b2, b3] = [a2.clone().cross(normal), normal.clone().cross(a1), a1.clone().cross(a2)];
    const acting = b3
      .clone()
      .multiplyScalar(force('force_normal'))
      .addScaledVector(b1, force('force_t1'))
      .addScaledVector(b2, force('force_t2'))
      .divideScalar(Math.max(normal.dot(b3), 0.1));
    const estimated = vector(normalAt(run, 'estimated', row)).normalize();
    const length = 0.16;
    this.normals.true.set(point, normal.clone().multiplyScalar(length));
    this.normals.estimated.set(point, estimated.clone().multiplyScalar(length));
    this.arrows.true.set(point, acting);
    this.arrows.estimated.set(point, estimated.clone().multiplyScalar(force('force_estimated')));
    this.arrows.target.set(point, estimated.clone().multiplyScalar(force('force_target')));
  }

  private updateHorizon(t: number): void {
    const { horizon, robot } = this.run;
    if (!horizon || horizon.time.length === 0) return;
    const plan = rowBefore(horizon.time, t + 1e-6);
    const age = t - horizon.time[plan]!;
    const spacing = plan > 0 ? horizon.time[plan]! - horizon.time[plan - 1]! : 0.05;
    this.planned = age > -1e-6 && age < Math.max(3 * spacing, 0.05);
    this.parts.horizon.visible = this.planned && this.shown.horizon;
    if (!this.planned || plan === this.plan) return;
    this.plan = plan;
    const { knots, nq } = horizon;
    const q = (k: number): Float32Array =>
      horizon.q.subarray((plan * knots + k) * nq, (plan * knots + k + 1) * nq);
    this.ghost.setPosture(q(knots - 1));
    if (!this.tool) return;
    const points: Vector3[] = [];
    for (let k = 0; k < knots; ++k) {
      const p = framePlacement(forward(robot, q(k)), this.tool);
      if (p.every(Number.isFinite)) points.push(vector(p));
    }
    this.ghostLine.setPoints(points);
  }

  /** Shifts the arrows apart as seen from the camera; fades the plate if it would hide the tool. */
  faceCamera(view: View3D): void {
    const towards = view.camera.position.clone().sub(this.contactPoint);
    const side = new Vector3().crossVectors(this.normal, towards).normalize();
    const behind = towards.dot(this.normal) < 0;
    const material = (this.plate.children[0] as Mesh).material as MeshStandardMaterial;
    material.opacity = behind ? 0.22 : 1;
    material.depthWrite = !behind;
    const base = this.arrows.true.group.position;
    this.arrows.estimated.group.position.copy(base).addScaledVector(side, 0.021);
    this.arrows.target.group.position.copy(base).addScaledVector(side, -0.021);
  }

  /** Position of the tool frame of the drawn robot [m]; null without a tool frame. */
  drawnTool(): Vec3 | null {
    if (!this.tool) return null;
    const p = framePlacement(this.robot.placements, this.tool);
    return [p[0], p[1], p[2]];
  }

  /** Named viewpoints: point to look at, direction from it to the camera, radius that must be visible. */
  viewpoints(): { name: string; target: Vector3; from: Vector3; radius: number }[] {
    const p = this.contactPoint;
    const base = this.run.robot.bodies[0]?.placement ?? [0, 0, 0];
    const ahead = new Vector3(p.x - base[0], p.y - base[1], 0);
    if (ahead.length() < 1e-3) ahead.set(1, 0, 0);
    ahead.normalize();
    const right = new Vector3(ahead.y, -ahead.x, 0);
    const level = new Vector3(this.normal.x, this.normal.y, 0);
    const upright = level.length() > 0.3;
    // An upright surface is seen from its side that is farther from the robot, a level one from ahead.
    const along = new Vector3(-this.normal.y, this.normal.x, 0).normalize();
    if (along.dot(ahead) < 0) along.negate();
    const side = upright ? along : right;
    const from = upright
      ? along
          .clone()
          .addScaledVector(this.normal, 0.45)
          .add(new Vector3(0, 0, 0.35))
      : right
          .clone()
          .multiplyScalar(0.55)
          .addScaledVector(ahead, 0.85)
          .add(new Vector3(0, 0, 0.5));
    const { middle, radius } = this.wholeRobot();
    const above = this.normal.clone().add(new Vector3(-0.001, 0, 0.0005));
    const feet = (this.run.supports ?? []).filter(isLevel).map(({ point }) => vector(point));
    if (feet.length > 0) return this.standingViews(feet, from, above);
    if (this.run.plan)
      return [
        { name: 'Robot', target: middle, from, radius },
        { name: 'Side', target: middle, from: side, radius },
      ];
    return [
      { name: 'Robot', target: middle, from, radius },
      {
        name: 'Contact',
        target: p.clone().addScaledVector(this.normal, 0.03),
        from: from.clone().addScaledVector(this.normal, 0.3),
        radius: this.extent + 0.13,
      },
      { name: 'Along n', target: p, from: above, radius: this.extent + 0.07 },
      { name: 'Side', target: middle, from: side, radius },
    ];
  }

  /** Sphere around all bodies and the point of contact, with a margin for the links. */
  private wholeRobot(): { middle: Vector3; radius: number } {
    const box = new Box3().setFromPoints([this.contactPoint]);
    for (const [x, y, z] of this.robot.placements) box.expandByPoint(new Vector3(x, y, z));
    const ball = box.getBoundingSphere(new Sphere());
    return { middle: ball.center, radius: Math.max(1.15 * ball.radius + 0.12, 0.45) };
  }

  /** Viewpoints of a standing robot; `from` and `above` are directions to the camera. */
  private standingViews(
    feet: Vector3[],
    from: Vector3,
    above: Vector3,
  ): ReturnType<RunScene['viewpoints']> {
    const p = this.contactPoint;
    const middle = feet
      .reduce((sum, foot) => sum.add(foot), new Vector3())
      .divideScalar(feet.length);
    const spread = Math.max(0.2, ...feet.map((foot) => foot.distanceTo(middle)));
    const height = Math.max(...this.robot.placements.map(([, , z]) => z), p.z) - middle.z;
    const body = middle.clone().add(new Vector3(0, 0, 0.52 * height));
    const ahead = new Vector3(p.x - middle.x, p.y - middle.y, 0);
    if (ahead.length() < 0.1) ahead.set(1, 0, 0); // without a pressed surface
    ahead.normalize();
    const side = new Vector3(-ahead.y, ahead.x, 0.12);
    // The radius covers the height of the robot, or the spread of its feet if that is larger.
    const radius = Math.max(0.68 * height, 2.4 * spread);
    const tool = [
      {
        name: 'Contact',
        target: p.clone().addScaledVector(this.normal, 0.03),
        from: from.clone().addScaledVector(this.normal, 0.3),
        radius: this.extent + 0.13,
      },
      { name: 'Along n', target: p, from: above, radius: this.extent + 0.07 },
    ];
    return [
      { name: 'Robot', target: body, from, radius },
      ...(presses(this.run) ? tool : []),
      {
        name: 'Feet',
        target: middle.clone().add(new Vector3(0, 0, 0.12)),
        from: ahead
          .clone()
          .multiplyScalar(0.75)
          .add(new Vector3(-ahead.y, ahead.x, 0.85)),
        radius: 1.9 * spread + 0.15,
      },
      { name: 'Side', target: body, from: side, radius },
    ];
  }
}

/** Tool tip and path of another run of the comparison. */
export class OtherTool {
  readonly group = new Group();
  private readonly ball: Mesh;
  private readonly trail: Trail;

  constructor(
    readonly run: Run,
    colourName: string,
  ) {
    const material = new MeshBasicMaterial({ transparent: true, opacity: 0.55 });
    const paint = (): void => void material.color.set(colour(colourName));
    paint();
    onTheme(paint);
    this.ball = new Mesh(new SphereGeometry(run.tool.tip_radius, 24, 16), material);
    this.trail = trailOf(run, 2.5, colourName);
    this.group.add(this.ball, this.trail.line.object);
  }

  update(t: number): void {
    this.ball.position.copy(toolAt(this.run, rowBefore(this.run.time, t)));
    const { times, line } = this.trail;
    line.upTo(times.length === 0 || t < times[0]! ? 0 : rowBefore(times, t) + 1);
  }
}
