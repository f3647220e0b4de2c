// How fast reports draw without a graphics card: node benchmarks/report_benchmark.mjs FOLDER...
// A row a report: its size, the time until its grasp can be seen, and the time of a frame while it
// is turned (median and 90th percentile), in a window of 1280 x 800 pixels.
import {statSync} from 'node:fs';
import {join} from 'node:path';

import {launch, OpenReport} from '../../../../tests/web/browser.mjs';

const frames = 80;

function percentile(values, part) {
  return [...values].sort((a, b) => a - b)[Math.floor(part * (values.length - 1))];
}

// In the page: the times between frames while the scene is dragged.
async function turn(count) {
  const canvas = document.getElementById('scene');
  const at = (type, x) =>
      (type === 'mousemove' ? document : canvas).dispatchEvent(new MouseEvent(type, {
        clientX: x,
        clientY: 200,
        button: 0,
        buttons: 1,
        bubbles: true,
      }));
  const frame = () => new Promise((done) => requestAnimationFrame(done));
  at('mousedown', 100);
  const times = [];
  let last = await frame();
  for (let i = 0; i < count; ++i) {
    at('mousemove', 100 + 4 * i);
    const now = await frame();
    times.push(now - last);
    last = now;
  }
  document.dispatchEvent(new MouseEvent('mouseup', {button: 0}));
  return times;
}

const browser = await launch();
console.log('     MB   open s   frame ms   p90   report');
for (const folder of process.argv.slice(2)) {
  const start = performance.now();
  const report = await OpenReport.open(browser, folder, {viewport: {width: 1280, height: 800}});
  const opened = (performance.now() - start) / 1000;
  await report.page.waitForTimeout(3000);  // the small pictures are drawn
  const times = await report.page.evaluate(turn, frames);
  const size = statSync(join(folder, 'report.html')).size / 1e6;
  console.log(
      `${size.toFixed(2).padStart(7)}  ${opened.toFixed(2).padStart(7)}  ` +
      `${percentile(times, 0.5).toFixed(0).padStart(9)}  ` +
      `${percentile(times, 0.9).toFixed(0).padStart(4)}   ${folder}`);
  await report.page.close();
}
await browser.close();
