// Tests of kinematics, decoding and supports, in node; the sources are bundled when the tests start.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { build } from 'vite';

async function load(entry) {
  const built = await build({
    configFile: false,
    logLevel: 'silent',
    build: { write: false, minify: false, lib: { entry, formats: ['es'] } },
  });
  const code = built[0].output[0].code;
  return import(`data:text/javascript;base64,${Buffer.from(code).toString('base64')}`);
}
const data = await load('src/data.ts');
const kinematics = await load('src/kinematics.ts');
const supports = await load('src/supports.ts');
const spans = await load('src/plot_span.ts');

const near = (a, b, tolerance = 1e-12) => {
  assert.equal(a.length, b.length);
  a.forEach((v, i) => assert.ok(Math.abs(v - b[i]) < tolerance, `${i}: ${v} is not ${b[i]}`));
};
const half = Math.SQRT1_2;

function body(parent, kind, q_index, placement) {
  const nq = { revolute: 1, prismatic: 1, continuous: 2, planar: 4, free_flyer: 7, ball: 4 }[kind];
  return { parent, placement, joint: { name: `${kind}_${q_index}`, kind, q_index, nq } };
}

test('forward kinematics of a chain of joints gives the expected placements', () => {
  // A revolute joint about z at 1 m, one about the x axis of the first, and a prismatic joint along z.
  const robot = {
    nq: 3,
    bodies: [
      body(-1, 'revolute', 0, [0, 0, 1, 0, 0, 0, 1]),
      body(0, 'revolute', 1, [0.5, 0, 0, 0, half, 0, half]),
      body(1, 'prismatic', 2, [0, 0, 0, 0, 0, 0, 1]),
    ],
  };
  const [first, second, third] = kinematics.forward(robot, [Math.PI / 2, 0.3, 0.2]);
  near(first, [0, 0, 1, 0, 0, half, half]);
  near(second.slice(0, 3), [0, 0.5, 1]);
  near(third.slice(0, 3), [0, 0.7, 1]);
  near([Math.hypot(...third.slice(3))], [1]);
});

test('joints with more than one number follow their conventions', () => {
  const at = (kind, q) =>
    kinematics.forward({ nq: q.length, bodies: [body(-1, kind, 0, [0, 0, 0, 0, 0, 0, 1])] }, q)[0];
  near(at('continuous', [0, 1]), [0, 0, 0, 0, 0, half, half]);
  near(at('planar', [1, 2, 0, -1]), [1, 2, 0, 0, 0, -half, half]);
  near(at('free_flyer', [1, 2, 3, 0, 2, 0, 2]), [1, 2, 3, 0, half, 0, half]);
  near(at('ball', [0, 2, 0, 2]), [0, 0, 0, 0, half, 0, half]);
});

test('mimic joints follow their leaders', () => {
  const joint = (parent, kind, q_index, follows) => {
    const made = body(parent, kind, q_index, [0, 0, 0, 0, 0, 0, 1]);
    return { ...made, joint: { ...made.joint, nq: follows ? 0 : made.joint.nq, follows } };
  };
  const bodies = [
    joint(-1, 'revolute', 2, { leader: 2, multiplier: -2, offset: 0.1 }), // its leader comes later
    joint(-1, 'continuous', 0, null),
    joint(-1, 'prismatic', 2, null),
    joint(-1, 'continuous', 0, { leader: 1, multiplier: 2, offset: Math.PI / 2 }),
    joint(-1, 'prismatic', 2, { leader: 2, multiplier: 0.5, offset: 1 }),
  ];
  const placed = kinematics.forward({ nq: 3, bodies }, [0, 1, 0.3]);
  near(placed[0], [0, 0, 0, 0, 0, Math.sin(-0.25), Math.cos(-0.25)]);
  near(placed[3], [0, 0, 0, 0, 0, Math.sin(0.75 * Math.PI), Math.cos(0.75 * Math.PI)]);
  near(placed[4], [0, 0, 1.15, 0, 0, 0, 1]);
});

test('composition of placements rotates, then translates', () => {
  const a = [1, 0, 0, 0, 0, half, half];
  near(kinematics.compose(a, [1, 0, 0, 0, 0, 0, 1]), [1, 1, 0, 0, 0, half, half]);
  near(kinematics.rotate(a, [0, 1, 0]), [-1, 0, 0]);
});

test('interpolation between two quaternions of opposite sign does not rotate', () => {
  const robot = { nq: 7, bodies: [body(-1, 'free_flyer', 0, [0, 0, 0, 0, 0, 0, 1])] };
  const q = kinematics.interpolate(robot, [0, 0, 0, 0, 0, 0, 1], [2, 0, 0, 0, 0, 0, -1], 0.5);
  near([...q], [1, 0, 0, 0, 0, 0, 1]);
});

test('principal moments diagonalize the inertia, and the ellipsoid has the same moments', () => {
  const inertia = [0.4, 0.5, 0.6, 0.05, -0.02, 0.03];
  const { moments, axes } = kinematics.principal(inertia);
  const full = [
    [0.4, 0.05, -0.02],
    [0.05, 0.5, 0.03],
    [-0.02, 0.03, 0.6],
  ];
  for (let i = 0; i < 3; ++i) {
    const axis = [axes[0][i], axes[1][i], axes[2][i]];
    const image = full.map((row) => row.reduce((sum, v, k) => sum + v * axis[k], 0));
    near(
      image,
      axis.map((v) => v * moments[i]),
      1e-10,
    );
  }
  const [a, b, c] = kinematics.ellipsoid(2, moments);
  const again = [b * b + c * c, a * a + c * c, a * a + b * b].map((s) => (2 * s) / 5);
  near(again, moments, 1e-10);
});

const pack = (values) => ({
  n: values.length,
  f32: Buffer.from(new Float32Array(values).buffer).toString('base64'),
});

test('packed arrays are decoded without change, gaps included', () => {
  const out = data.unpackF32(pack([1.5, -2, NaN, 3e7]));
  assert.deepEqual([...out], [1.5, -2, NaN, 3e7]);
  const words = Buffer.from(new Uint32Array([7, 4294967295]).buffer).toString('base64');
  assert.deepEqual([...data.unpackU32({ n: 2, u32: words })], [7, 4294967295]);
});

test('a page is decoded; a page of another format is rejected', () => {
  const run = {
    name: 'a',
    robot: { nq: 1, bodies: [], moving: ['j'] },
    series: {
      time: pack([0, 0.1, 0.2]),
      columns: [{ name: 'q_j', unit: 'rad', data: pack([1, 2, 3]) }],
    },
    envelopes: { columns: [{ name: 'q_j', min: pack([0, 0, 0]), max: pack([4, 4, 4]) }] },
    solver: null,
    metrics: [{ name: 'solve_p99' }, { name: 'mean_iterations' }, { name: 'force_rmse' }],
  };
  const text = JSON.stringify({ format: 'burnish-page/1', kind: 'run', title: 'a', runs: [run] });
  const page = data.decodePage(text);
  assert.equal(data.valueAt(page.runs[0], 'q_j', 0.1), 2);
  assert.equal(data.valueAt(page.runs[0], 'q_j', 0.16), 3);
  assert.ok(Number.isNaN(data.valueAt(page.runs[0], 'nothing', 0)));
  assert.deepEqual([...page.runs[0].envelopes.get('q_j').max], [4, 4, 4]);
  assert.equal(data.configurationColumns(page.runs[0]).length, 1);
  assert.deepEqual(
    page.runs[0].metrics.map((metric) => metric.name),
    ['solver.p99', 'solver.mean_iterations', 'force_rmse'],
  );
  assert.equal(data.decodePage('null'), null);
  assert.throws(
    () => data.decodePage('{"format":"other/2"}'),
    /'other\/2'; wanted 'burnish-page\/1'/,
  );
});

test('rows are found by time: the row before, and the nearest row', () => {
  const times = [0, 1, 2, 3];
  assert.deepEqual(
    [-1, 0, 0.9, 1, 2.6, 9].map((t) => data.rowBefore(times, t)),
    [0, 0, 0, 1, 2, 3],
  );
  assert.deepEqual(
    [-1, 0.4, 0.6, 2.6, 9].map((t) => data.rowAt(times, t)),
    [0, 0, 1, 3, 3],
  );
});

test('a grid has two triangles per cell, all with the same orientation', () => {
  const triangles = data.gridTriangles(3);
  assert.equal(triangles.length, 3 * 2 * 4);
  const area = (a, b, c) => {
    const [p, q, r] = [a, b, c].map((k) => [Math.floor(k / 3), k % 3]);
    return 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  };
  let whole = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const cell = area(...triangles.slice(i, i + 3));
    assert.equal(cell, 0.5);
    whole += cell;
  }
  assert.equal(whole, 4);
});

test('normals come from their columns, or else from the axes', () => {
  const axes = [1, 0, 0, 0, 1, 0, 0, 0, 1];
  const columns = new Map(
    ['x', 'y', 'z'].map((axis, k) => [
      `estimated_normal_${axis}`,
      { data: [0, 0.6 * (k === 0) + 0.8 * (k === 2)] },
    ]),
  );
  const run = { surface: { axes, true_axes: [0, 1, 0, 0, 0, 1, 1, 0, 0] }, columns };
  near(data.normalAt(run, 'surface', 1), [1, 0, 0]);
  near(data.normalAt(run, 'estimated', 1), [0.6, 0, 0.8]);
});

const foot = { frame: 'foot', half_x: 0.1, half_y: 0.05, radius: 0.02, friction: 0.7 };
const level = { ...foot, point: [0, 0, 0.3], normal: [0, 0, 1] };
const wrench = (values) =>
  new Map(
    ['fx', 'fy', 'fz', 'mx', 'my', 'mz'].map((name, k) => [
      `support_foot_${name}`,
      { data: [values[k]] },
    ]),
  );

test('the force of a sole acts at its centre of pressure, in the axes of the world', () => {
  // The foot is rotated by 90 degrees about the vertical: its x axis is the y axis of the world.
  const placed = [1, 2, 0.3, 0, 0, half, half];
  const run = { columns: wrench([10, 0, 100, -2, -5, 0.1]) };
  const load = supports.footLoad(run, level, placed, 0);
  near(load.force, [0, 10, 100]);
  near(load.point, [1 + 0.02, 2 + 0.05, 0.3]);
  near([load.normal], [100]);
  near(supports.corners(level, placed)[2], [1 - 0.05, 2 + 0.1, 0.3]);
});

test('the force on a point foot acts at its lowest point', () => {
  const ball = { ...level, half_x: 0, half_y: 0, normal: [0, 0.6, 0.8] };
  const placed = [1, 2, 0.3, 0, 0, 0, 1];
  const load = supports.footLoad({ columns: wrench([0, 6, 8, 0, 0, 0]) }, ball, placed, 0);
  near(load.point, [1, 2 - 0.012, 0.3 - 0.016]);
  near([load.normal], [10]);
  near(supports.corners(ball, placed)[0], load.point);
  assert.ok(!supports.isLevel(ball) && supports.isLevel(level));
});

test('a run of an older version has no loads, and its ground is at height 0', () => {
  const load = supports.footLoad({ columns: new Map() }, level, [0, 0, 0, 0, 0, 0, 1], 0);
  assert.ok(Number.isNaN(load.normal));
  assert.equal(supports.pressureOfAll([load]), null);
  assert.equal(supports.groundHeight({}), 0);
  assert.equal(supports.groundHeight({ supports: [level] }), 0.3);
});

test('the centre of pressure of all feet is weighted by their loads', () => {
  const loads = [
    { normal: 300, point: [0, 0.1, 0] },
    { normal: 100, point: [0.2, -0.1, 0] },
    { normal: -5, point: [9, 9, 9] },
  ];
  near(supports.pressureOfAll(loads), [0.05, 0.05, 0]);
  assert.equal(supports.pressureOfAll([{ normal: 1, point: [0, 0, 0] }]), null);
});

test('a hull goes around the outermost points, counterclockwise', () => {
  const square = [
    [0, 0, 1],
    [1, 1, 1],
    [0.5, 0.5, 1],
    [1, 0, 1],
    [0.5, 0, 1],
    [0, 1, 1],
  ];
  assert.deepEqual(supports.hull(square), [
    [0, 0, 1],
    [1, 0, 1],
    [1, 1, 1],
    [0, 1, 1],
  ]);
  assert.equal(supports.hull(square.slice(0, 2)).length, 2);
  assert.equal(supports.hull([]).length, 0);
});

test('a push acts at its start, and no longer at its end', () => {
  const push = { frame: 'foot', start: 1, duration: 0.5, force: [0, 9, 0] };
  assert.deepEqual(
    [0.9, 1, 1.4, 1.5].map((t) => supports.pushesAt([push], t).length),
    [0, 1, 1, 0],
  );
});

test('the force per 10 cm of arrow is a round fraction of the weight', () => {
  const scaleOf = (total_mass) =>
    supports.weightScale({ robot: { total_mass, gravity: [0, 0, -9.81] } });
  assert.deepEqual([90, 30, 12, 0].map(scaleOf), [200, 50, 20, 100]);
});

test('a run presses if the robot has a tool and the motion is not only planned', () => {
  const run = (frame) => ({ tool: { frame, tip_radius: 0 } });
  assert.equal(data.presses(run('tool')), true);
  assert.equal(data.presses(run('')), false);
  const plan = { frames: [], forces: [], limits: [] };
  assert.equal(data.presses({ ...run('tool'), plan }), false);
});

test('a vertical axis does not show the rounding of its unit', () => {
  near(spans.spanOf(-1e-9, 1e-9, '°'), [-5e-4, 5e-4]);
  near(spans.spanOf(0, 10, 'N'), [-0.8, 10.8]);
});
