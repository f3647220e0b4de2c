// The stage of the studio: it fills the window whatever panels do, and what floats over it.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {barriers} from './browser.mjs';
import {inStudio} from './in_studio.mjs';

const phone = {
  width: 400,
  height: 800
};

function boxOf(page, selector) {
  return page.page.locator(selector).boundingBox();
}

function middleOf({x, y, width, height}) {
  return [x + width / 2, y + height / 2];
}

// What is at the middle of an element: whether the pointer reaches it.
function isOnTop(page, selector) {
  return page.page.evaluate((name) => {
    const node = document.querySelector(name);
    const box = node.getBoundingClientRect();
    const hit = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
    return node === hit || node.contains(hit);
  }, selector);
}

// Presses the pointer at the middle of an element.
async function press(page, selector) {
  await page.page.locator(selector).scrollIntoViewIfNeeded();
  await page.page.mouse.click(...middleOf(await boxOf(page, selector)));
  await page.settle();
}

// How far the middle of what is looked at is from the middle of what no panel covers [pixels].
async function distanceFromFree(page) {
  const target = await page.page.evaluate(() => window.studio.stage.controls.target.toArray());
  const [[x, y], [u, v]] = [await page.pixelOf(target), middleOf(await boxOf(page, '#free'))];
  return Math.hypot(x - u, y - v);
}

async function expectStageFills(page) {
  const {width, height} = page.page.viewportSize();
  assert.deepEqual(await boxOf(page, '#scene'), {x: 0, y: 0, width, height});
}

test('the stage fills the window, and what is looked at is where no panel is', async () => {
  for (const viewport of [{width: 1400, height: 900}, {width: 900, height: 700}, phone]) {
    await inStudio(['mug'], async (page) => {
      for (const camera of ['perspective', 'orthographic']) {
        if (camera === 'orthographic') await press(page, '#flat');
        await expectStageFills(page);
        assert.ok(await distanceFromFree(page) < 1, `${viewport.width}, ${camera}`);
        assert.ok(await isOnTop(page, '#state-bar'));
        // The free part is the canvas's: it is turned there.
        const before = await page.page.evaluate(() => window.studio.stage.direction().toArray());
        const [x, y] = middleOf(await boxOf(page, '#free'));
        await page.drag([x + 60, y], [x - 60, y]);
        const after = await page.page.evaluate(() => window.studio.stage.direction().toArray());
        assert.ok(Math.hypot(...after.map((a, i) => a - before[i])) > 0.1);
        assert.ok(await distanceFromFree(page) < 1, `${viewport.width}, ${camera}, turned`);
      }
    }, {viewport});
  }
});

test('panels fold by their headings, and stay so', async () => {
  for (const viewport of [{width: 1400, height: 900}, phone]) {
    await inStudio(['mug'], async (page) => {
      const free = await boxOf(page, '#free');
      for (const panel of ['world-panel', 'hand-panel', 'plan-panel', 'grasp', 'time-panel']) {
        const open = await boxOf(page, `#${panel}`);
        await press(page, `#${panel} summary`);
        const folded = await boxOf(page, `#${panel}`);
        assert.ok(folded.height < 60 && folded.height < open.height, `${panel}: ${folded.height}`);
        assert.deepEqual(await boxOf(page, '#free'), free);
        await expectStageFills(page);
      }
      assert.deepEqual(await barriers(page.page), []);
      await page.page.locator('#plan-panel summary').press('Enter');
      assert.ok(await page.page.locator('#plan').isVisible());
      await page.until(() => !localStorage.getItem('prehend-folded').includes('plan-panel'));
      await page.page.reload();
      await page.page.locator('#scene[data-drawn]').waitFor({state: 'attached'});
      await page.until(() => window.studio && window.studio.live.state !== null);
      await page.settle();
      assert.ok(await page.page.locator('#plan').isVisible());
      assert.ok(!await page.page.locator('#approach').isVisible());
    }, {viewport});
  }
});

test('without panels all of the stage is free, and the bar stays', async () => {
  for (const viewport of [{width: 1400, height: 900}, phone]) {
    await inStudio(['mug'], async (page) => {
      const narrow = await boxOf(page, '#free');
      await press(page, '#panels-shown');
      assert.equal(await page.page.locator('#panels-shown').getAttribute('aria-expanded'), 'false');
      assert.ok(!await page.page.locator('#approach').isVisible());
      const wide = await boxOf(page, '#free');
      assert.ok(wide.width * wide.height > 1.5 * narrow.width * narrow.height);
      await expectStageFills(page);
      assert.ok(await distanceFromFree(page) < 1);
      assert.ok(await isOnTop(page, '#state-bar'));
      await page.page.keyboard.press('n');
      await page.settle();
      assert.deepEqual(await boxOf(page, '#free'), narrow);
      assert.ok(await distanceFromFree(page) < 1);
    }, {viewport});
  }
});

test('the bar says what the grasp in hand is worth, also where its panel is folded', async () => {
  await inStudio(['mug'], async (page) => {
    await press(page, '#grasp summary');
    assert.equal(await page.text('#bar-epsilon'), '0');
    assert.equal(await page.text('#bar-contacts'), '0 contacts');
    assert.equal(await page.text('#bar-weight'), 'weight not held');
    await page.click('#approach');
    await page.click('#auto-grasp');
    const quality = await page.call('quality');
    assert.equal(await page.text('#bar-outcome'), quality.outcome.replaceAll('_', ' '));
    assert.equal(await page.text('#bar-contacts'), `${quality.contacts.length} contacts`);
    const shown = Number(await page.text('#bar-epsilon'));
    assert.ok(Math.abs(shown - quality.epsilon.lower) < 1e-3 * shown);
    const newtons =
        Number((await page.text('#bar-weight')).match(/^weight held with ([\d.]+) N$/)[1]);
    await page.page.locator('#load-weight').evaluate((node) => node.click());
    await page.settle();
    const largest = await page.page.locator('#forces').textContent();
    assert.equal(Number(largest.match(/largest normal ([\d.]+) N/)[1]), newtons);
    await page.click('#new');
    assert.deepEqual(
        [await page.text('#bar-outcome'), await page.text('#bar-epsilon')], ['–', '–']);
  });
});
