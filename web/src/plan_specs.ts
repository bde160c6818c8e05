// Plots of a planned motion: how far it is from its targets, its contact forces, its limits.

import { column, type PlannedLimit, type Run } from './data';
import { categorical, runColour } from './theme';
import type { Curve, PlotSpec } from './time_plot';

/** Curves that a plot can tell apart. */
const mostCurves = 7;

const distances = (runs: Run[]): PlotSpec => ({
  id: 'plan_distance',
  title: 'Distance from the target',
  about: 'Of each frame, along the axes that have a weight',
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

/** Forces or moments of the contacts of one plan, dashed their targets. */
function forces(run: Run, moments: boolean): PlotSpec {
  const names = (run.plan?.forces ?? []).filter(
    (name) => (run.columns.get(name)?.unit === 'Nm') === moments,
  );
  const unit = moments ? 'N m' : 'N';
  const curves = names.slice(0, mostCurves).flatMap((name, i) =>
    ['', '_target'].flatMap((of): Curve[] => {
      const values = column(run, name + of);
      if (!values || !values.some(Number.isFinite)) return [];
      const label = name.replace(/_/g, ' ') + (of ? ', target' : '');
      const { colour } = categorical(i);
      const style = { colour, dash: of ? [7, 4] : [] };
      return [{ label, ...style, time: run.time, values, unit, decimals: 2 }];
    }),
  );
  return {
    id: moments ? 'plan_moments' : 'plan_forces',
    title: moments ? 'Contact moments' : 'Contact forces',
    about: 'On the robot, in the axes of each contact',
    axis: `${moments ? 'moment' : 'force'} [${unit}]`,
    curves,
    height: 200,
  };
}

function limitCurves(run: Run, of: 'margin' | 'multiplier'): Curve[] {
  const all = run.plan?.limits ?? [];
  // Rows of one knot alone, such as those of the end, are points.
  const isLine = ({ margin }: PlannedLimit): boolean => margin.filter(Number.isFinite).length > 1;
  const lines = all.filter(isLine);
  const shown = (lines.length > 0 ? lines : all).slice(0, mostCurves);
  return shown.map((limit: PlannedLimit, i) => ({
    points: !isLine(limit),
    label: limit.name,
    ...categorical(i),
    time: run.time,
    values: limit[of],
    stepped: of === 'multiplier',
    unit: '',
    decimals: 4,
  }));
}

const limits = (run: Run): PlotSpec[] => [
  {
    id: 'plan_margins',
    title: 'Distance from limits',
    about: 'Of the rows whose limits push hardest, by the scale of each row; 0 at the limit',
    axis: 'distance [scale of the row]',
    curves: limitCurves(run, 'margin'),
    levels: [{ value: 0, label: 'limit', colour: 'alarm' }],
    height: 200,
  },
  {
    id: 'plan_multipliers',
    title: 'Multipliers of limits',
    about: 'Cost that a limit adds, by the scale of its row; 0 where it does not push',
    axis: 'cost [1]',
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
