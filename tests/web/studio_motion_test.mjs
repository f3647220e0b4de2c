// What moves in the studio: time, the arm, and bodies that are dragged against each other.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {anotherTab, inStudio, sceneBytes} from './in_studio.mjs';

test('time plays: the object falls, is put back, and stays where it was', async () => {
  await inStudio(['mug'], async (page) => {
    const bytes = await sceneBytes(page);
    // As on a busy machine, where frames have begun long before they are told of.
    await page.page.evaluate(() => {
      const ask = window.requestAnimationFrame.bind(window);
      window.requestAnimationFrame = (run) => ask((time) => run(time - 100));
    });
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

// A plan of so many candidates, waited for.
async function planned(page, trials) {
  await page.page.locator('#plan-trials').fill(String(trials));
  await page.page.locator('#plan').click();
  await page.until(
      () => window.studio.live.state.results > 0 && !window.studio.live.state.planning);
  await page.settle();
}

// Asks for a path by the button, and cancels the search by the other as soon as it has begun: the
// search takes a second, so nothing may come in between.
function cancelPath() {
  const {live} = window.studio;
  let pressed = false;
  live.on('state', ({finding_path}) => {
    if (finding_path && !pressed) document.getElementById('cancel').click();
    pressed = pressed || finding_path;
  });
  document.getElementById('path').click();
}

test('the search for a path is cancelled, and all pages hear of it', async () => {
  await inStudio(['living_room'], async (page, session) => {
    await planned(page, 100);
    await page.click('#results button[data-grasp="0"]');
    const other = await anotherTab(session);
    await other.page.evaluate(() => {
      window.seen = [];
      window.studio.live.on('state', ({finding_path}) => {
        const byButtons = ['path', 'plan'].map((id) => document.getElementById(id).disabled);
        window.seen.push([finding_path, ...byButtons]);
      });
    });
    await page.page.evaluate(cancelPath);
    await page.until(() => document.getElementById('status').textContent === 'no path: cancelled');
    await other.until(() => window.seen.length > 0 && !window.seen[window.seen.length - 1][0]);
    const seen = await other.page.evaluate(() => window.seen);
    assert.deepEqual(seen, [[true, true, true], [false, false, false]]);
    await page.until(() => !window.studio.live.state.finding_path);
    assert.ok(await page.page.locator('#path-player').isHidden());
    await other.close();
  });
});

test('results that were planned with paths play them', async () => {
  await inStudio(['panda_on_table'], async (page) => {
    await page.page.locator('#plan-paths').check();
    await planned(page, 100);
    const {grasps} = await page.call('plan.results');
    assert.ok(grasps.length > 0 && grasps.every(({path}) => path > 0));
    const seconds = grasps[0].path.toFixed(1);
    assert.equal(
        parseFloat(await page.text('#results tr[data-rank="1"] [data-cell="path"]')),
        Number(seconds));
    await page.page.locator('#results [aria-label="play the path of grasp 1"]').click();
    await page.page.locator('#path-player:not([hidden])').waitFor();
    await page.until(() => window.studio.path.player.playing === false);
    const {hand} = await page.state();
    assert.deepEqual(hand.joints, grasps[0].joints);
    assert.equal(await page.text('#status'), `a path of ${seconds} s`);
    const {samples} = await page.page.evaluate(() => window.studio.path.path);
    assert.ok(Math.abs(samples[samples.length - 1].time - grasps[0].path) < 1e-9);
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

// The share of places on the rim of each joint's handle at which the pointer takes that joint.
function sharesOfRims() {
  const {handles, stage} = window.studio.handling;
  const box = stage.canvas.getBoundingClientRect();
  stage.camera.updateMatrixWorld();
  const places = [...Array(72).keys()].map((k) => k * Math.PI / 36);
  return handles.handles.map(({joint, group}) => {
    group.updateMatrixWorld(true);
    const own = places.filter((angle) => {
      const at = new window.THREE.Vector3(Math.cos(angle), Math.sin(angle), 0)
                     .applyMatrix4(group.matrixWorld)
                     .project(stage.camera);
      const event = {
        clientX: box.left + (at.x + 1) / 2 * box.width,
        clientY: box.top + (1 - at.y) / 2 * box.height
      };
      return handles.pick(event) === joint;
    });
    return own.length / places.length;
  });
}

test('each joint of an arm can be taken hold of', async () => {
  for (const [scene, joints] of [['panda_on_table', 7], ['ur5e_on_table', 6], ['shelf', 6]]) {
    await inStudio([scene], async (page) => {
      await page.page.evaluate(() => window.studio.handling.select('arm'));
      await page.settle();
      for (const view of ['1', '3', '5', '7']) {
        await page.page.keyboard.press(view);
        await page.page.keyboard.press('Shift+F');
        await page.settle();
        const shares = await page.page.evaluate(sharesOfRims);
        assert.equal(shares.length, joints);
        for (const share of shares) assert.ok(share > 0.25, `${scene}, view ${view}: ${shares}`);
      }
    });
  }
});
