// A browser without a screen or a network, and pages in it that are watched. Nothing here looks at
// the clock, as a busy machine may take any time: what has to happen first is waited for, without a
// limit. ctest ends a test that waits in vain.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';

const hour = 3600000;  // ms

const swiftShader = ['--no-sandbox', '--enable-unsafe-swiftshader'];

export function launch(...words) {
  const executablePath =
      execFileSync('sh', ['-c', 'command -v chromium'], {encoding: 'utf8'}).trim();
  return chromium.launch({executablePath, args: [...swiftShader, ...words], timeout: 0});
}

// How many times slower than it is the processor shall seem to pages: from PREHEND_SLOWDOWN.
const slowdownOfAll = Number(process.env.PREHEND_SLOWDOWN ?? 1);

// What a page asks for and complains of from now on.
export function watch(page) {
  const requests = [];
  const complaints = [];
  page.on('request', (request) => requests.push(request.url()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('dialog', (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('console', (message) => {
    if (message.type() === 'error') complaints.push(message.text());
  });
  return {requests, complaints};
}

// What keeps people from using a page who do not see well, or have no mouse, by the rules of
// axe-core: the rule and the elements.
export async function barriers(page) {
  const file = new URL('./node_modules/axe-core/axe.min.js', import.meta.url);
  await page.evaluate(readFileSync(file, 'utf8'));
  const {violations} = await page.evaluate(() => window.axe.run());
  return violations.map(({id, nodes}) => `${id}: ${nodes.map(({html}) => html).join(' ')}`);
}

// A report that is open in a page of its own; complaints are what should not happen. With `stepped`
// the page's time runs only as far as run() lets it, from the moment that the page has been drawn.
// Half the pixels each way: without a graphics card nearly all time goes into drawing them.
export class OpenReport {
  static async open(browser, out, {
    address = '',
    slowdown = 1,
    stepped = false,
    deviceScaleFactor = 0.5,
    viewport =
    {
      width: 1280, height: 900
    }
  } = {}) {
    const report = new OpenReport();
    report.url = pathToFileURL(join(out, 'report.html')).href;
    report.page = await browser.newPage({viewport, deviceScaleFactor});
    Object.assign(report, watch(report.page));
    report.page.setDefaultTimeout(0);
    const session = await report.page.context().newCDPSession(report.page);
    const rate = Math.max(slowdown, slowdownOfAll);
    await session.send('Emulation.setCPUThrottlingRate', {rate});
    if (stepped) await report.page.clock.install({time: 0});
    await report.page.addInitScript(addPixelsOf);
    await report.page.goto(report.url + address);
    await report.settle();
    if (stepped) await report.page.clock.pauseAt(hour);
    return report;
  }

  // Until what was asked to be drawn has been, as fine as it gets, or never will be.
  async settle() {
    await this.drawn('fine', 'never');
  }

  // Until the scene is in one of the states of its attribute data-drawn (scene_view.js).
  async drawn(...states) {
    const selector = states.map((state) => `#scene[data-drawn="${state}"]`).join();
    await this.page.locator(selector).waitFor({state: 'attached'});
  }

  // Until the grasp of a number is the one that is explained.
  async shown(number) {
    await this.page.locator('#grasp-title', {hasText: new RegExp(`^Grasp ${number}$`)}).waitFor();
  }

  // Lets the time of a stepped page run [ms], with a frame every 16 ms, or in one leap with one
  // frame.
  async run(time) {
    await this.page.clock.runFor(time);
  }
  async leap(time) {
    await this.page.clock.fastForward(time);
  }

  text(selector) {
    return this.page.locator(selector).innerText();
  }

  // A picture of an element as it is on the screen: how many colours it has, and how many pixels
  // are red or purple.
  async picture(selector) {
    await this.settle();
    const png = (await this.page.locator(selector).screenshot()).toString('base64');
    return {png, ...await this.page.evaluate(colorsOf, png)};
  }

  // How many pixels of two pictures of one size are clearly different.
  difference(a, b) {
    return this.page.evaluate(differenceOf, [a.png, b.png]);
  }

  // Nothing but the file itself was asked for, and nobody complained.
  async close() {
    assert.deepEqual([...new Set(this.requests.map((url) => url.split('#')[0]))], [this.url]);
    assert.deepEqual(this.complaints, []);
    await this.page.close();
  }
}

// In the page.
async function colorsOf(png) {
  const data = await window.pixelsOf(png);
  const colors = new Set();
  let red = 0;
  let purple = 0;
  for (let i = 0; i < data.length; i += 4) {
    const [r, g, b] = data.subarray(i, i + 3);
    colors.add(r << 16 | g << 8 | b);
    if (r > 110 && g < 0.4 * r && b < 0.4 * r) ++red;
    if (b > 90 && r > 50 && b > r && g < 0.5 * r) ++purple;
  }
  return {colors: colors.size, red, purple};
}

// In the page.
async function differenceOf(pngs) {
  const [a, b] = await Promise.all(pngs.map(window.pixelsOf));
  if (a.length !== b.length) throw new Error('the pictures differ in size');
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(a[i + k] - b[i + k]) > 24)) ++count;
  }
  return count;
}

// In the page, where it is put before anything else.
function addPixelsOf() {
  window.pixelsOf = async (png) => {
    const bytes = Uint8Array.from(atob(png), (digit) => digit.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], {type: 'image/png'}));
    const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
    pen.drawImage(image, 0, 0);
    return pen.getImageData(0, 0, image.width, image.height).data;
  };
}
