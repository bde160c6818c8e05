// node test/screenshots.mjs PAGE.html OUT.png [--time S] [--width PX] [--height PX] [--scale K]
//                          [--dark] [--full] [--click TEXT]...
import { parseArgs } from 'node:util';
import { drawn, launch, open, ready } from './browser.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    time: { type: 'string' },
    width: { type: 'string', default: '1440' },
    height: { type: 'string', default: '900' },
    scale: { type: 'string', default: '1' },
    dark: { type: 'boolean', default: false },
    full: { type: 'boolean', default: false },
    click: { type: 'string', multiple: true, default: [] },
    scroll: { type: 'string' },
  },
});
const [file, out] = positionals;
if (!file || !out) {
  console.error('usage: node test/screenshots.mjs PAGE.html OUT.png [--time S] [--dark] ...');
  process.exit(2);
}
const browser = await launch();
try {
  const { page, errors } = await open(browser, file, {
    viewport: { width: Number(values.width), height: Number(values.height) },
    deviceScaleFactor: Number(values.scale),
    colorScheme: values.dark ? 'dark' : 'light',
  });
  await ready(page);
  if (values.time) await page.evaluate((t) => window.burnish.setTime(t), Number(values.time));
  for (const text of values.click) await page.getByText(text, { exact: true }).first().click();
  if (values.scroll) await page.evaluate((y) => window.scrollTo(0, y), Number(values.scroll));
  await page.waitForTimeout(300);
  await drawn(page);
  await page.screenshot({ path: out, fullPage: values.full });
  for (const error of errors) console.error(error);
} finally {
  await browser.close();
}
