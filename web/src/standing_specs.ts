// Plots of a standing robot: feet, centre of mass, momentum.

import { column, presses, type Run, type Support } from './data';
import { isLevel, shortFoot } from './supports';
import { categorical, runColour } from './theme';
import type { Curve, Level, PlotSpec } from './time_plot';

interface Written {
  unit: string;
  decimals: number;
  factor?: number;
}

/** Curves of one quantity of the supports. One run: a curve for each support. Several runs: a curve
 * for each run, with the support that is nearest to its limit in each row. */
function ofSupports(
  runs: Run[],
  which: (support: Support) => boolean,
  quantity: string,
  worst: 'largest' | 'smallest',
  written: Written,
): Curve[] {
  const { factor = 1, ...rest } = written;
  return runs.flatMap((run, i) => {
    const feet = (run.supports ?? []).filter(which).flatMap(({ frame }) => {
      const values = column(run, `support_${frame}_${quantity}`);
      return values ? [{ frame, values: values.map((v) => factor * v) }] : [];
    });
    if (feet.length === 0) return [];
    if (runs.length === 1)
      return feet.map(({ frame, values }, k) => ({
        label: shortFoot(frame),
        ...categorical(k),
        time: run.time,
        values,
        ...rest,
      }));
    const extreme = worst === 'largest' ? Math.max : Math.min;
    const values = run.time.map((_, k) => {
      const all = feet.map((foot) => foot.values[k]!).filter(Number.isFinite);
      return all.length > 0 ? extreme(...all) : NaN;
    });
    return [{ label: run.name, colour: runColour(i), time: run.time, values, ...rest }];
  });
}

const ofFeet = (runs: Run[], quantity: string, worst: 'largest' | 'smallest', written: Written) =>
  ofSupports(runs, isLevel, quantity, worst, written);

/** Curves of a vector; `fromStart` subtracts its first value. One run: a curve for each component.
 * Several runs: the length of the vector. */
function ofVector(runs: Run[], name: string, fromStart: boolean, written: Written): Curve[] {
  const { factor = 1, ...rest } = written;
  return runs.flatMap((run, i): Curve[] => {
    const axes = ['x', 'y', 'z'].map((axis) => column(run, `${name}_${axis}`));
    if (axes.some((values) => values === null)) return [];
    const entries = axes.map((values) =>
      values!.map((v) => factor * (v - (fromStart ? values![0]! : 0))),
    );
    const { time } = run;
    if (runs.length === 1)
      return entries.map((values, k) => ({
        label: 'xyz'[k]!,
        colour: 'xyz'[k]!,
        time,
        values,
        ...rest,
      }));
    const values = time.map((_, k) => Math.hypot(...entries.map((entry) => entry[k]!)));
    return [{ label: run.name, colour: runColour(i), time, values, ...rest }];
  });
}

const each = (runs: Run[], one: string, many: string): string => (runs.length > 1 ? many : one);

const loads = (runs: Run[]): PlotSpec => ({
  id: 'foot_load',
  title: 'Normal forces on the feet',
  about: each(
    runs,
    'Normal force of the ground on each foot (true)',
    'Normal force of the ground on the foot with the smallest load (true)',
  ),
  axis: 'force [N]',
  curves: ofFeet(runs, 'load', 'smallest', { unit: 'N', decimals: 1 }),
  height: 180,
});

/** Adds the target force of the first run. If the run has a tool, the target is the tool's. */
function withTarget(runs: Run[], curves: Curve[]): Curve[] {
  const run = runs[0];
  const values = run && !presses(run) ? column(run, 'force_target') : null;
  if (curves.length === 0 || !values) return curves;
  const look = { label: 'target', colour: 'target', dash: [7, 4], unit: 'N', decimals: 1 };
  return [...curves, { ...look, time: run!.time, values }];
}

/** Hands: supports on a surface that is not level, such as a wall. */
const hands = (runs: Run[]): PlotSpec => ({
  id: 'hand_force',
  title: 'Normal forces on the hands',
  about: each(
    runs,
    'Normal force of the wall on each hand (true)',
    'Normal force of the wall on the hand with the smallest force (true)',
  ),
  axis: 'force [N]',
  curves: withTarget(
    runs,
    ofSupports(runs, (support) => !isLevel(support), 'load', 'smallest', {
      unit: 'N',
      decimals: 1,
    }),
  ),
  height: 180,
});

function friction(runs: Run[]): PlotSpec {
  const percent = { unit: '%', decimals: 1, factor: 100 };
  const levels: Level[] = [{ value: 100, label: 'slides', colour: 'alarm' }];
  return {
    id: 'foot_friction',
    title: 'Used friction of the feet',
    about: each(
      runs,
      'Tangential force of each foot, as a fraction of its friction limit. Loads of at least 20 N only',
      'Largest tangential force of a foot, as a fraction of its friction limit. Loads of at least 20 N only',
    ),
    axis: 'friction limit [%]',
    curves: ofFeet(runs, 'friction_used', 'largest', percent),
    levels,
    range: [0, 112],
    height: 160,
  };
}

const pressure = (runs: Run[]): PlotSpec => ({
  id: 'foot_pressure',
  title: 'Centre of pressure',
  about: each(
    runs,
    'Distance of the centre of pressure from the edge of each sole, at loads of at least 20 N. 0: the foot tips',
    'Smallest distance of a centre of pressure from the edge of its sole. 0: the foot tips',
  ),
  axis: 'distance [mm]',
  curves: ofFeet(runs, 'pressure_margin', 'smallest', { unit: 'mm', decimals: 1, factor: 1e3 }),
  levels: [{ value: 0, label: 'edge', colour: 'alarm' }],
  height: 160,
});

const centre = (runs: Run[]): PlotSpec => ({
  id: 'com',
  title: 'Centre of mass',
  about: each(
    runs,
    'Displacement of the centre of mass since the start, in world axes',
    'Distance of the centre of mass from its position at the start',
  ),
  axis: 'distance [mm]',
  curves: ofVector(runs, 'com', true, { unit: 'mm', decimals: 2, factor: 1e3 }),
  height: 160,
});

const linear = (runs: Run[]): PlotSpec => ({
  id: 'momentum',
  title: 'Linear momentum',
  about: each(
    runs,
    'Linear momentum of the robot, in world axes',
    'Magnitude of the linear momentum of the robot',
  ),
  axis: 'momentum [kg m/s]',
  curves: ofVector(runs, 'momentum', false, { unit: 'kg m/s', decimals: 3 }),
  height: 160,
});

const angular = (runs: Run[]): PlotSpec => ({
  id: 'angular_momentum',
  title: 'Angular momentum',
  about: each(
    runs,
    'Angular momentum of the robot about its centre of mass, in world axes',
    'Magnitude of the angular momentum of the robot about its centre of mass',
  ),
  axis: 'momentum [kg m²/s]',
  curves: ofVector(runs, 'angular_momentum', false, { unit: 'kg m²/s', decimals: 3 }),
  height: 160,
});

/** Plots of a standing robot; empty for a robot with a fixed base. */
export const standingSpecs = (runs: Run[]): PlotSpec[] =>
  [hands, loads, friction, pressure, centre, linear, angular]
    .map((spec) => spec(runs))
    .filter((spec) => spec.curves.length > 0);
