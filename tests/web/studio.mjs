// A live session of the program, and pages of it in a browser.
import assert from 'node:assert/strict';
import {spawn} from 'node:child_process';
import {once} from 'node:events';
import {createInterface} from 'node:readline';

import {watch} from './browser.mjs';

// The program with these words after "studio", listening on free ports.
export class Studio {
  static async start(...words) {
    const studio = new Studio();
    studio.process = spawn(
        process.env.PREHEND_PROGRAM, ['studio', ...words, '--port', '0'],
        {stdio: ['ignore', 'pipe', 'ignore']});
    studio.ended = once(studio.process, 'exit');
    for await (const line of createInterface({input: studio.process.stdout})) {
      const found = line.match(/^studio (http:\S+)$/);
      if (!found) continue;
      studio.address = found[1];
      return studio;
    }
    throw new Error('the program has ended');
  }

  // Answers the exit status.
  async stop() {
    this.process.kill('SIGINT');
    const [status] = await this.ended;
    return status;
  }

  open(browser, options) {
    return OpenStudio.open(browser, this.address, options);
  }
}

// One page of a session; complaints are what should not happen.
export class OpenStudio {
  static async open(browser, address, {
    deviceScaleFactor = 0.5,
    viewport =
    {
      width: 1280, height: 900
    }
  } = {}) {
    const studio = new OpenStudio();
    const context = await browser.newContext({viewport, deviceScaleFactor, acceptDownloads: true});
    studio.page = await context.newPage();
    Object.assign(studio, watch(studio.page));
    await studio.page.addInitScript(() => localStorage.setItem('prehend-toured', 'yes'));
    await studio.page.goto(address);
    await studio.page.locator('#scene[data-drawn]').waitFor({state: 'attached'});
    await studio.until(() => window.studio.live.state !== null);
    await studio.settle();
    return studio;
  }

  // Until a function of the page is true.
  until(test, argument) {
    return this.page.waitForFunction(test, argument, {timeout: 0});
  }

  // Until the session has answered everything, all of it is drawn, and the grasp in hand is judged.
  // The state that a request leads to is sent after its answer, and before the answer to the next
  // request: hence one more is asked, or the page could seem at rest between the two.
  async settle() {
    await this.rest();
    await this.call('state');
    await this.rest();
  }

  // A coarse picture does: the fine one follows after a pause of up to 3 seconds in which nothing
  // moves.
  async rest() {
    await this.until(() => {
      const {live, stage, grasp, handling} = window.studio;
      return live.connection.waiting.size === 0 && !stage.sync.busy && !grasp.judge.busy &&
          !handling.moves.busy && !handling.turns.busy && stage.canvas.dataset.drawn !== 'stale';
    });
  }

  state() {
    return this.page.evaluate(() => window.studio.live.state);
  }

  // What the session replies to a request that does not come from the page's elements.
  call(command, fields = {}) {
    return this.page.evaluate(
        ([name, more]) => window.studio.live.connection.call(name, more), [command, fields]);
  }

  async click(selector) {
    await this.page.locator(selector).click();
    await this.settle();
  }

  text(selector) {
    return this.page.locator(selector).innerText();
  }

  // Where a point of the world is on the screen.
  pixelOf(point) {
    return this.page.evaluate((p) => {
      const {stage} = window.studio;
      stage.camera.updateMatrixWorld();
      const at = new window.THREE.Vector3(...p).project(stage.camera);
      const box = stage.canvas.getBoundingClientRect();
      return [box.left + (at.x + 1) / 2 * box.width, box.top + (1 - at.y) / 2 * box.height];
    }, point);
  }

  // Presses the pointer at one place of the screen, and lets it go at another.
  async drag([x0, y0], [x1, y1], steps = 20) {
    const {mouse} = this.page;
    await mouse.move(x0, y0);
    await mouse.down();
    for (let k = 1; k <= steps; ++k) {
      await mouse.move(x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps);
    }
    await mouse.up();
    await this.settle();
  }

  // Where the arrow of the gizmo along an axis of the world is on the screen: its beginning and
  // its end.
  async gizmoArrow(axis) {
    const {from, length} = await this.page.evaluate(() => {
      const {handling, stage} = window.studio;
      // As three.js sizes its gizmo (TransformControls.js): a seventh of the distance.
      const eye = stage.camera.position.distanceTo(handling.proxy.position);
      return {from: handling.proxy.position.toArray(), length: eye / 7};
    });
    return [await this.pixelOf(from), await this.pixelOf(from.map((x, i) => x + length * axis[i]))];
  }

  // Takes hold of the gizmo's arrow along an axis, and moves it by a way of the world [m].
  async pull(axis, way) {
    const [foot, tip] = await this.gizmoArrow(axis);
    const start = foot.map((x, i) => x + 0.7 * (tip[i] - x));
    const from = await this.page.evaluate(() => window.studio.handling.proxy.position.toArray());
    const [a, b] =
        [await this.pixelOf(from), await this.pixelOf(from.map((x, i) => x + way * axis[i]))];
    await this.drag(start, start.map((x, i) => x + b[i] - a[i]));
  }

  async close() {
    assert.deepEqual(this.complaints, []);
    await this.page.context().close();
  }
}
