// The shapes that the object is taken for, as the studio draws and lists them.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {barriers} from './browser.mjs';
import {inStudio} from './in_studio.mjs';

// Clicks with the pointer where the switch is.
async function flip(page) {
  const box = page.page.locator('#show-primitives');
  await box.scrollIntoViewIfNeeded();
  const {x, y, width, height} = await box.boundingBox();
  await page.page.mouse.click(x + width / 2, y + height / 2);
  await page.settle();
}

// Names of the shapes in the list.
function listed(page) {
  return page.page.locator('#primitives tbody th').allInnerTexts();
}

// What is drawn: how many solids, and where their frame is in the world.
function drawn(page) {
  return page.page.evaluate(() => {
    const {solids} = window.studio.stage;
    solids.updateWorldMatrix(true, false);
    return {count: solids.children.length, X: solids.matrixWorld.elements.slice(12, 15)};
  });
}

// How often the page has asked for primitives from now on.
async function countQuestions(page) {
  await page.page.evaluate(() => {
    const {connection} = window.studio.live;
    const {call} = connection;
    window.asked = 0;
    connection.call = (command, fields) => {
      if (command === 'primitives') ++window.asked;
      return call.call(connection, command, fields);
    };
  });
  return () => page.page.evaluate(() => window.asked);
}

test('primitives are drawn and listed in mm while the switch is on', async () => {
  await inStudio(['mug'], async (page) => {
    const asked = await countQuestions(page);
    await page.click('#approach');
    assert.equal(await asked(), 0);
    assert.ok(await page.page.locator('#primitives-list').isHidden());
    await flip(page);
    assert.equal(await asked(), 1);
    const told = await page.call('primitives');
    assert.deepEqual(await listed(page), [...told.primitives.map(({shape}) => shape), 'together']);
    assert.equal((await drawn(page)).count, told.primitives.length);
    // The first is the body of the mug; its distances are those of the session, in mm.
    const [first] = told.primitives;
    assert.equal(first.shape, 'cylinder');
    const cells =
        await page.page.locator('#primitives tbody tr').first().locator('td').allInnerTexts();
    assert.match(cells[0], /^⌀ \d[\d.]* × \d[\d.]*$/);
    const height = Number(cells[0].split(' × ')[1]);
    assert.ok(Math.abs(height - 1000 * first.height) < 0.5, cells[0]);
    for (const [i, key] of [[1, 'median'], [2, 'percentile_95']]) {
      assert.match(cells[i], /^\d+(\.\d+)?$/);
      assert.ok(Math.abs(Number(cells[i]) - 1000 * first.distances[key]) < 0.006, cells[i]);
    }
    assert.deepEqual(await barriers(page.page), []);
    await flip(page);
    assert.ok(await page.page.locator('#primitives-list').isHidden());
    assert.equal((await drawn(page)).count, 0);
  });
});

test('they stay on the object, and are asked for again only where it is another one', async () => {
  await inStudio(['mug'], async (page) => {
    const asked = await countQuestions(page);
    // With the keyboard, as the other switches.
    await page.page.locator('#show-primitives').focus();
    await page.page.keyboard.press('Space');
    await page.settle();
    const shapes = await listed(page);
    await page.call('switches.set', {stop_at_contact: false});
    const {object} = await page.state();
    const [x, y, z] = object.X_world_object.position;
    await page.call('object.move', {X_world_object: {position: [x + 0.1, y, z + 0.2]}});
    await page.settle();
    const moved = await drawn(page);
    [x + 0.1, y, z + 0.2].forEach((at, i) => assert.ok(Math.abs(moved.X[i] - at) < 1e-6));
    assert.deepEqual(await listed(page), shapes);
    await page.page.keyboard.press('Space');
    await page.page.keyboard.press('Space');
    await page.settle();
    assert.equal(await asked(), 1);
    await page.call('object.set', {generate: 'ball', triangles: 600});
    await page.settle();
    assert.deepEqual(await listed(page), ['sphere', 'together']);
    assert.equal(await asked(), 2);
    await page.call('object.remove');
    await page.settle();
    assert.ok(await page.page.locator('#primitives-list').isHidden());
    assert.equal((await drawn(page)).count, 0);
    await page.call('undo');
    await page.settle();
    assert.deepEqual(await listed(page), ['sphere', 'together']);
    assert.equal(await asked(), 2);
  });
});

test('what the scene states has no distances', async () => {
  await inStudio(['mug'], async (page) => {
    await flip(page);
    const scene = JSON.parse((await page.call('scene.text')).text);
    scene.object.primitives = [{shape: 'cylinder', radius: 0.04, height: 0.1}];
    await page.page.evaluate(
        (text) => window.studio.live.ask('scene.load', {text}), JSON.stringify(scene));
    await page.settle();
    assert.deepEqual(await listed(page), ['cylinder']);
    const cells = await page.page.locator('#primitives tbody td').allInnerTexts();
    assert.deepEqual(cells, ['⌀ 80 × 100', '–', '–']);
  });
});
