// What a person meets who takes hold of a scene in a browser.
import assert from 'node:assert/strict';
import {readFileSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {anotherTab, inStudio, sceneBytes} from './in_studio.mjs';
import {folder, jsonOf, nastyName, run} from './program.mjs';
import {Studio} from './studio.mjs';

// Epsilon of the hand closed from a posture, as `evaluate` says.
function evaluated(scene, {X_object_hand, dofs}) {
  const file = join(folder, 'given.json');
  writeFileSync(
      file, JSON.stringify({grasps: [{X_object_hand, dofs: dofs.map(({value}) => value)}]}));
  const out = run('evaluate', file, '--scene', scene, '--no-report');
  return jsonOf(join(out, 'grasps.json')).grasps[0].epsilon;
}

test('the hand is dragged until it touches, closes, and epsilon is that of evaluate', async () => {
  await inStudio(['mug'], async (page) => {
    const before = await page.state();
    await page.click('#bodies [data-body="hand"] .body');
    await page.pull([0, 0, 1], -0.25);
    const touching = await page.state();
    const [from, to] = [before, touching].map(({hand}) => hand.X_world_hand.position);
    assert.ok(to[2] < from[2] - 0.01, `from ${from} to ${to}`);
    assert.ok(to[2] > from[2] - 0.24, 'it went through the mug');
    assert.match(await page.text('#status'), /stopped: .* and mug touch/);
    assert.deepEqual((await page.call('collisions')).collisions, []);
    const start = (await page.state()).hand;
    await page.click('#auto-grasp');
    assert.equal(await page.text('#outcome'), 'stable');
    const shown = Number(await page.page.locator('#epsilon').getAttribute('data-lower'));
    assert.ok(shown > 0);
    assert.ok(Math.abs(shown - evaluated('mug', start)) < 1e-9);
    assert.ok(Number(await page.text('#contact-count')) >= 3);
  });
});

// Where the handle of a joint is taken hold of: a point of its ring.
function handlePoint(page, dof) {
  return page.page.evaluate((name) => {
    const {handling, live, stage} = window.studio;
    const d = live.state.hand.dofs.findIndex((one) => one.name === name);
    const handle =
        handling.handles.handles.find(({joint}) => stage.handData.drives[joint].dof === d);
    const {origin, axis} = handling.handles.lineOf(handle.joint);
    const across = new window.THREE.Vector3(0, 0, 1).cross(axis);
    if (across.length() < 0.1) across.set(1, 0, 0).cross(axis);
    across.setLength(handle.group.scale.x);
    return {origin: origin.toArray(), point: origin.add(across).toArray()};
  }, dof);
}

// Turns the handle of a degree of freedom around its axis, as many times as said.
async function turnHandle(page, dof, turns) {
  const {origin, point} = await handlePoint(page, dof);
  const [center, start] = [await page.pixelOf(origin), await page.pixelOf(point)];
  const [x, y] = start.map((s, i) => s - center[i]);
  const {mouse} = page.page;
  await mouse.move(...start);
  await mouse.down();
  for (let k = 1; k <= 48; ++k) {
    const angle = 2 * Math.PI * turns * k / 48;
    await mouse.move(
        center[0] + x * Math.cos(angle) - y * Math.sin(angle),
        center[1] + x * Math.sin(angle) + y * Math.cos(angle));
    await page.settle();
  }
  await mouse.up();
  await page.settle();
  return (await page.state()).hand.dofs.find(({name}) => name === dof);
}

test('a joint that is dragged beyond its limit stays there', async () => {
  await inStudio(['mug'], async (page) => {
    await page.call('switches.set', {stop_at_contact: false});
    await page.page.evaluate(() => window.studio.handling.select('hand', 'proximal_1'));
    await page.settle();
    const ends =
        [await turnHandle(page, 'finger_1', -1.5), await turnHandle(page, 'finger_1', 1.5)];
    const {lower, upper} = ends[0];
    assert.deepEqual(ends.map(({value}) => value).sort(), [lower, upper]);
    const slider = page.page.locator('#dofs input[type="range"][data-dof="spread"]');
    const box = await slider.boundingBox();
    const y = box.y + box.height / 2;
    await page.drag([box.x + box.width / 2, y], [box.x + box.width + 300, y]);
    const spread = (await page.state()).hand.dofs.find(({name}) => name === 'spread');
    assert.ok(Math.abs(spread.value - spread.upper) < 1e-9 && spread.value <= spread.upper);
  });
});

test('undone to the start, the scene has the same bytes', async () => {
  await inStudio(['mug'], async (page) => {
    const bytes = await sceneBytes(page);
    await page.click('#approach');
    await page.click('#auto-grasp');
    await page.call(
        'obstacle.add', {generate: 'box', name: 'box', X_world_body: {position: [1, 0, 0]}});
    await page.page.locator('#bodies [data-body="object"] select').selectOption('metal');
    await page.settle();
    assert.notEqual(await sceneBytes(page), bytes);
    for (let k = 0; k < 50 && !(await page.page.locator('#undo').isDisabled()); ++k) {
      await page.click('#undo');
    }
    assert.equal(await sceneBytes(page), bytes);
    assert.equal((await page.state()).undo, 0);
    await page.page.keyboard.press('Control+y');
    await page.settle();
    assert.equal((await page.state()).undo, 1);
  });
});

test('a plan is cancelled, and what it has found is kept', async () => {
  await inStudio(['mug'], async (page) => {
    await page.page.locator('#plan-trials').fill('500000');
    await page.page.locator('#plan').click();
    await page.until(() => window.studio.plan.found.length >= 3);
    await page.page.locator('#results [data-grasp]').first().waitFor();
    await page.page.locator('#cancel').click();
    await page.until(() => !window.studio.live.state.planning);
    await page.settle();
    const {results, planning} = await page.state();
    assert.ok(!planning && results >= 3, `${results} results`);
    assert.match(await page.text('#plan-words'), /^cancelled: \d+ grasps/);
    await page.until(
        (count) => document.querySelectorAll('#results [data-grasp]').length === count, results);
    await page.click('#results button[data-grasp="1"]');
    const [, second] = (await page.call('plan.results')).grasps;
    const {hand} = await page.state();
    assert.deepEqual(hand.joints, second.joints);
    const shown = Number(await page.page.locator('#epsilon').getAttribute('data-lower'));
    assert.ok(Math.abs(shown - second.epsilon) < 1e-9, `${shown} is not ${second.epsilon}`);
  });
});

test('grasps are pinned, compared and gone back to', async () => {
  await inStudio(['mug'], async (page) => {
    const before = (await page.state()).hand;
    await page.click('#pin');
    await page.click('#approach');
    await page.click('#auto-grasp');
    await page.click('#pin');
    assert.equal(await page.page.locator('#pins li').count(), 2);
    await page.click('#pins [data-pin="pin 1"] button:has-text("go")');
    assert.deepEqual((await page.state()).hand, before);
    await page.click('#pins [data-pin="pin 1"] button:has-text("✕")');
    assert.equal(await page.page.locator('#pins li').count(), 1);
  });
});

// A pyramid of 60 mm, in metres.
const mesh = 'v 0 0 0\nv 0.06 0 0\nv 0 0.06 0\nv 0 0 0.06\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n';

async function dropFile(page, name, content) {
  const transfer = await page.page.evaluateHandle(([file, text]) => {
    const data = new DataTransfer();
    data.items.add(new File([text], file));
    return data;
  }, [name, content]);
  await page.page.dispatchEvent('#stage', 'drop', {dataTransfer: transfer});
}

test('a mesh that is dropped becomes the object, and its name is no markup', async () => {
  await inStudio(['--empty'], async (page) => {
    assert.match(await page.text('#problem'), /no object/);
    await dropFile(page, `${nastyName.replace('/', '')}.obj`, mesh);
    await page.page.locator('#add-name').fill(nastyName);
    await page.click('#add-ok');
    const {object, problem} = await page.state();
    assert.equal(object.name, nastyName);
    assert.equal(object.triangles, 4);
    assert.equal(problem, null);
    assert.equal(await page.text('#bodies [data-body="object"] .body'), nastyName);
    await dropFile(page, 'damaged.obj', 'v 0 0');
    await page.click('#add-ok');
    assert.match(await page.text('#status'), /mesh/);
    assert.equal((await page.state()).object.name, nastyName);
    await dropFile(page, 'picture.png', 'no');
    assert.match(await page.text('#status'), /neither a scene/);
  });
});

test('a scene is saved, and opened again as it was', async () => {
  await inStudio(['mug'], async (page) => {
    await page.call('obstacle.add', {
      generate: 'box',
      name: 'box',
      X_world_body: {position: [0.5, 0, 0]},
    });
    await page.settle();
    const bytes = await sceneBytes(page);
    const [saved] = await Promise.all([
      page.page.waitForEvent('download'),
      page.page.locator('#save').click(),
    ]);
    const file = join(folder, 'saved.json');
    await saved.saveAs(file);
    assert.equal(readFileSync(file, 'utf8'), bytes);
    await page.click('#new');
    assert.equal((await page.state()).object, null);
    await page.page.locator('#scene-file').setInputFiles(file);
    await page.until(() => window.studio.live.state.object !== null);
    await page.settle();
    assert.equal(await sceneBytes(page), bytes);
    assert.equal(await page.page.locator('#bodies li').count(), 3);
  });
});

test('two tabs see the same session', async () => {
  await inStudio(['mug'], async (one, studio) => {
    const two = await anotherTab(studio);
    await one.click('#approach');
    await one.click('#auto-grasp');
    await two.until(
        (revision) => window.studio.live.state.revision === revision, (await one.state()).revision);
    await two.settle();
    assert.deepEqual(await two.state(), await one.state());
    assert.equal(await two.text('#epsilon'), await one.text('#epsilon'));
    await two.click('#undo');
    await one.until(
        (revision) => window.studio.live.state.revision === revision, (await two.state()).revision);
    assert.deepEqual((await one.state()).hand, (await two.state()).hand);
    await two.close();
  });
});

test('everything can be done by keys', async () => {
  await inStudio(['mug'], async (page) => {
    const {keyboard} = page.page;
    const press = async (key) => {
      await keyboard.press(key);
      await page.settle();
    };
    await press('h');
    assert.equal(await page.text('#selected'), 'hand');
    const from = (await page.state()).hand.X_world_hand.position;
    await press('ArrowRight');
    const to = (await page.state()).hand.X_world_hand.position;
    assert.ok(Math.abs(to[0] - from[0] - 0.005) < 1e-12);
    await press('ArrowLeft');
    await press('a');
    await press('g');
    assert.notEqual(await page.text('#contact-count'), '0');
    await press('o');
    await press('Control+z');
    await press('Escape');
    assert.equal(await page.text('#selected'), 'nothing');
    await keyboard.press('?');
    await page.page.locator('#keys-dialog[open]').waitFor();
    await keyboard.press('Escape');
    for (const key of ['1', '5', '7', 'v', 'f', 'Shift+f']) await press(key);
    assert.equal(await page.page.locator('#flat').getAttribute('aria-pressed'), 'true');
  });
});

// Walks through the tour; answers how many steps it has, and how many words.
async function walkThroughTour(page) {
  await page.click('#tour');
  let words = 0;
  let steps = 0;
  while (await page.page.locator('#tour-box').isVisible()) {
    words += (await page.text('#tour-words')).split(/\s+/).length;
    ++steps;
    const [place, box] = await page.page.evaluate(
        () => ['.pointed', '#tour-box'].map(
            (name) => document.querySelector(name).getBoundingClientRect().toJSON()));
    const {width, height} = page.page.viewportSize();
    const beside = place.right <= box.left || place.left >= box.right;
    const lowest = Math.min(place.bottom, beside ? height : box.top);
    assert.ok(lowest - Math.max(place.top, 0) > 100, `step ${steps}: ${place.top} to ${lowest}`);
    assert.ok(Math.min(place.right, width) - Math.max(place.left, 0) > 100, `step ${steps}`);
    assert.ok(box.left >= 0 && box.right <= width && box.bottom <= height, `step ${steps}`);
    await page.page.locator('#tour-next').click();
  }
  assert.equal(await page.page.locator('.pointed').count(), 0);
  return {steps, words};
}

test('the tour takes about a minute, and what it points at is seen', async () => {
  for (const viewport of [{width: 1280, height: 900}, {width: 390, height: 800}]) {
    await inStudio(['mug'], async (page) => {
      const {steps, words} = await walkThroughTour(page);
      // Read at 200 words a minute, with two seconds to find each place.
      const seconds = words / 200 * 60 + 2 * steps;
      assert.ok(seconds > 45 && seconds < 75, `${steps} steps, ${words} words, ${seconds} s`);
    }, {viewport});
  }
});

test('every control has a name for screen readers', async () => {
  await inStudio(['mug'], async (page) => {
    const nameless = await page.page.evaluate(
        () => [...document.querySelectorAll('button, input:not([hidden]), select')]
                  .filter((node) => !node.closest('dialog'))
                  .filter(
                      (node) =>
                          !(node.getAttribute('aria-label') || node.innerText.trim() ||
                            (node.labels && node.labels.length > 0)))
                  .map((node) => node.outerHTML));
    assert.deepEqual(nameless, []);
  });
});

test('a phone shows it all, without scrolling sideways', async () => {
  await inStudio(['mug'], async (page) => {
    const wide = await page.page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(wide <= 0, `${wide} pixels too wide`);
    await page.click('#approach');
    await page.click('#auto-grasp');
    assert.notEqual(await page.text('#contact-count'), '0');
  }, {viewport: {width: 390, height: 844}});
});

test('what fails once, or is asked for before there is a session, blocks nothing', async () => {
  await inStudio(['mug'], async (page) => {
    const found = await page.page.evaluate(async () => {
      const report = window.reportError;
      const reported = [];
      window.reportError = (error) => reported.push(error.message);
      const done = [];
      // The page's scripts are one function, so that its class is reached through an instance.
      const {live, grasp} = window.studio;
      const Coalescer = grasp.judge.constructor;
      const coalescer = new Coalescer(async (name) => {
        if (name === 'bad') throw new Error('not this one');
        done.push(name);
      });
      await Promise.all([coalescer.ask('bad'), coalescer.ask('good')]);
      const {state} = live;
      live.state = null;
      await grasp.judge.ask();
      live.state = state;
      window.reportError = report;
      return {done, reported, busy: coalescer.busy || grasp.judge.busy};
    });
    assert.deepEqual(found, {done: ['good'], reported: ['not this one'], busy: false});
    await page.click('#load-weight');
    assert.notEqual(await page.text('#forces'), '');
  });
});

test('the tape measures, and the picture is one', async () => {
  await inStudio(['mug'], async (page) => {
    await page.click('#tape');
    await page.page.locator('#view').selectOption('front');
    await page.settle();
    // The bottom and the top of the mug's outline, in front of its axis.
    const [bottom, top] = await page.page.evaluate(() => {
      const {stage} = window.studio;
      const box = new window.THREE.Box3().setFromObject(stage.bodies.get('object').group);
      return [[0, 0, 0.1], [0, 0, 0.9]].map(
          ([, , part]) => [0, 0, box.min.z + part * (box.max.z - box.min.z)]);
    });
    for (const point of [bottom, top]) {
      await page.page.mouse.click(...await page.pixelOf(point));
      await page.settle();
    }
    const measured = Number((await page.text('#status')).match(/^([\d.]+) mm$/)[1]);
    const expected = 1000 * (top[2] - bottom[2]);
    // The points on the wall are nearer to the eye than the axis, so the way between them is
    // shorter.
    assert.ok(measured > 0.5 * expected && measured < 1.1 * expected, `${measured}, ${expected}`);
    const [picture] = await Promise.all([
      page.page.waitForEvent('download'),
      page.page.locator('#screenshot').click(),
    ]);
    const file = join(folder, 'picture.png');
    await picture.saveAs(file);
    assert.deepEqual([...readFileSync(file).subarray(1, 4)], [...Buffer.from('PNG')]);
  });
});

test('without the token there is nothing, and Ctrl-C ends the session', async () => {
  const studio = await Studio.start('mug');
  const bare = new URL(studio.address);
  bare.search = '';
  assert.equal((await fetch(bare)).status, 403);
  const page = await anotherTab(studio);
  assert.equal(await studio.stop(), 130);
  await page.page.locator('#connection:not([hidden])').waitFor();
  await page.page.context().close();
});
