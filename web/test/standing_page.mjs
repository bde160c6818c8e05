// Makes the page of a standing robot from the page of a robot with a fixed base. The result replaces
// a long simulation of a standing robot.

const packed = (values) => ({
  n: values.length,
  f32: Buffer.from(new Float32Array(values).buffer).toString('base64'),
});

/** Adds feet, a push and their columns to the first run of a page; returns the text of the page. */
export function withFeet(html) {
  const place = /(id="burnish-data">)(.*?)(<\/script>)/s;
  const data = JSON.parse(place.exec(html)[2]);
  const [run] = data.runs;
  const { n } = run.series.time;
  const frames = run.robot.frames.filter(({ kind }) => kind === 'link');
  const feet = [frames[1], frames[frames.length - 1]].map(({ name }) => name);
  run.supports = feet.map((frame, i) => ({
    frame,
    half_x: i === 0 ? 0.1 : 0,
    half_y: i === 0 ? 0.06 : 0,
    radius: 0.04,
    point: [0, 0, 0],
    normal: [0, 0, 1],
    friction: 0.7,
  }));
  run.pushes = [{ frame: feet[0], start: 0.5, duration: 0.5, force: [0, 80, 0] }];
  const add = (name, unit, value) =>
    run.series.columns.push({ name, unit, data: packed(Array.from({ length: n }, value)) });
  for (const frame of feet) {
    for (const entry of ['fx', 'fy', 'mx', 'my', 'mz'])
      add(`support_${frame}_${entry}`, 'N', () => 2);
    add(`support_${frame}_fz`, 'N', () => 300);
    add(`support_${frame}_load`, 'N', () => 300);
    add(`support_${frame}_friction_used`, '-', (_, k) => k / n);
  }
  add(`support_${feet[0]}_pressure_margin`, 'm', () => 0.03);
  for (const axis of ['x', 'y', 'z']) {
    add(`com_${axis}`, 'm', (_, k) => 0.3 + (0.01 * k) / n);
    add(`momentum_${axis}`, 'kg m/s', () => 1);
    add(`angular_momentum_${axis}`, 'kg m^2/s', (_, k) => (k < 3 ? NaN : 1));
  }
  const text = JSON.stringify(data).replace(/</g, '\\u003c');
  return html.replace(place, (_all, before, _data, after) => before + text + after);
}
