// The table of what a plan has found.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {barriers} from './browser.mjs';
import {inStudio} from './in_studio.mjs';

// Answers the results as the session has them.
async function planned(page, trials) {
  await page.page.locator('#plan-trials').fill(String(trials));
  await page.page.locator('#plan').click();
  await page.until(
      () => window.studio.live.state.results > 0 && !window.studio.live.state.planning);
  await page.settle();
  const {grasps} = await page.call('plan.results');
  await page.until(
      (count) => document.querySelectorAll('#results tbody tr').length === count, grasps.length);
  return grasps;
}

// Presses the pointer at the middle of an element.
async function press(page, selector) {
  await page.page.locator(selector).scrollIntoViewIfNeeded();
  const {x, y, width, height} = await page.page.locator(selector).boundingBox();
  await page.page.mouse.click(x + width / 2, y + height / 2);
  await page.settle();
}

function ranks(page) {
  return page.page.evaluate(
      () => [...document.querySelectorAll('#results tbody tr')].map(
          (row) => Number(row.dataset.rank)));
}

function sortedBy(page, name) {
  return page.page.locator(`#results th:has([data-sort="${name}"])`).getAttribute('aria-sort');
}

// The ranks in the order of a value, those of equal value by rank.
function order(grasps, of, sign) {
  return grasps.map((grasp, i) => ({rank: i + 1, value: of(grasp)}))
      .sort((a, b) => sign * (a.value - b.value) || a.rank - b.rank)
      .map(({rank}) => rank);
}

test('the table is sorted by its headings, one way and the other', async () => {
  await inStudio(['mug'], async (page) => {
    const grasps = await planned(page, 150);
    assert.ok(grasps.length > 3);
    const found = order(grasps, () => 0, 1);
    assert.deepEqual(await ranks(page), found);
    assert.equal(await sortedBy(page, 'rank'), 'ascending');
    const shown = Number(await page.text('#results tr[data-rank="2"] [data-cell="epsilon"]'));
    assert.ok(Math.abs(shown - grasps[1].epsilon) < 1e-2 * shown);
    await press(page, '#results [data-sort="volume"]');
    assert.deepEqual(await ranks(page), order(grasps, ({volume}) => volume, -1));
    assert.equal(await sortedBy(page, 'volume'), 'descending');
    assert.equal(await sortedBy(page, 'rank'), 'none');
    await page.page.keyboard.press('Enter');  // the focus has stayed on the heading
    assert.deepEqual(await ranks(page), order(grasps, ({volume}) => volume, 1));
    assert.equal(await sortedBy(page, 'volume'), 'ascending');
    await press(page, '#results [data-sort="epsilon"]');
    assert.equal(await sortedBy(page, 'epsilon'), 'descending');
    assert.deepEqual(await ranks(page), order(grasps, ({epsilon}) => epsilon, -1));
    await press(page, '#results [data-sort="rank"]');
    assert.deepEqual(await ranks(page), found);
    // Where no result has a path, there is no column for it.
    assert.equal(await page.page.locator('#results [data-sort="path"]').count(), 0);
    assert.deepEqual(await barriers(page.page), []);
  });
});

test('a click on a row shows its grasp, from a side where the hand hides little', async () => {
  await inStudio(['mug'], async (page) => {
    const grasps = await planned(page, 150);
    await press(page, '#results tr[data-rank="3"] [data-cell="epsilon"]');
    const {hand} = await page.state();
    assert.deepEqual(hand.joints, grasps[2].joints);
    const marked = page.page.locator('#results tr[aria-current="true"]');
    assert.equal(await marked.getAttribute('data-rank'), '3');
    // What holding the weight takes is known now.
    await page.page.locator('#results tr[data-rank="3"] [data-cell="weight"]', {hasText: /\d/})
        .waitFor();
    const newtons = Number(await page.text('#results tr[data-rank="3"] [data-cell="weight"]'));
    assert.equal(await page.text('#bar-weight'), `weight held with ${newtons} N`);
    // Neither along the way of the hand nor from under the object.
    const {approach, z} = await page.page.evaluate(() => {
      const {stage} = window.studio;
      const along = new window.THREE.Vector3(...stage.handData.approach)
                        .transformDirection(stage.hand.root.matrixWorld);
      return {approach: along.dot(stage.direction()), z: stage.direction().z};
    });
    assert.ok(Math.abs(approach) < 0.8 && z > -1e-6, `${approach}, ${z}`);
    // No longer that grasp: no row is marked.
    await page.click('#open');
    await marked.waitFor({state: 'detached'});
    await page.click('#undo');
    await marked.waitFor();
  });
});

test('rows are reached and shown by keys', async () => {
  await inStudio(['mug'], async (page) => {
    const grasps = await planned(page, 150);
    await page.page.evaluate(() => window.studio.handling.select('object'));
    const {object} = await page.state();
    assert.equal(await page.page.locator('#results [data-grasp][tabindex="0"]').count(), 1);
    await page.page.locator('#results [data-sort]').last().focus();
    await page.page.keyboard.press('Tab');
    for (const key of ['ArrowDown', 'ArrowDown', 'ArrowUp']) await page.page.keyboard.press(key);
    await page.page.keyboard.press('Enter');
    await page.settle();
    assert.deepEqual((await page.state()).hand.joints, grasps[1].joints);
    assert.deepEqual((await page.state()).object, object);  // arrows have not moved it
    await page.page.locator('#results tr[aria-current="true"]').waitFor();
    const focused = await page.page.evaluate(() => document.activeElement.dataset.grasp);
    assert.equal(focused, '1');
    await page.page.keyboard.press('End');
    const last = await page.page.evaluate(() => document.activeElement.dataset.grasp);
    assert.equal(last, String(grasps.length - 1));
  });
});
