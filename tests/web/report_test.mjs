// What a person meets who opens report.html in a browser.
import assert from 'node:assert/strict';
import {writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {after, before, test} from 'node:test';

import {barriers, launch, OpenReport} from './browser.mjs';
import {changedScene, folder, jsonOf, nastyName, run} from './program.mjs';

// A change of posture or grasp changes at least so many pixels of the scene.
const many = 1500;

let browser;
let planned;  // of the default scene
let grasps;
let tried;  // candidates: 800 of the search, and what the refinement found

before(async () => {
  browser = await launch();
  planned = run('plan', 'mug');
  const result = jsonOf(join(planned, 'grasps.json'));
  grasps = result.grasps;
  tried = candidatesIn(result);
  const refined = result.stages.find(({name}) => name === 'refined');
  assert.equal(tried, 800 + (refined ? refined.count : 0));
});
after(() => browser.close());

function candidatesIn({outcomes}) {
  return Object.values(outcomes).reduce((sum, count) => sum + count, 0);
}

async function expectChanged(report, before, after, least, what = 'the picture') {
  const pixels = await report.difference(before, after);
  assert.ok(pixels > least, `${what} changed by ${pixels} pixels only`);
}

function numberOf(text) {
  return Number(text.match(/[\d.]+/)[0]);
}

async function expectShown(report, number) {
  const grasp = grasps[number - 1];
  await report.shown(number);
  assert.equal(
      await report.page.locator('#contacts tr[data-contact]').count(), grasp.contacts.length);
  const row = await report.text('#contacts tr[data-contact="0"]');
  assert.ok(row.includes(grasp.contacts[0].link), row);
  const shown = numberOf(await report.text('#numbers tr:first-child td:not(.note)'));
  assert.ok(Math.abs(shown - grasp.epsilon) < 1e-4, `${shown} is not ${grasp.epsilon}`);
}

test('the best grasp is there at once, with its contacts and its weakest disturbance', async () => {
  const report = await OpenReport.open(browser, planned);
  await expectShown(report, 1);
  const scene = await report.picture('#scene');
  assert.ok(scene.colors > 500, `${scene.colors} colours`);
  assert.ok(scene.red > 300 && scene.purple > 100, `${scene.red} red, ${scene.purple} purple`);
  const wrench = await report.picture('#wrench');
  assert.ok(wrench.colors > 200, `${wrench.colors} colours`);
  const summary = await report.text('#summary');
  assert.match(summary, /Grasp 1 is best: ε 0\.2\d+ \(/);
  assert.ok(summary.includes(`(${tried} candidates tried)`), summary);
  const origin = await report.text('#numbers tr:has(th:text-is("comes from"))');
  assert.match(origin, /half of the surface there within [\d.]+ mm, 95 % within [\d.]+ mm of it/);
  const layer = report.page.locator('#toggles label:has([data-layer="primitive"])');
  assert.match(await layer.getAttribute('title'), /^[a-z]+ \d+ \(.*\): half of the surface there/);
  assert.match(await report.text('#legend'), /95 % within [\d.]+ mm of the nearest/);
  assert.match(await report.text('.weakest'), /(push of .* N|twist of .* N m).* breaks it/);
  assert.equal(await report.page.locator('#list a').count(), grasps.length);
  const legend = await report.text('#legend');
  for (const word of ['contact', 'weakest', 'centre of mass', 'ε (epsilon)', 'volume', 'units']) {
    assert.ok(legend.includes(word), word);
  }
  await report.close();
});

test('another grasp changes picture and table', async () => {
  const report = await OpenReport.open(browser, planned);
  const first = await report.picture('#scene');
  await report.page.locator('#list a[data-grasp="2"]').click();
  await expectShown(report, 3);
  assert.ok(report.page.url().endsWith('#3'));
  await expectChanged(report, first, await report.picture('#scene'), many);
  await report.page.keyboard.press('ArrowRight');
  await expectShown(report, 4);
  await report.page.keyboard.press('ArrowLeft');
  await expectShown(report, 3);
  await report.page.keyboard.press('ArrowLeft');
  await expectShown(report, 2);
  await report.close();
});

test('an address with a number shows that grasp', async () => {
  const report = await OpenReport.open(browser, planned, {address: '#5'});
  await expectShown(report, 5);
  await report.close();
  const beyond = await OpenReport.open(browser, planned, {address: '#99'});
  await expectShown(beyond, 1);
  await beyond.close();
});

test('what shaking showed is a table of its tests', async () => {
  const shaken = run('plan', 'mug', '--trials', '100', '--top', '2', '--shake', 'dexgraspbench');
  const [grasp] = jsonOf(join(shaken, 'grasps.json')).grasps;
  const report = await OpenReport.open(browser, shaken);
  assert.ok((await report.text('#shaken-words')).includes('dexgraspbench'));
  assert.equal(
      await report.page.locator('#shakes tr[data-outcome]').count(), grasp.shake.tests.length);
  assert.equal(grasp.shake.tests.length, 1 + grasp.shake.of);  // with the preparation
  const row = await report.text('#shakes tr[data-outcome]:nth-child(2)');
  assert.ok(row.startsWith(grasp.shake.tests[0].name), row);
  await report.close();
  const unshaken = await OpenReport.open(browser, planned);
  assert.ok(await unshaken.page.locator('#shaken').isHidden());
  await unshaken.close();
});

test('a simulation plays what happened, with the forces on the object', async () => {
  const simulated = run('simulate', 'wine_glass_on_its_side', '--seconds', '1.2');
  const report = await OpenReport.open(browser, simulated);
  const events = await report.text('#event-list');
  assert.ok(events.includes('the hand grips it from opposite sides'), events);
  assert.ok((await report.text('#summary')).includes('from opposite sides'));
  const held = await report.picture('#scene');
  await report.page.locator('input[data-layer="forces"]').uncheck();
  const bare = await report.picture('#scene');
  await expectChanged(report, held, bare, 50, 'what forces cover');
  await report.close();
});

test('the hand comes and closes', async () => {
  const report = await OpenReport.open(browser, planned);
  const closed = await report.picture('#scene');
  await report.page.locator('#slider').fill('0');
  const away = await report.picture('#scene');
  await expectChanged(report, closed, away, many);
  assert.match(await report.text('#moment'), /^approach, 0\.00 s/);
  await report.page.locator('#slider').fill('950');
  const closing = await report.picture('#scene');
  await expectChanged(report, closed, closing, 100);
  await expectChanged(report, away, closing, many);
  await report.close();
});

// A slow processor draws few and coarse pictures on the way.
for (const slowdown of [1, 8]) {
  test(`playing ends with the grasp, ${slowdown} times slower`, async () => {
    const report = await OpenReport.open(browser, planned, {slowdown});
    const closed = await report.picture('#scene');
    await report.page.getByText('play').click();
    await report.page.locator('#moment', {hasText: /^grasp/}).waitFor();
    await report.page.locator('#playback button', {hasText: '▶ play'}).waitFor();
    assert.ok(await report.difference(closed, await report.picture('#scene')) < 50);
    assert.equal(await report.text('#playback button'), '▶ play');
    await report.close();
  });
}

function secondsOf(moment) {
  return Number(moment.match(/([\d.]+) s of/)[1]);
}

test('playing keeps the time of the motion', async () => {
  const report = await OpenReport.open(browser, planned, {stepped: true});
  const closed = await report.picture('#scene');
  await report.page.getByText('play').click();
  await report.run(20);
  assert.match(await report.text('#moment'), /^approach, 0\.00 s/);
  await report.run(480);
  const half = secondsOf(await report.text('#moment'));
  assert.ok(half > 0.45 && half <= 0.5, `${half} s after half a second`);
  await report.page.getByText('pause').click();
  await report.run(480);
  assert.equal(secondsOf(await report.text('#moment')), half);
  await expectChanged(report, closed, await report.picture('#scene'), many);
  await report.page.getByText('play').click();
  await report.run(60000);
  assert.match(await report.text('#moment'), /^grasp/);
  assert.ok(await report.difference(closed, await report.picture('#scene')) < 50);
  await report.close();
});

test('pictures are coarse while frames take long, and fine at rest', async () => {
  const report = await OpenReport.open(browser, planned, {stepped: true});
  const fine = await report.picture('#scene');
  for (const moment of ['100', '500', '1000']) {
    await report.page.locator('#slider').fill(moment);
    await report.leap(200);
  }
  await report.drawn('coarse');
  await report.run(1000);
  await report.drawn('fine');
  assert.ok(await report.difference(fine, await report.picture('#scene')) < 50);
  await report.close();
});

test('the arm moves along its path', async () => {
  const out = run('plan', 'mug_on_table', '--path', '--top', '1');
  const report = await OpenReport.open(browser, out);
  await report.page.getByText('fit everything').click();
  const end = await report.picture('#scene');
  await report.page.locator('#slider').fill('200');
  assert.match(await report.text('#moment'), /^(preshape|transfer|approach), /);
  await expectChanged(report, end, await report.picture('#scene'), 300);
  // And on with the object in the hand.
  await report.page.locator('#slider').fill('900');
  assert.match(await report.text('#moment'), /^(lift|retreat), /);
  await expectChanged(report, end, await report.picture('#scene'), 300);
  const blockers = await report.text('#blockers');
  assert.ok(blockers.includes('table'), blockers);
  await report.close();
});

test('pointing at a contact lights it up and shows what it exerts', async () => {
  const report = await OpenReport.open(browser, planned);
  const scene = await report.picture('#scene');
  const wrench = await report.picture('#wrench');
  await report.page.locator('#contacts tr[data-contact="0"]').dispatchEvent('pointerenter');
  await expectChanged(report, wrench, await report.picture('#wrench'), 200);
  await expectChanged(report, scene, await report.picture('#scene'), 20);
  await report.close();
});

test('the scene and the wrench space turn together', async () => {
  const report = await OpenReport.open(browser, planned);
  const scene = await report.picture('#scene');
  const wrench = await report.picture('#wrench');
  await report.page.locator('#scene').scrollIntoViewIfNeeded();
  const box = await report.page.locator('#scene').boundingBox();
  await report.page.mouse.move(box.x + 30, box.y + 30);
  await report.page.mouse.down();
  await report.page.mouse.move(box.x + 230, box.y + 60, {steps: 4});
  await report.page.mouse.up();
  await expectChanged(report, scene, await report.picture('#scene'), many);
  await expectChanged(report, wrench, await report.picture('#wrench'), 200);
  await report.close();
});

test('layers come and go, and candidates are chosen by how they ended', async () => {
  const report = await OpenReport.open(browser, planned);
  const scene = await report.picture('#scene');
  for (const layer of ['hand', 'contacts', 'primitive', 'frames']) {
    await report.page.locator(`[data-layer="${layer}"]`).click();
    await expectChanged(report, scene, await report.picture('#scene'), 200, layer);
    await report.page.locator(`[data-layer="${layer}"]`).click();
  }
  await report.page.locator('[data-layer="candidates"]').click();
  const rejected = await report.picture('#scene');
  await expectChanged(report, scene, rejected, 200);
  await report.page.locator('[data-outcome="stable"]').click();
  await expectChanged(report, rejected, await report.picture('#scene'), 200);
  await report.close();
});

test('small pictures are drawn when they come into sight', async () => {
  const report = await OpenReport.open(browser, planned);
  const picture = report.page.locator('#list canvas').last();
  await picture.scrollIntoViewIfNeeded();
  await report.page.locator('#list li:last-child canvas[data-drawn="fine"]').waitFor();
  const colors = await picture.evaluate((canvas) => {
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return new Set(new Uint32Array(data.buffer)).size;
  });
  assert.ok(colors > 50, `${colors} colours`);
  await expectShown(report, 1);
  await report.close();
});

test('nobody is kept out who does not see well or has no mouse', async () => {
  const shaken = run('plan', 'mug', '--trials', '40', '--top', '2', '--shake', 'acronym');
  for (const out of [planned, shaken]) {
    const report = await OpenReport.open(browser, out);
    for (const colorScheme of ['light', 'dark']) {
      await report.page.emulateMedia({colorScheme});
      assert.deepEqual(await barriers(report.page), []);
    }
    await report.close();
  }
});

test('a phone has room for it', async () => {
  const report = await OpenReport.open(browser, planned, {viewport: {width: 360, height: 740}});
  const width = await report.page.evaluate(() => document.scrollingElement.scrollWidth);
  assert.ok(width <= 360, `${width} pixels wide`);
  const scene = await report.picture('#scene');
  assert.ok(scene.colors > 300 && scene.red > 50);
  await report.page.locator('#list a[data-grasp="1"]').click();
  await expectShown(report, 2);
  await report.close();
});

// Walls close around the object.
function crateAround(lower, upper) {
  const thick = 0.006;
  const walls = [];
  for (let axis = 0; axis < 3; ++axis) {
    for (const end of [lower, upper]) {
      const size = upper.map((x, i) => x - lower[i] + 2 * thick);
      const translate = upper.map((x, i) => (x + lower[i]) / 2);
      size[axis] = thick;
      translate[axis] = end[axis] + (end === upper ? thick : -thick) / 2;
      walls.push({shape: 'box', size, pose: [{translate}]});
    }
  }
  return walls;
}

test('a plan without a grasp shows why, and names stay text', async () => {
  const scene = changedScene('mug', (changed) => {
    changed.object.name = '</script>' + nastyName;
    const geometry = crateAround([-0.06, -0.06, -0.008], [0.1, 0.06, 0.113]);
    changed.obstacles = [{name: '<img src=x onerror=alert(2)>', material: 'wood', geometry}];
  });
  const out = run('plan', scene);
  const report = await OpenReport.open(browser, out);
  assert.equal(await report.text('#title'), `</script>${nastyName}, barrett`);
  const all = candidatesIn(jsonOf(join(out, 'grasps.json')));
  assert.ok(all >= 800, `${all} candidates`);
  const summary = await report.text('#summary');
  assert.ok(summary.startsWith(`${all} candidates were tried and none holds`), summary);
  assert.ok((await report.text('#blockers')).includes('<img src=x onerror=alert(2)>'));
  const advice = await report.text('#advice');
  assert.ok(advice.includes('the obstacle <img src=x onerror=alert(2)> is in the way'), advice);
  assert.equal(await report.page.locator('#grasp').isVisible(), false);
  const arrows = await report.picture('#scene');
  assert.ok(arrows.colors > 300);
  await report.page.locator('[data-layer="candidates"]').click();
  await expectChanged(report, arrows, await report.picture('#scene'), 200);
  await report.close();
});

test('contacts alone', async () => {
  const file = join(folder, 'contacts.json');
  const ring = [0, 1, 2].map((k) => [Math.cos(2.1 * k), Math.sin(2.1 * k), 0]);
  const contacts = ring.map((p) => ({
                              position: p.map((x) => 0.04 * x),
                              normal: p.map((x) => -x),
                              friction: 0.6,
                              model: 'soft_finger',
                              torsion: 0.004,
                            }));
  writeFileSync(file, JSON.stringify({contacts, torque_scale: 25}));
  for (const words of [[], ['--space', 'Linf'], ['--cone', 'exact']]) {
    const report = await OpenReport.open(browser, run('quality', file, ...words));
    assert.match(await report.text('#verdict'), /force closure/);
    assert.ok((await report.picture('#scene')).red > 300);
    assert.ok((await report.picture('#wrench')).colors > 200);
    await report.close();
  }
});

test('no contacts at all', async () => {
  const file = join(folder, 'none.json');
  writeFileSync(file, JSON.stringify({contacts: []}));
  const report = await OpenReport.open(browser, run('quality', file));
  assert.match(await report.text('#summary'), /do not hold/);
  await report.close();
});

test('hundreds of grasps are listed, and the first are explained', async () => {
  const asked = jsonOf(join(planned, 'grasps.json'));
  const file = join(folder, 'many.json');
  asked.grasps = new Array(200).fill(grasps[1]);
  writeFileSync(file, JSON.stringify(asked));
  const out = run('evaluate', file);
  const report = await OpenReport.open(browser, out, {address: '#200'});
  await report.shown(200);
  assert.match(await report.text('#wrench-note'), /first grasps only/);
  await report.close();
});

test('without three dimensions the numbers are still there', async () => {
  const flat = await launch('--disable-3d-apis');
  try {
    const report = await OpenReport.open(flat, planned);
    await expectShown(report, 1);
    assert.match(await report.text('#stage'), /cannot draw in three dimensions/);
    report.complaints = report.complaints.filter((text) => !text.includes('WebGL'));
    await report.close();
  } finally {
    await flat.close();
  }
});
