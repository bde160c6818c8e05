// Plots of a robot that stands: its feet, its centre of mass, its momentum.

import { column, type Run, type Support } from './data';
import { isLevel, shortFoot } from './supports';
import { categorical, runColour } from './theme';
import type { Curve, Level, PlotSpec } from './time_plot';

interface Written {
  unit: string;
  decimals: number;
  factor?: number;
}

/** A quantity of each support; of several runs that of the one that comes nearest to its limit. */
function ofSupports(
  runs: Run[],
  which: (support: Support) => boolean,
  quantity: string,
  worst: 'most' | 'least',
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
    const of = worst === 'most' ? Math.max : Math.min;
    const values = run.time.map((_, k) => {
      const all = feet.map((foot) => foot.values[k]!).filter(Number.isFinite);
      return all.length > 0 ? of(...all) : NaN;
    });
    return [{ label: run.name, colour: runColour(i), time: run.time, values, ...rest }];
  });
}

const ofFeet = (runs: Run[], quantity: string, worst: 'most' | 'least', written: Written) =>
  ofSupports(runs, isLevel, quantity, worst, written);

/** A vector by its entries, less what it was at first where asked; of several runs its length. */
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
  title: 'Load of the feet',
  about: each(
    runs,
    'By the ground on each foot, true, along its normal',
    'By the ground on the foot that bears the least, true, along its normal',
  ),
  axis: 'force [N]',
  curves: ofFeet(runs, 'load', 'least', { unit: 'N', decimals: 1 }),
  height: 180,
});

/** Hands are supports that do not lie level: on a wall, as the feet are on the ground. */
const hands = (runs: Run[]): PlotSpec => ({
  id: 'hand_force',
  title: 'Force of the hands',
  about: each(
    runs,
    'By the wall on each hand, true, along its normal',
    'By the wall on the hand that presses the least, true, along its normal',
  ),
  axis: 'force [N]',
  curves: ofSupports(runs, (support) => !isLevel(support), 'load', 'least', {
    unit: 'N',
    decimals: 1,
  }),
  height: 180,
});

function friction(runs: Run[]): PlotSpec {
  const percent = { unit: '%', decimals: 1, factor: 100 };
  const levels: Level[] = [{ value: 100, label: 'slides', colour: 'alarm' }];
  return {
    id: 'foot_friction',
    title: 'Friction of the feet',
    about: each(
      runs,
      'Of its friction cone what each foot uses, while it bears 20 N',
      'Of its friction cone what the foot uses that uses the most, while it bears 20 N',
    ),
    axis: 'of the cone [%]',
    curves: ofFeet(runs, 'friction_used', 'most', percent),
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
    'How far it is from the edge of each sole, while that bears 20 N; the foot tips at 0',
    'How far it is from the edge of the sole where it is the nearest; the foot tips at 0',
  ),
  axis: 'distance [mm]',
  curves: ofFeet(runs, 'pressure_margin', 'least', { unit: 'mm', decimals: 1, factor: 1e3 }),
  levels: [{ value: 0, label: 'edge', colour: 'alarm' }],
  height: 160,
});

const centre = (runs: Run[]): PlotSpec => ({
  id: 'com',
  title: 'Centre of mass',
  about: each(
    runs,
    'From where it was at first, world axes',
    'How far it is from where it was at first',
  ),
  axis: 'distance [mm]',
  curves: ofVector(runs, 'com', true, { unit: 'mm', decimals: 2, factor: 1e3 }),
  height: 160,
});

const linear = (runs: Run[]): PlotSpec => ({
  id: 'momentum',
  title: 'Linear momentum',
  about: each(runs, 'Of the whole robot, world axes', 'Of the whole robot, its length'),
  axis: 'momentum [kg m/s]',
  curves: ofVector(runs, 'momentum', false, { unit: 'kg m/s', decimals: 3 }),
  height: 160,
});

const angular = (runs: Run[]): PlotSpec => ({
  id: 'angular_momentum',
  title: 'Angular momentum',
  about: each(
    runs,
    'Of the whole robot about its centre of mass, world axes',
    'Of the whole robot about its centre of mass, its length',
  ),
  axis: 'momentum [kg m²/s]',
  curves: ofVector(runs, 'angular_momentum', false, { unit: 'kg m²/s', decimals: 3 }),
  height: 160,
});

/** None of robots that are fixed. */
export const standingSpecs = (runs: Run[]): PlotSpec[] =>
  [hands, loads, friction, pressure, centre, linear, angular]
    .map((spec) => spec(runs))
    .filter((spec) => spec.curves.length > 0);
