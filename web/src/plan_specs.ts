// Plots of a planned motion: distances from its targets, contact forces, constraints.

import { column, type PlannedLimit, type Run } from './data';
import { categorical, runColour } from './theme';
import type { Curve, PlotSpec } from './time_plot';

/** Largest number of curves in a plot; there are seven colours. */
const maxCurves = 7;

const distances = (runs: Run[]): PlotSpec => ({
  id: 'plan_distance',
  title: 'Distance from the target',
  about: 'Distance of each frame from its target, along the axes with a nonzero weight',
  axis: 'distance [mm]',
  curves: runs.flatMap((run, r) =>
    (run.plan?.frames ?? []).flatMap((frame, i): Curve[] => {
      const values = column(run, `${frame}_distance_from_target`);
      if (!values || !values.some(Number.isFinite)) return [];
      return [
        {
          label: runs.length > 1 ? `${run.name}, ${frame}` : frame,
          ...categorical(i),
          ...(runs.length > 1 ? { colour: runColour(r) } : {}),
          time: run.time,
          values: values.map((v) => 1e3 * v),
          unit: 'mm',
          decimals: 3,
        },
      ];
    }),
  ),
  height: 160,
});

/** Forces or moments of the contacts of one plan, with dashed curves for their targets. */
function forces(run: Run, moments: boolean): PlotSpec {
  const names = (run.plan?.forces ?? []).filter(
    (name) => (run.columns.get(name)?.unit === 'Nm') === moments,
  );
  const unit = moments ? 'N m' : 'N';
  const curves = names.slice(0, maxCurves).flatMap((name, i) =>
    ['', '_target'].flatMap((suffix): Curve[] => {
      const values = column(run, name + suffix);
      if (!values || !values.some(Number.isFinite)) return [];
      const label = name.replace(/_/g, ' ') + (suffix ? ', target' : '');
      const { colour } = categorical(i);
      const style = { colour, dash: suffix ? [7, 4] : [] };
      return [{ label, ...style, time: run.time, values, unit, decimals: 2 }];
    }),
  );
  return {
    id: moments ? 'plan_moments' : 'plan_forces',
    title: moments ? 'Contact moments' : 'Contact forces',
    about: `${moments ? 'Moments' : 'Forces'} of the contacts on the robot, in the axes of each contact`,
    axis: `${moments ? 'moment' : 'force'} [${unit}]`,
    curves,
    height: 200,
  };
}

function limitCurves(run: Run, quantity: 'margin' | 'multiplier'): Curve[] {
  const all = run.plan?.limits ?? [];
  // A constraint row that exists at one knot only, such as the last one, is drawn as a point.
  const isLine = ({ margin }: PlannedLimit): boolean => margin.filter(Number.isFinite).length > 1;
  const lines = all.filter(isLine);
  const shown = (lines.length > 0 ? lines : all).slice(0, maxCurves);
  return shown.map((limit: PlannedLimit, i) => ({
    points: !isLine(limit),
    label: limit.name,
    ...categorical(i),
    time: run.time,
    values: limit[quantity],
    stepped: quantity === 'multiplier',
    unit: '',
    decimals: 4,
  }));
}

const limits = (run: Run): PlotSpec[] => [
  {
    id: 'plan_margins',
    title: 'Distance from limits',
    about:
      'Constraint rows with the largest multipliers. Distance divided by the scale of the row; 0: at the limit',
    axis: 'distance / scale [1]',
    curves: limitCurves(run, 'margin'),
    levels: [{ value: 0, label: 'limit', colour: 'alarm' }],
    height: 200,
  },
  {
    id: 'plan_multipliers',
    title: 'Constraint multipliers',
    about: 'Cost per scale of the row; 0: the constraint is inactive',
    axis: 'multiplier [cost per scale]',
    curves: limitCurves(run, 'multiplier'),
    height: 160,
  },
];

export function planSpecs(runs: Run[]): PlotSpec[] {
  const specs = [distances(runs)];
  const [run] = runs;
  if (run?.plan && runs.length === 1)
    specs.push(forces(run, false), forces(run, true), ...limits(run));
  return specs.filter(({ curves }) => curves.length > 0);
}
