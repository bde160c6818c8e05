// Data of a page: types of the format "burnish-page/1", decoding of its packed arrays, look-up by time.

export type Vec3 = [number, number, number];
/** px, py, pz, qx, qy, qz, qw */
export type Placement = [number, number, number, number, number, number, number];
export type Numbers = Float32Array;

interface PackedF32 {
  n: number;
  f32: string;
}
interface PackedU32 {
  n: number;
  u32: string;
}

export type JointKind = 'revolute' | 'continuous' | 'prismatic' | 'planar' | 'free_flyer' | 'ball';

export interface Joint {
  name: string;
  kind: JointKind;
  q_index: number;
  nq: number;
  lower: number | null;
  upper: number | null;
  effort: number | null;
  velocity: number | null;
  /** For a mimic joint: its value is multiplier * value of the leading joint + offset. */
  follows?: { leader: number; multiplier: number; offset: number } | null;
}

export interface Body {
  name: string;
  parent: number;
  joint: Joint;
  placement: Placement;
  mass: number;
  com: Vec3;
  /** ixx, iyy, izz, ixy, ixz, iyz about the centre of mass, in the axes of the joint [kg m^2] */
  inertia: [number, number, number, number, number, number];
}

export type Shape =
  | { kind: 'box'; size: Vec3 }
  | { kind: 'cylinder'; radius: number; length: number }
  | { kind: 'capsule'; radius: number; length: number }
  | { kind: 'sphere'; radius: number }
  | { kind: 'mesh'; name: string; vertices: Numbers | null; triangles: Uint32Array | null };

export interface Visual {
  body: number;
  link: string;
  placement: Placement;
  rgba: [number, number, number, number];
  shape: Shape;
}

export interface Frame {
  name: string;
  kind: 'link' | 'joint' | 'user';
  body: number;
  placement: Placement;
}

export interface Robot {
  name: string;
  moving: string[];
  bodies: Body[];
  nq: number;
  q: number[];
  visuals: Visual[];
  frames: Frame[];
  postures: { name: string; q: number[] }[];
  gravity: Vec3;
  total_mass: number;
}

export interface Column {
  name: string;
  unit: string;
  data: Numbers;
}

export interface Metric {
  name: string;
  label: string;
  value: number | null;
  unit: string;
  text: string;
}

export interface Phase {
  name: string;
  start: number;
  end: number;
}

export interface Solver {
  time: Numbers;
  solve_ms: Numbers;
  iterations: Numbers;
  missed: Numbers;
  period_ms: number;
  deadline_ms: number | null;
}

export interface Horizon {
  time: Numbers;
  knots: number;
  step: number;
  nq: number;
  q: Numbers;
}

export type Interval = [number | null, number | null] | null;

export interface Surface {
  point: Vec3;
  axes: number[];
  true_point: Vec3;
  true_axes: number[];
  friction: number;
  /** Half of the side length [m]; null: unbounded; missing in pages of older versions */
  extent?: number | null;
  /** Grid on a curved surface: side * side points with x, y, z [m]; missing for a plane */
  patch?: { side: number; points: Numbers } | null;
}

/** A foot of the plant: a planar foot (sole) in the x-y plane of a frame, or a point foot (ball). */
export interface Support {
  frame: string;
  /** Half of the side lengths of a sole [m]; 0 for a ball */
  half_x: number;
  half_y: number;
  /** Radius of a ball [m] */
  radius: number;
  /** A point of the ground [m], and its unit normal, out of the ground */
  point: Vec3;
  normal: Vec3;
  friction: number;
}

/** A force on the robot at the origin of a frame, in world axes [N], with its start and duration [s]. */
export interface Push {
  frame: string;
  start: number;
  duration: number;
  force: Vec3;
}

/** A constraint row along a planned motion: NaN at knots without the row. */
export interface PlannedLimit {
  name: string;
  /** Distance to the nearest limit, divided by the scale of the row */
  margin: Numbers;
  /** Multiplier: cost per scale of the row */
  multiplier: Numbers;
}

/** Data of a planned motion that was not simulated. */
export interface Plan {
  /** Frames with a target: columns NAME_x_world, NAME_x_world_target, NAME_distance_from_target */
  frames: string[];
  /** Columns of contact forces; each has a column NAME_target */
  forces: string[];
  limits: PlannedLimit[];
}

export interface Run {
  name: string;
  created: string;
  version: string;
  facts: [string, string][];
  command: string;
  outcome: string;
  succeeded: boolean;
  fault: { kind: string; time: number; text: string } | null;
  metrics: Metric[];
  task_file: string;
  duration: number;
  robot: Robot;
  /** The frame is empty if the robot has no tool. */
  tool: { frame: string; tip_radius: number };
  surface: Surface;
  /** Target path along the tangents [m]; h: height of a curved surface over the tangent plane [m] */
  path: { u: Numbers; w: Numbers; h?: Numbers };
  path_origin: Vec3;
  time: Numbers;
  columns: Map<string, Column>;
  envelopes: Map<string, { min: Numbers; max: Numbers }>;
  limits: { tau: Interval[]; v: Interval[]; q: Interval[] };
  phases: Phase[];
  solver: Solver | null;
  costs: { time: Numbers; terms: { name: string; value: Numbers }[] } | null;
  horizon: Horizon | null;
  window: [number, number] | null;
  /** Missing for a robot with a fixed base, and in pages of older versions */
  supports?: Support[];
  pushes?: Push[];
  /** Missing for a simulated run */
  plan?: Plan;
}

export interface Page {
  kind: 'run' | 'robot';
  title: string;
  version: string;
  created: string;
  runs: Run[];
  robot: Robot | null;
}

function bytes(text: string): Uint8Array<ArrayBuffer> {
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; ++i) out[i] = raw.charCodeAt(i);
  return out;
}

export function unpackF32(packed: PackedF32): Float32Array {
  const raw = bytes(packed.f32);
  return new Float32Array(raw.buffer, 0, raw.byteLength >> 2);
}

export function unpackU32(packed: PackedU32): Uint32Array {
  const raw = bytes(packed.u32);
  return new Uint32Array(raw.buffer, 0, raw.byteLength >> 2);
}

const isPacked = (value: object): value is PackedF32 | PackedU32 =>
  typeof (value as PackedF32).f32 === 'string' || typeof (value as PackedU32).u32 === 'string';

/** Replaces every packed array in a parsed JSON value by a typed array. */
function unpackAll(value: unknown): unknown {
  if (Array.isArray(value)) return typeof value[0] === 'object' ? value.map(unpackAll) : value;
  if (value === null || typeof value !== 'object') return value;
  if (isPacked(value)) return 'f32' in value ? unpackF32(value) : unpackU32(value);
  const out: Record<string, unknown> = {};
  for (const [key, part] of Object.entries(value)) out[key] = unpackAll(part);
  return out;
}

type Loose = Record<string, unknown>;

/** Current name of a solver figure; older pages use other names. */
const figureName = (name: string): string =>
  name.replace(/^solve_/, 'solver.').replace(/^(mean_iterations|missed_deadlines)$/, 'solver.$1');

function decodeRun(raw: Loose): Run {
  const series = raw.series as { time: Numbers; columns: Column[] };
  const envelopes = (raw.envelopes as { columns?: { name: string; min: Numbers; max: Numbers }[] })
    ?.columns;
  const { series: _series, ...rest } = raw;
  const metrics = (raw.metrics ?? []) as Metric[];
  return {
    ...(rest as unknown as Run),
    metrics: metrics.map((metric) => ({ ...metric, name: figureName(metric.name) })),
    time: series.time,
    columns: new Map(series.columns.map((column) => [column.name, column])),
    envelopes: new Map((envelopes ?? []).map(({ name, min, max }) => [name, { min, max }])),
  };
}

/** Replaces dashes in the kinds of joints by underscores. */
function normalizeKinds(robot: Robot | null | undefined): void {
  for (const { joint } of robot?.bodies ?? [])
    joint.kind = joint.kind.replace('-', '_') as JointKind;
}

/** Decodes the JSON of a page; null for an empty page. Throws an Error for another format. */
export function decodePage(text: string): Page | null {
  const raw = JSON.parse(text) as Loose | null;
  if (raw === null) return null;
  if (raw.format !== 'burnish-page/1')
    throw new Error(`its format is '${String(raw.format)}'; wanted 'burnish-page/1'`);
  const page = unpackAll(raw) as Loose & { runs?: Loose[] };
  const decoded: Page = { ...(page as unknown as Page), runs: (page.runs ?? []).map(decodeRun) };
  for (const robot of [decoded.robot, ...decoded.runs.map((run) => run.robot)])
    normalizeKinds(robot);
  return decoded;
}

/** Index of the last entry of `times` that is at most t; 0 if all entries are later. */
export function rowBefore(times: ArrayLike<number>, t: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle]! <= t) low = middle;
    else high = middle - 1;
  }
  return Math.max(low, 0);
}

/** Index of the entry of `times` nearest to t. */
export function rowAt(times: ArrayLike<number>, t: number): number {
  const row = rowBefore(times, t);
  if (row + 1 >= times.length) return row;
  return times[row + 1]! - t < t - times[row]! ? row + 1 : row;
}

export const column = (run: Run, name: string): Numbers | null =>
  run.columns.get(name)?.data ?? null;

/** Whether the run has a tool that presses on a surface. */
export const presses = (run: Run): boolean => !run.plan && run.tool.frame !== '';

/** Value of a column in the row nearest to time t; NaN for an unknown column. */
export function valueAt(run: Run, name: string, t: number): number {
  return column(run, name)?.[rowAt(run.time, t)] ?? NaN;
}

/** Indices of the corners of two triangles for each cell of a grid of side * side points. */
export function gridTriangles(side: number): Uint32Array {
  const corners: number[] = [];
  for (let i = 0; i + 1 < side; ++i)
    for (let k = 0; k + 1 < side; ++k) {
      const at = i * side + k;
      corners.push(at, at + side, at + 1, at + 1, at + side, at + side + 1);
    }
  return new Uint32Array(corners);
}

/** Normal of the surface in a row: the true one ('surface') or the controller's ('estimated'). Uses
 * the columns of the normal, which exist only if it changes over time, or else the axes. */
export function normalAt(run: Run, source: 'surface' | 'estimated', row: number): Vec3 {
  const axes = source === 'surface' ? run.surface.true_axes : run.surface.axes;
  const [x, y, z] = ['x', 'y', 'z'].map((axis) => column(run, `${source}_normal_${axis}`)?.[row]);
  if (x === undefined || y === undefined || z === undefined) return [axes[6]!, axes[7]!, axes[8]!];
  return [x, y, z];
}

/** Columns of the configuration, in the order of q; null if their number is not nq. */
export function configurationColumns(run: Run): Numbers[] | null {
  const all = [...run.columns.values()].filter((c) => c.name.startsWith('q_')).map((c) => c.data);
  return all.length === run.robot.nq ? all : null;
}
