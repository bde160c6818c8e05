// Specifications of the plots of one run, or of several runs that are compared.

import { column, type Interval, type Numbers, type Run } from './data';
import { categorical, runColour } from './theme';
import type { Curve, Level, PlotSpec } from './time_plot';

const scaled = (values: Numbers, factor: number): Float32Array => values.map((v) => v * factor);

/** One curve per run, in the run's colour. */
function perRun(
  runs: Run[],
  name: string,
  rest: { label: string; unit: string; decimals: number; factor?: number } & Partial<Curve>,
): Curve[] {
  const { factor = 1, label, ...options } = rest;
  return runs.flatMap((run, i) => {
    const values = column(run, name);
    if (!values) return [];
    const band = runs.length === 1 && factor === 1 ? run.envelopes.get(name) : undefined;
    return {
      ...(band ? { band } : {}),
      colour: runs.length > 1 ? runColour(i) : 'true',
      ...options,
      label: runs.length > 1 ? run.name : label,
      time: run.time,
      values: factor === 1 ? values : scaled(values, factor),
    };
  });
}

function normalForce(runs: Run[]): PlotSpec {
  const newton = { unit: 'N', decimals: 2 };
  const target = { colour: 'target', dash: [7, 4], label: 'target', rank: 2 };
  const curves: Curve[] = [];
  if (runs.length === 1) {
    const run = runs[0]!;
    const estimated = { label: 'estimated', colour: 'estimated', width: 1, rank: 1, ...newton };
    const measured = {
      label: 'measured',
      colour: 'measured',
      width: 1,
      hidden: true,
      rank: 3,
      ...newton,
    };
    curves.push(...perRun(runs, 'force_measured', measured));
    curves.push(...perRun(runs, 'force_estimated', estimated));
    const mean = column(run, 'force_normal_mean');
    const name = mean ? 'force_normal_mean' : 'force_normal';
    const label = mean ? 'true, 10 ms mean' : 'true';
    const band = run.envelopes.get('force_normal');
    curves.push(...perRun(runs, name, { label, width: 2, ...newton, ...(band ? { band } : {}) }));
  } else {
    runs.forEach((run, i) => {
      const name = column(run, 'force_normal_mean') ? 'force_normal_mean' : 'force_normal';
      const own = perRun([run], name, { label: run.name, ...newton });
      curves.push(...own.map((curve) => ({ ...curve, colour: runColour(i) })));
    });
  }
  curves.push(...perRun(runs.slice(0, 1), 'force_target', { ...newton, ...target }));
  return {
    id: 'force',
    title: 'Normal force',
    about:
      runs.length === 1
        ? 'Force of the surface on the tool, along the true normal n. Band: range of all samples'
        : 'Force of the surface on the tool, along the true normal n; mean over 10 ms',
    axis: 'force along n [N]',
    curves,
    height: 250,
  };
}

function tangentialForce(runs: Run[]): PlotSpec {
  const newton = { unit: 'N', decimals: 2 };
  const many = runs.length > 1;
  const curves = ['t1', 't2'].flatMap((t, i) =>
    perRun(runs, `force_${t}`, { label: `along t${'₁₂'[i]}`, ...newton }).map((curve) => ({
      ...curve,
      label: many ? `${curve.label}, t${'₁₂'[i]}` : curve.label,
      colour: many ? curve.colour : categorical(i).colour,
      dash: many && i === 1 ? [5, 3] : [],
    })),
  );
  return {
    id: 'tangential',
    title: 'Tangential force',
    about: 'Force of the surface on the tool (true), along the tangents t₁ and t₂ of the surface',
    axis: 'tangential force [N]',
    curves,
    height: 160,
  };
}

const pathError = (runs: Run[]): PlotSpec => ({
  id: 'path_error',
  title: 'Path error',
  about: 'Distance of the tip from its target, in the plane of the surface',
  axis: 'distance [mm]',
  curves: perRun(runs, 'path_error', { label: 'error', factor: 1e3, unit: 'mm', decimals: 3 }),
  height: 160,
});

/** Plot of one column of angles, in degrees. */
const angle = (
  runs: Run[],
  id: string,
  words: { title: string; about: string; decimals: number; height: number },
): PlotSpec => ({
  id,
  title: words.title,
  about: words.about,
  axis: 'angle [°]',
  curves: perRun(runs, id, {
    label: 'angle',
    factor: 180 / Math.PI,
    unit: '°',
    decimals: words.decimals,
  }),
  height: words.height,
});

const normalError = (runs: Run[]): PlotSpec =>
  angle(runs, 'normal_error', {
    title: 'Normal error',
    about:
      'Angle between the true surface normal at the tip and the normal that the controller uses',
    decimals: 3,
    height: 160,
  });

const toolTurned = (runs: Run[]): PlotSpec =>
  angle(runs, 'tool_turned', {
    title: 'Tool rotation',
    about: 'Rotation angle of the tool frame since the start of the run',
    decimals: 2,
    height: 150,
  });

const contact = (runs: Run[]): PlotSpec => ({
  id: 'contact',
  title: 'Contact',
  about: '1: the tool touches the surface; 0: no contact',
  axis: 'contact [1]',
  curves: perRun(runs, 'in_contact', {
    label: 'contact',
    unit: '',
    decimals: 0,
    stepped: true,
    ...(runs.length === 1 ? { colour: 'contact', fill: true } : {}),
  }),
  range: [-0.1, 1.15],
  height: 110,
});

function solverTime(runs: Run[]): PlotSpec {
  const curves: Curve[] = [];
  const levels: Level[] = [];
  runs.forEach((run, i) => {
    const { solver } = run;
    if (!solver) return;
    const label = runs.length > 1 ? run.name : 'solver';
    const tint = runs.length > 1 ? runColour(i) : 'true';
    const common = { time: solver.time, unit: 'ms', decimals: 3 };
    curves.push({ ...common, label, colour: tint, values: solver.solve_ms, width: 1 });
    if (solver.missed.some((m) => m > 0)) {
      const late = solver.solve_ms.map((v, k) => (solver.missed[k]! > 0 ? v : NaN));
      const name = runs.length > 1 ? `${run.name}, deadline missed` : 'deadline missed';
      curves.push({ ...common, label: name, colour: 'alarm', values: late, points: true });
    }
    if (levels.length > 0) return;
    levels.push({ value: solver.period_ms, label: 'update period', colour: 'muted' });
    if (solver.deadline_ms !== null)
      levels.push({ value: solver.deadline_ms, label: 'deadline', colour: 'alarm' });
  });
  const top = Math.max(...levels.map((level) => level.value), 0);
  return {
    id: 'solver',
    title: 'Solver time',
    about: 'Computing time of each plan, with the update period and the deadline',
    axis: 'time per update [ms]',
    curves,
    levels,
    ...(top > 0 ? { range: [0, 1.25 * top] as [number, number] } : {}),
    height: 170,
  };
}

function iterations(runs: Run[]): PlotSpec {
  const curves = runs.flatMap((run, i): Curve[] => {
    const { solver } = run;
    if (!solver || solver.iterations.every((n) => n === solver.iterations[1])) return [];
    const [label, tint] = runs.length > 1 ? [run.name, runColour(i)] : ['iterations', 'true'];
    const values = solver.iterations;
    return [
      { label, colour: tint, time: solver.time, values, unit: '', decimals: 0, stepped: true },
    ];
  });
  return {
    id: 'iterations',
    title: 'Solver iterations',
    about: 'Iterations of the solver for each plan',
    axis: 'iterations [1]',
    curves,
    height: 120,
  };
}

/** Number of active constraints. For one run, also marks infeasible plans and clipped torques. */
function limits(runs: Run[]): PlotSpec {
  const count = { unit: '', decimals: 0 };
  const curves = perRun(runs, 'active_constraints', { label: 'active', stepped: true, ...count });
  const [run] = runs;
  const active = run && column(run, 'active_constraints');
  const mark = (name: string, label: string, tint: string) => {
    const marked = run && column(run, name);
    if (!run || !active || !marked || runs.length > 1 || !marked.some((m) => m > 0)) return;
    const values = active.map((v, k) => (marked[k]! > 0 ? v : NaN));
    curves.push({ label, colour: tint, time: run.time, values, points: true, ...count });
  };
  mark('constraints_infeasible', 'infeasible plan', 'alarm');
  mark('clipped_torques', 'torque clipped', 'estimated');
  return {
    id: 'limits',
    title: 'Active constraints',
    about: 'Number of active inequality constraints of each plan, over all its knots',
    axis: 'constraints [1]',
    curves,
    height: 130,
  };
}

function costs(runs: Run[]): PlotSpec {
  const curves: Curve[] = [];
  runs.forEach((run, i) => {
    if (!run.costs) return;
    const { time, terms } = run.costs;
    if (runs.length > 1) {
      const values = time.map((_, k) => terms.reduce((sum, term) => sum + term.value[k]!, 0));
      curves.push({ label: run.name, colour: runColour(i), time, values, unit: '', decimals: 4 });
      return;
    }
    terms.forEach(({ name, value }, k) => {
      if (value.every((v) => !(v > 0))) return;
      curves.push({ label: name, ...categorical(k), time, values: value, unit: '', decimals: 4 });
    });
  });
  return {
    id: 'costs',
    title: runs.length > 1 ? 'Cost' : 'Cost by term',
    about: 'Cost of each plan, summed over its horizon',
    axis: 'cost [1], log scale',
    curves,
    log: true,
    height: 200,
  };
}

export const allJoints = 'all';

interface JointQuantity {
  id: 'tau' | 'q' | 'v';
  title: string;
  noun: string;
  about: string;
  unit: string;
}

const jointQuantities: JointQuantity[] = [
  {
    id: 'tau',
    title: 'Joint torques',
    noun: 'torque',
    about: 'Torques that the motors apply about the joint axes',
    unit: 'N m',
  },
  {
    id: 'q',
    title: 'Joint positions',
    noun: 'position',
    about: 'Positions of the joints, from their zero positions',
    unit: 'rad',
  },
  {
    id: 'v',
    title: 'Joint velocities',
    noun: 'velocity',
    about: 'Velocities of the joints about their axes',
    unit: 'rad/s',
  },
];

/** Values as a percentage of their range: -100 % at the lower limit, 100 % at the upper limit. */
function percentOfRange(values: Numbers, limit: Interval | undefined): Float32Array | null {
  const [low, high] = limit ?? [null, null];
  if (low === null || high === null || !(high > low)) return null;
  return values.map((v) => (200 * (v - low)) / (high - low) - 100);
}

/** Joint name without its ending "_joint", with spaces in place of underscores. */
export const shortJoint = (name: string): string => name.replace(/_joint$/, '').replace(/_/g, ' ');

/** Values of all joints that have limits, as percentages of their ranges. */
function jointPercentages(
  run: Run,
  id: 'tau' | 'q' | 'v',
): { name: string; values: Float32Array }[] {
  return run.robot.moving.flatMap((name, i) => {
    const values = column(run, `${id}_${name}`);
    const percentages = values && percentOfRange(values, run.limits[id]?.[i]);
    return percentages ? { name, values: percentages } : [];
  });
}

/** Largest absolute percentage over all joints, for each row. */
function largestPercentage(percentages: Float32Array[]): Float32Array {
  const largest = new Float32Array(percentages[0]?.length ?? 0);
  for (const values of percentages)
    for (let i = 0; i < largest.length; ++i)
      largest[i] = Math.max(largest[i]!, Math.abs(values[i]!));
  return largest;
}

function allJointsSpec(runs: Run[], quantity: JointQuantity): PlotSpec {
  const percent = { unit: '%', decimals: 1 };
  const curves: Curve[] = [];
  runs.forEach((run, r) => {
    const joints = jointPercentages(run, quantity.id);
    if (joints.length === 0) return;
    if (runs.length > 1) {
      const values = largestPercentage(joints.map((joint) => joint.values));
      curves.push({ label: run.name, colour: runColour(r), time: run.time, values, ...percent });
      return;
    }
    for (const { name, values } of joints) {
      const style = categorical(run.robot.moving.indexOf(name));
      curves.push({ label: shortJoint(name), ...style, time: run.time, values, ...percent });
    }
  });
  const level = (value: number, label: string): Level => ({ value, label, colour: 'alarm' });
  const many = runs.length > 1;
  return {
    id: quantity.id,
    title: quantity.title,
    about: many
      ? `${quantity.about}; only the joint nearest to a limit. 100 %: at the limit`
      : `${quantity.about}. −100 %: lower limit; 100 %: upper limit`,
    axis: `${quantity.noun} [% of limit]`,
    curves,
    levels: many ? [level(100, 'limit')] : [level(-100, 'lower limit'), level(100, 'upper limit')],
    range: many ? [0, 112] : [-112, 112],
    height: 200,
  };
}

function oneJointSpec(runs: Run[], quantity: JointQuantity, joint: string): PlotSpec {
  const { id, unit } = quantity;
  const decimals = id === 'tau' ? 2 : 4;
  const curves = perRun(runs, `${id}_${joint}`, { label: quantity.noun, unit, decimals });
  if (id === 'tau' && runs.length === 1) {
    curves[0] = { ...curves[0]!, label: 'applied' };
    const commanded = { label: 'commanded', colour: 'estimated', width: 1, unit, decimals };
    curves.unshift(...perRun(runs, `tau_command_${joint}`, commanded));
  }
  const index = runs[0]!.robot.moving.indexOf(joint);
  const [low, high] = runs[0]!.limits[id]?.[index] ?? [null, null];
  const levels: Level[] = [];
  if (low !== null) levels.push({ value: low, label: 'lower limit', colour: 'alarm' });
  if (high !== null) levels.push({ value: high, label: 'upper limit', colour: 'alarm' });
  const pad = 0.08 * ((high ?? 0) - (low ?? 0));
  return {
    id,
    title: quantity.title,
    about: `${quantity.about}: ${shortJoint(joint)}`,
    axis: `${quantity.noun} [${unit}]`,
    curves,
    levels,
    ...(low !== null && high !== null
      ? { range: [low - pad, high + pad] as [number, number] }
      : {}),
    height: 200,
  };
}

/** Plots of torques, positions and velocities of one joint or of all joints. */
export const jointSpecs = (runs: Run[], joint: string): PlotSpec[] =>
  jointQuantities.map((quantity) =>
    joint === allJoints ? allJointsSpec(runs, quantity) : oneJointSpec(runs, quantity, joint),
  );

const signalPrefix = 'signal_';

/** One plot for each unit of the signals that the controller published. */
function signals(runs: Run[]): PlotSpec[] {
  const units = new Map<string, string[]>();
  for (const run of runs)
    for (const [name, { unit }] of run.columns) {
      if (!name.startsWith(signalPrefix)) continue;
      const names = units.get(unit) ?? [];
      if (!names.includes(name)) units.set(unit, [...names, name]);
    }
  return [...units].map(([unit, names]) => {
    const shown = unit === '-' ? '1' : unit === 'Nm' ? 'N m' : unit;
    return {
      id: `${signalPrefix}${unit}`,
      title: `Signals of the controller [${shown}]`,
      about:
        'Values that the controller publishes, such as estimates; at most the seven with the largest values',
      axis: `signal [${shown}]`,
      curves: names.flatMap((name, i) =>
        perRun(runs, name, {
          label: name.slice(signalPrefix.length).replace(/_/g, ' '),
          unit: unit === '-' ? '' : shown,
          decimals: 4,
        }).map((curve) => ({
          ...curve,
          ...(runs.length > 1
            ? { label: `${curve.label}, ${name.slice(signalPrefix.length)}` }
            : categorical(i)),
        })),
      ),
      height: 170,
    };
  });
}

const withCurves = (specs: PlotSpec[]): PlotSpec[] => specs.filter((s) => s.curves.length > 0);

export const contactSpecs = (runs: Run[]): PlotSpec[] =>
  withCurves([
    pathError(runs),
    normalError(runs),
    contact(runs),
    tangentialForce(runs),
    toolTurned(runs),
  ]);
export const forceSpec = normalForce;
export const controllerSpecs = (runs: Run[]): PlotSpec[] =>
  withCurves([solverTime(runs), iterations(runs), limits(runs), costs(runs), ...signals(runs)]);
