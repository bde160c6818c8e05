// node test/page.test.mjs PAGE.html [TRACE.csv] [COMPARISON.html] [CURVED.html] [PLAN.html]
// Opens pages from disk in a headless browser and operates them by mouse and keyboard.
// Checks pages of runs and pages of robots (burnish show ROBOT --html).
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { drawn, launch, open, ready } from './browser.mjs';
import { differing, pixels } from './pixels.mjs';
import { withFeet } from './standing_page.mjs';

const [pageFile, traceFile, comparisonFile, curvedFile, planFile] = process.argv.slice(2);
if (!pageFile) {
  console.error(
    'usage: node test/page.test.mjs PAGE.html [TRACE.csv] [COMPARISON.html] [CURVED.html] [PLAN.html]',
  );
  process.exit(2);
}

let failures = 0;
function check(name, good, detail = '') {
  if (!good) failures += 1;
  console.log(`${good ? 'ok    ' : 'FAILED'} ${name}${detail ? `: ${detail}` : ''}`);
}
const close = (a, b, tolerance) => Math.abs(a - b) <= tolerance;
const api = (page, body, argument) =>
  page.evaluate(new Function('x', `const b = window.burnish; ${body}`), argument);
const time = (page) => api(page, 'return b.time');

/** Picture of the 3D view, without the elements that cover it. */
async function picture(page) {
  await drawn(page);
  const style = await page.addStyleTag({ content: '.stage .hud { visibility: hidden }' });
  const box = await page.locator('.canvas-host').boundingBox();
  const view = page.viewportSize();
  const height = Math.min(box.height, view.height - box.y - 80);
  const png = await page.screenshot({ clip: { ...box, height } });
  await style.evaluate((element) => element.remove());
  return pixels(page.context().browser(), png);
}

/** Fraction of a picture that is not its background, and its number of colours. */
function content({ width, height, data }) {
  const colours = new Set();
  let drawnPixels = 0;
  for (let y = 0; y < height; ++y) {
    const edge = 4 * y * width;
    for (let x = 0; x < width; x += 2) {
      const i = 4 * (y * width + x);
      colours.add((data[i] >> 4) * 256 + (data[i + 1] >> 4) * 16 + (data[i + 2] >> 4));
      const away = [0, 1, 2].some((k) => Math.abs(data[i + k] - data[edge + k]) > 24);
      if (away) drawnPixels += 1;
    }
  }
  return { fraction: drawnPixels / (width * height * 0.5), colours: colours.size };
}

async function checkView(page) {
  const { fraction, colours } = content(await picture(page));
  const detail = `${(100 * fraction).toFixed(0)} % drawn, ${colours} colours`;
  check('the 3D view is not blank', fraction > 0.03 && colours > 25, detail);
}

async function checkPhone(browser, file) {
  const options = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
  const { context, page, errors } = await open(browser, file, options);
  await ready(page);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  check('the page fits the width of a phone', width <= 390, `${width} px wide`);
  check('no error on a phone', errors.length === 0, errors.join('; '));
  await context.close();
}

const brightness = (page) =>
  page.evaluate(() => {
    const light = (text) => {
      const [r, g, b] = text.match(/[\d.]+/g).map(Number);
      return (0.299 * r + 0.587 * g + 0.114 * b) / 255;
    };
    const back = getComputedStyle(document.documentElement).backgroundColor;
    return { back: light(back), ink: light(getComputedStyle(document.body).color) };
  });

async function checkDark(browser, file) {
  const { context, page } = await open(browser, file, { colorScheme: 'dark' });
  await ready(page);
  const dark = await brightness(page);
  check('the page is dark if the system is dark', dark.back < 0.2 && dark.ink > 0.7);
  await page.getByRole('button', { name: 'Light or dark' }).click();
  const light = await brightness(page);
  check('the button makes the page light', light.back > 0.8 && light.ink < 0.3);
  await context.close();
}

async function checkLoading(page, errors, requests) {
  await ready(page);
  const title = await page.title();
  check('the page opens from disk', title.endsWith('burnish'), title);
  const fetched = requests.filter((url) => !/^(data|blob):/.test(url));
  check('the page fetches nothing', fetched.length === 1, fetched.slice(1).join(' '));
  check('no error on loading', errors.length === 0, errors.join('; '));
}

async function checkTime(page) {
  const before = await api(page, 'b.setTime(1); return b.renderCount');
  await api(page, 'b.play()');
  await page.waitForFunction(() => window.burnish.time > 1.2, null, { timeout: 30_000 });
  const after = await api(page, 'b.pause(); return { count: b.renderCount, time: b.time }');
  check('playing moves time and draws', after.count > before, `1 s to ${after.time.toFixed(2)} s`);
  await drawn(page);
  check('a pause stops the time', (await time(page)) === after.time);

  const bar = await page.getByRole('slider', { name: 'Time' }).boundingBox();
  const duration = Number(
    await page.getByRole('slider', { name: 'Time' }).getAttribute('aria-valuemax'),
  );
  const y = bar.y + bar.height / 2;
  await page.mouse.move(bar.x + 0.2 * bar.width, y);
  await page.mouse.down();
  await page.mouse.move(bar.x + 0.6 * bar.width, y, { steps: 5 });
  await page.mouse.up();
  const there = await time(page);
  check('the bar scrubs', close(there, 0.6 * duration, 0.02 * duration), `${there.toFixed(2)} s`);

  const early = await (await api(page, 'b.setTime(0)'), picture(page));
  const late = await (await api(page, 'b.setTime(x)', 0.6 * duration), picture(page));
  const changed = differing(early, late);
  check('the robot moves', changed > 0.002, `${(100 * changed).toFixed(1)} % of the picture`);
}

async function checkKeys(page) {
  await page.mouse.click(5, 5);
  await api(page, 'b.setTime(1)');
  const press = async (key) => {
    await page.keyboard.press(key);
    return time(page);
  };
  check('right arrow steps', close(await press('ArrowRight'), 1.01, 1e-9));
  check('shift and left arrow steps far', close(await press('Shift+ArrowLeft'), 0.51, 1e-9));
  check('home goes to the start', (await press('Home')) === 0);
  check('end goes to the end', (await press('End')) > 1);
  await press('Home');
  await press('Space');
  check('space plays', await api(page, 'return b.playing'));
  await press('Space');
  check('space pauses', !(await api(page, 'return b.playing')));
  await press('?');
  check('? opens the keys', await page.getByRole('dialog').isVisible());
  await press('Escape');
  check('escape closes them', !(await page.getByRole('dialog').isVisible()));
}

const plotPicture = async (page, id) => {
  const canvas = page.locator(`[data-plot=${id}] canvas`);
  await canvas.scrollIntoViewIfNeeded();
  await drawn(page);
  return pixels(page.context().browser(), await canvas.screenshot());
};

async function checkZoom(page) {
  const names = await api(page, 'return b.plots');
  const wanted = ['force', 'path', 'tau', 'q', 'v', 'contact'];
  const missing = wanted.filter((name) => !names.includes(name));
  check('the page has the expected plots', missing.length === 0, names.join(' '));
  const before = await plotPicture(page, 'v');
  const over = page.locator('[data-plot=force] .u-over');
  await over.scrollIntoViewIfNeeded();
  const box = await over.boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 40, { steps: 5 });
  await page.mouse.up();
  const [start, end] = await api(page, 'return b.window');
  check(
    'a drag zooms',
    end - start > 0.1 && start > 0.1,
    `${start.toFixed(2)} to ${end.toFixed(2)} s`,
  );
  const changed = differing(before, await plotPicture(page, 'v'));
  check('the other plots follow', changed > 1e-3, `${(100 * changed).toFixed(1)} % of one`);
  await page.keyboard.press('0');
  check('0 shows the whole run', (await api(page, 'return b.window[0]')) === 0);
  await over.scrollIntoViewIfNeeded();
  await drawn(page);
  const again = await over.boundingBox();
  await page.mouse.click(again.x + 0.5 * again.width, again.y + 30);
  const whole = await api(page, 'return b.window[1]');
  check('a click moves the cursor', close(await time(page), 0.5 * whole, 0.01 * whole));
}

function readTrace(file) {
  const [head, ...lines] = readFileSync(file, 'utf8').trim().split('\n');
  const names = head.split(',').map((name) => name.replace(/ \[.*$/, ''));
  const index = new Map(names.map((name, i) => [name, i]));
  const rows = lines.map((line) => line.split(',').map(Number));
  return { rows, at: (row, name) => row[index.get(name)], has: (name) => index.has(name) };
}

/** Compares the values of the page with the rows of the trace at the same times. */
async function checkValues(page, file) {
  const trace = readTrace(file);
  const { times, normal, moving } = await page.evaluate(() => {
    const data = JSON.parse(document.getElementById('burnish-data').textContent).runs[0];
    const raw = Uint8Array.from(atob(data.series.time.f32), (c) => c.charCodeAt(0));
    const all = new Float32Array(raw.buffer);
    const some = [0.02, 0.15, 0.2, 0.31, 0.5, 0.77, 0.93, 0.99];
    return {
      times: some.map((s) => all[Math.floor(s * (all.length - 1))]),
      normal: data.surface.true_axes.slice(6, 9),
      moving: data.robot.moving,
    };
  });
  let worst = { force: 0, joint: 0, time: 0 };
  for (const t of times) {
    const row = trace.rows.reduce((best, r) =>
      Math.abs(trace.at(r, 'time') - t) < Math.abs(trace.at(best, 'time') - t) ? r : best,
    );
    const force = ['x', 'y', 'z'].reduce(
      (sum, axis, k) => sum + normal[k] * trace.at(row, `tool_force_${axis}_world`),
      0,
    );
    const shown = await api(
      page,
      `b.setTime(x.t);
       return { force: b.value('force_normal'), q: x.moving.map((j) => b.value('q_' + j)) };`,
      { t, moving },
    );
    worst.time = Math.max(worst.time, Math.abs(trace.at(row, 'time') - t));
    worst.force = Math.max(
      worst.force,
      Math.abs(shown.force - force) / Math.max(1, Math.abs(force)),
    );
    moving.forEach((joint, i) => {
      if (!trace.has(`q_${joint}`)) return;
      worst.joint = Math.max(worst.joint, Math.abs(shown.q[i] - trace.at(row, `q_${joint}`)));
    });
  }
  check('the times match the trace', worst.time < 1e-5, `${worst.time} s apart at most`);
  check(
    'the normal force matches the trace',
    worst.force < 1e-5,
    `error ${worst.force.toExponential(1)}`,
  );
  check(
    'the joint positions match the trace',
    worst.joint < 1e-5,
    `${worst.joint.toExponential(1)} rad`,
  );
}

/** Compares the tool position of the drawn robot with the recorded position. */
async function checkKinematics(page) {
  let worst = 0;
  for (const t of [0, 0.7, 1.9, 3.1]) {
    const { drawnAt, at } = await api(
      page,
      `b.setTime(x); return { drawnAt: b.drawnTool(), at: ['x', 'y', 'z'].map((k) => b.value('tool_' + k)) };`,
      t,
    );
    if (!drawnAt) return check('the drawn robot has its tool', false);
    worst = Math.max(worst, Math.hypot(...drawnAt.map((v, i) => v - at[i])));
  }
  check(
    'the drawn tool is at its recorded position',
    worst < 1e-4,
    `${(1e3 * worst).toFixed(3)} mm`,
  );
}

async function checkHeader(page) {
  await page.getByRole('button', { name: 'Metrics', exact: true }).click();
  const rows = await page.locator('table.metrics tbody tr').count();
  check('the metrics open', rows > 3, `${rows} rows`);
  await page.getByRole('button', { name: 'Task file' }).click();
  const task = await page.locator('pre.task').first().textContent();
  check('the task file opens', task.length > 50, `${task.length} characters`);
  const copy = page.getByRole('button', { name: 'Copy command' });
  const element = await copy.elementHandle();
  await copy.click();
  await page.waitForTimeout(200);
  check('the command is copied', (await element.textContent()) === 'Copied');
}

async function checkRobot(page) {
  const before = await picture(page);
  const slider = page.locator('.joint input').first();
  await slider.focus();
  await page.keyboard.press('Home');
  const moved = await picture(page);
  check('a slider moves the robot', differing(before, moved) > 0.002);
  await page.getByRole('button', { name: 'Reset' }).click();
  const back = await picture(page);
  check('reset moves the robot back', differing(before, back) < 0.002);
  await page.getByLabel('Inertias').click();
  await page.getByLabel('Joint frames').click();
  check('inertias and frames show', differing(back, await picture(page)) > 0.002);
}

async function checkComparison(browser, file) {
  console.log(`\n${file}`);
  const { context, page, errors, requests } = await open(browser, file);
  await checkLoading(page, errors, requests);
  const runs = await api(page, 'return b.runs');
  check('there are several runs', runs >= 2, String(runs));
  const curves = await page.locator('[data-plot=force] .legend .key').count();
  check('their forces are in one plot', curves >= runs, `${curves} curves`);
  await api(page, 'b.setTime(3)');
  const values = await api(page, `return [0, 1].map((run) => b.value('force_normal', run))`);
  check('each run has its own values', values.every(Number.isFinite) && values[0] !== values[1]);
  const legend = page.locator('[data-plot=force] .legend .key');
  const both = await plotPicture(page, 'force');
  await legend.nth(0).click();
  const one = await plotPicture(page, 'force');
  await legend.nth(0).click();
  await legend.nth(1).click();
  const other = await plotPicture(page, 'force');
  const two = differing(both, one) > 1e-4 && differing(both, other) > 1e-4;
  check('two curves are drawn over each other', two);
  await checkView(page);
  check('no error in the comparison', errors.length === 0, errors.join('; '));
  await context.close();
}

/** Checks that a curved surface and two normals are drawn: hiding them changes the picture. */
async function checkCurved(browser, file) {
  console.log(file);
  const { context, page, errors } = await open(browser, file);
  await ready(page);
  await api(page, 'b.setTime(2)');
  const whole = await picture(page);
  await page.keyboard.press('n');
  const changed = differing(whole, await picture(page));
  check('two normals are drawn at the tool', changed > 1e-5, `${(100 * changed).toFixed(3)} %`);
  await page.keyboard.press('n');
  await page.locator('.layers summary').click();
  await page.getByLabel('Surface', { exact: true }).uncheck();
  const bare = differing(whole, await picture(page));
  check('a curved surface is drawn', bare > 0.01, `${(100 * bare).toFixed(1)} %`);
  check('no error on a page of a curved surface', errors.length === 0, errors.join('; '));
  await context.close();
}

/** Checks a planned motion: it moves, has paths and plots of constraints, and shows no contact. */
async function checkPlan(browser, file) {
  console.log(file);
  const { context, page, errors, requests } = await open(browser, file);
  await checkLoading(page, errors, requests);
  await checkView(page);
  const names = await api(page, 'return b.plots');
  const missing = ['plan_margins', 'plan_multipliers', 'tau', 'q', 'v'].filter(
    (name) => !names.includes(name),
  );
  check('limits and multipliers have plots', missing.length === 0, missing.join(' '));
  check('no contact is shown', (await page.locator('.contact-key').count()) === 0);
  check(
    'the badge says that the plan converged',
    (await page.locator('.badge').textContent()).endsWith('converged'),
  );
  const first = await picture(page);
  const start = await api(page, 'return b.drawnTool()');
  await api(page, 'b.setTime(1.5)');
  const moved = Math.hypot(
    ...(await api(page, 'return b.drawnTool()')).map((v, i) => v - start[i]),
  );
  check('the motion is replayed', moved > 0.05 && differing(first, await picture(page)) > 0.002);
  check('no error on a page of a plan', errors.length === 0, errors.join('; '));
  await context.close();
  await checkPhone(browser, file);
}

/** Checks a standing robot: its feet, its balance and a push are drawn, and have plots. */
async function checkStanding(browser) {
  const folder = mkdtempSync(join(tmpdir(), 'burnish-page-'));
  const file = join(folder, 'standing.html');
  writeFileSync(file, withFeet(readFileSync(pageFile, 'utf8')));
  console.log(`${pageFile}, on two feet`);
  const { context, page, errors } = await open(browser, file);
  await ready(page);
  const names = await api(page, 'return b.plots');
  const wanted = ['foot_load', 'foot_friction', 'foot_pressure', 'com', 'momentum'];
  const missing = [...wanted, 'angular_momentum'].filter((name) => !names.includes(name));
  check('the page has the plots of a standing robot', missing.length === 0, missing.join(' '));
  const feet = await page.locator('[data-plot=foot_load] .legend .key').count();
  check('each foot has a curve', feet === 2, `${feet} curves`);
  await api(page, 'b.setTime(0.2)');
  const whole = await picture(page);
  for (const [key, layer] of [
    ['g', 'feet and their forces'],
    ['b', 'balance'],
  ]) {
    await page.keyboard.press(key);
    const changed = differing(whole, await picture(page));
    check(`${layer} are drawn`, changed > 1e-5, `${(100 * changed).toFixed(3)} %`);
    await page.keyboard.press(key);
  }
  check('feet and balance are drawn again', differing(whole, await picture(page)) < 1e-4);
  await api(page, 'b.setTime(0.7)');
  const pushed = await picture(page);
  await page.locator('.layers summary').click();
  await page.getByLabel('Pushes', { exact: true }).uncheck();
  await page.locator('.layers summary').click();
  const push = differing(pushed, await picture(page));
  check('a push is drawn while it acts', push > 1e-5, `${(100 * push).toFixed(3)} %`);
  check('no error on a page of a standing robot', errors.length === 0, errors.join('; '));
  await context.close();
  rmSync(folder, { recursive: true });
}

async function checkPage(browser) {
  console.log(pageFile);
  const { context, page, errors, requests } = await open(browser, pageFile);
  await checkLoading(page, errors, requests);
  await checkView(page);
  if ((await api(page, 'return b.runs')) === 0) await checkRobot(page);
  else {
    await checkTime(page);
    await checkKeys(page);
    await checkZoom(page);
    await checkKinematics(page);
    if (traceFile) await checkValues(page, traceFile);
    await checkHeader(page);
  }
  check('no error while the page is used', errors.length === 0, errors.join('; '));
  const runs = await api(page, 'return b.runs');
  await context.close();
  if (runs === 1) await checkStanding(browser);
  await checkPhone(browser, pageFile);
  await checkDark(browser, pageFile);
}

const browser = await launch();
try {
  await checkPage(browser);
  if (comparisonFile) await checkComparison(browser, comparisonFile);
  if (curvedFile) await checkCurved(browser, curvedFile);
  if (planFile) await checkPlan(browser, planFile);
} catch (error) {
  check('the page could be used', false, error.message);
} finally {
  await browser.close();
}
console.log(failures === 0 ? '\nall good' : `\n${failures} failed`);
process.exit(failures === 0 ? 0 : 1);
