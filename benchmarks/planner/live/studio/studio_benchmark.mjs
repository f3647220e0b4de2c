// How soon the studio answers: PREHEND_PROGRAM=PROGRAM node
// benchmarks/planner/live/studio/studio_benchmark.mjs
//
// Rows: the time from the event of a pointer that drags the hand about the object to the picture
// with the quality of where the hand is then, as a whole and without the time that drawing took,
// which is the processor's here and a graphics card's elsewhere; and the rate of pictures while a
// plan finds a thousand grasps.
import {launch} from '../../../../tests/web/browser.mjs';
import {Studio} from '../../../../tests/web/studio.mjs';

const moves = 60;
const found = 1000;

function percentile(values, part) {
  return [...values].sort((a, b) => a - b)[Math.floor(part * (values.length - 1))];
}

function row(name, values, unit) {
  const columns = [0.5, 0.9, 1].map((part) => percentile(values, part).toFixed(1).padStart(8));
  console.log(`${name.padEnd(44)}${columns.join('')}  ${unit}`);
}

// In the page: notes when a pointer moved, when the picture with what was judged since then was
// there, and how long drawing took until then.
function instrument() {
  const {studio} = window;
  const notes = {moved: 0, drawing: 0, judged: false, seen: 0, drawn: 0};
  window.notes = notes;
  window.addEventListener('mousemove', (event) => {
    Object.assign(notes, {moved: event.timeStamp, drawing: 0});
  }, true);
  const show = studio.grasp.show.bind(studio.grasp);
  studio.grasp.show = (...words) => {
    show(...words);
    notes.judged = true;
  };
  const timed = (view, name, then) => {
    const draw = view[name].bind(view);
    view[name] = (...words) => {
      const start = performance.now();
      draw(...words);
      view.renderer.getContext().finish();
      notes.drawing += performance.now() - start;
      then();
    };
  };
  timed(studio.grasp.wrench, 'draw', () => {});
  timed(studio.stage, 'drawNow', () => {
    if (!notes.judged) return;
    Object.assign(notes, {judged: false, seen: performance.now(), drawn: notes.drawing});
  });
}

// In the page: the pictures of the next moments, as times between frames, until so many grasps were
// found.
async function framesUntil(count) {
  const times = [];
  let last = performance.now();
  while (window.studio.plan.found.length < count) {
    const now = await new Promise((done) => requestAnimationFrame(done));
    times.push(now - last);
    last = now;
  }
  return times;
}

const browser = await launch();
const studio = await Studio.start('mug');
const page = await studio.open(browser, {viewport: {width: 1280, height: 800}});
await page.click('#approach');
await page.click('#back-off');
await page.page.evaluate(() => window.studio.handling.select('hand'));
await page.settle();
await page.page.evaluate(instrument);

const [foot, tip] = await page.gizmoArrow([0, 0, 1]);
const at = foot.map((x, i) => x + 0.7 * (tip[i] - x));
const {mouse} = page.page;
await mouse.move(...at);
await mouse.down();
const whole = [];
const without = [];
for (let k = 1; k <= moves; ++k) {
  // Up and down, so that the hand touches half of the time.
  await mouse.move(at[0], at[1] + 30 * Math.sin(k / 4));
  await page.settle();
  const {moved, seen, drawn} = await page.page.evaluate(() => window.notes);
  const total = seen - moved;
  whole.push(total);
  without.push(total - drawn);
}
await mouse.up();
console.log(`${''.padEnd(44)}  median     p90     max`);
row('pointer to quality, drawn', whole, 'ms');
row('the same without drawing', without, 'ms');

await page.page.locator('#plan-trials').fill('1000000');
await page.page.locator('#plan').click();
const frames = await page.page.evaluate(framesUntil, found);
row(`between frames until ${found} grasps are found`, frames, 'ms');
const seconds = frames.reduce((sum, time) => sum + time, 0) / 1000;
console.log(`frames a second: ${(frames.length / seconds).toFixed(1)}`);
await page.page.locator('#cancel').click();
await page.until(() => !window.studio.live.state.planning);
await studio.stop();
await browser.close();
