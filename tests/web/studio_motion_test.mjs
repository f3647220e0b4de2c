// What moves in the studio: time, the arm, and bodies that are dragged against each other.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {inStudio, sceneBytes} from './in_studio.mjs';

test('time plays: the object falls, is put back, and stays where it was', async () => {
  await inStudio(['mug'], async (page) => {
    const bytes = await sceneBytes(page);
    await page.page.locator('#time-play').click();
    await page.until(() => parseFloat(document.getElementById('time-now').textContent) > 0.15);
    await page.page.locator('#time-play').click();
    await page.until(() => !window.studio.time.running);
    const {X_world_object, time} = await page.call('time.state');
    const {object} = await page.state();
    const fallen = object.X_world_object.position[2] - X_world_object.position[2];
    assert.ok(Math.abs(fallen - 9.81 / 2 * time * time) < 0.03, `${fallen} m in ${time} s`);
    const drawn =
        await page.page.evaluate(() => window.studio.stage.bodies.get('object').group.position.z);
    assert.ok(Math.abs(drawn - X_world_object.position[2]) < 1e-6);
    assert.match(await page.text('#status'), /^$|time/);
    await page.page.locator('#approach').click();
    await page.page.locator('#status.wrong').waitFor();  // nothing else moves meanwhile
    await page.page.locator('#time-reset').click();
    await page.until(() => document.getElementById('time-now').textContent === '0.000 s');
    await page.page.locator('#time-stop').click();
    await page.until(() => window.studio.live.state.time === null);
    await page.settle();
    assert.equal(await sceneBytes(page), bytes);
  });
});

test('the arm follows the hand, and says where it cannot', async () => {
  await inStudio(['panda_on_table'], async (page) => {
    await page.page.locator('#plan-trials').fill('200');
    await page.page.locator('#plan').click();
    await page.until(
        () => window.studio.live.state.results > 0 && !window.studio.live.state.planning);
    await page.settle();
    await page.click('#results button[data-grasp="0"]');
    assert.equal(await page.text('#arm-reach'), 'holds the hand');
    const before = (await page.state()).arm.joints.map(({value}) => value);
    await page.call('hand.open');
    await page.call('hand.back_off', {distance: 0.05});
    await page.settle();
    const after = (await page.state()).arm.joints.map(({value}) => value);
    assert.notDeepEqual(after, before);
    await page.click('#undo');
    await page.click('#undo');
    await page.page.locator('#path').click();
    await page.page.locator('#path-player:not([hidden])').waitFor();
    await page.until(() => window.studio.path.player.playing === false);
    const {samples} = await page.page.evaluate(() => window.studio.path.path);
    assert.ok(samples.length > 10);
    await page.call('switches.set', {stop_at_contact: false});
    await page.call('hand.move', {X_world_hand: {position: [0, 0, 5]}});
    await page.until(() => !window.studio.live.state.arm.reached);
    await page.page.locator('#arm-reach.wrong').waitFor();
  });
});

test('an object that is dragged stops at the hand, and one undo takes all of it back', async () => {
  await inStudio(['mug'], async (page) => {
    const before = await page.state();
    await page.click('#bodies [data-body="object"] .body');
    await page.pull([0, 0, 1], 0.25);
    const touching = await page.state();
    const [from, to] = [before, touching].map(({object}) => object.X_world_object.position[2]);
    assert.ok(to > from + 0.005 && to < from + 0.24, `from ${from} to ${to}`);
    assert.match(await page.text('#status'), /touch/);
    assert.deepEqual((await page.call('collisions')).collisions, []);
    assert.deepEqual(touching.hand.X_world_hand, before.hand.X_world_hand);
    await page.click('#undo');
    assert.deepEqual((await page.state()).object, before.object);
  });
});
