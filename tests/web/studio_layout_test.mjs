// How the studio's page is laid out whatever happens in it, and what it forgets with a scene.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {barriers} from './browser.mjs';
import {inStudio} from './in_studio.mjs';

// Where the object's corners are on the stage, -1 to 1 from edge to edge, and how much of it they
// take up.
function viewOfObject() {
  const {stage} = window.studio;
  stage.camera.updateMatrixWorld();
  const box = new window.THREE.Box3().setFromObject(stage.bodies.get('object').group);
  const corners = [...Array(8).keys()].map(
      (k) => new window.THREE
                 .Vector3(
                     k & 1 ? box.max.x : box.min.x, k & 2 ? box.max.y : box.min.y,
                     k & 4 ? box.max.z : box.min.z)
                 .project(stage.camera));
  const reach = Math.max(...corners.flatMap(({x, y}) => [Math.abs(x), Math.abs(y)]));
  const tall = Math.max(...corners.map(({y}) => y)) - Math.min(...corners.map(({y}) => y));
  return {reach, tall};
}

async function expectFitted(page) {
  const {reach, tall} = await page.page.evaluate(viewOfObject);
  assert.ok(reach < 1 && tall > 0.15, `reaches to ${reach}, is ${tall} tall`);
}

test('another scene is looked at as a whole, and nothing of the earlier one stays', async () => {
  await inStudio(['mug'], async (page) => {
    await expectFitted(page);
    await page.page.evaluate(() => window.studio.handling.select('hand', 'proximal_1'));
    await page.settle();
    await page.click('#load-weight');
    assert.notEqual(await page.page.locator('#load-z').inputValue(), '0');
    for (const scene of ['panda_on_table', 'mug', 'living_room', 'wine_glass_on_its_side']) {
      await page.page.locator('#library').selectOption(scene);
      await page.until((name) => window.studio.live.state.scene === name, scene);
      await page.settle();
      await expectFitted(page);
      assert.equal(await page.text('#selected'), 'nothing');
      assert.equal(
          await page.page.evaluate(() => window.studio.handling.handles.handles.length), 0);
      assert.equal(await page.page.locator('#load-z').inputValue(), '0');
      await page.page.locator('#bodies [data-body="hand"] .body').click();
    }
    await page.click('#time-step');
    assert.ok(!await page.page.locator('#status').evaluate((node) => node.matches('.wrong')));
    await page.click('#time-stop');
    // The same scene opened again, after the camera has gone elsewhere.
    await page.page.evaluate(() => {
      const {stage} = window.studio;
      stage.controls.target.x += 5;
      stage.camera.position.x += 5;
      stage.controls.update();
    });
    await page.page.locator('#library').selectOption('wine_glass_on_its_side');
    await page.settle();
    await expectFitted(page);
  });
});

test('nobody is kept out who does not see well or has no mouse', async () => {
  await inStudio(['mug'], async (page) => {
    const inBothColors = async () => {
      for (const colorScheme of ['light', 'dark']) {
        await page.page.emulateMedia({colorScheme});
        assert.deepEqual(await barriers(page.page), []);
      }
    };
    await inBothColors();
    await page.click('#auto-grasp');
    await inBothColors();
    await page.page.locator('#library').selectOption('panda_on_table');
    await page.until(() => window.studio.live.state.scene === 'panda_on_table');
    await page.settle();
    await inBothColors();
  });
});

test('handles go with the robot whose joints they turn', async () => {
  await inStudio(['mug'], async (page) => {
    await page.page.evaluate(() => window.studio.handling.select('hand', 'proximal_1'));
    await page.settle();
    await page.page.locator('#hand').selectOption('parallel_jaw');
    await page.until(() => window.studio.live.state.hand.name === 'parallel_jaw');
    await page.settle();
    assert.equal(await page.text('#selected'), 'hand');
    assert.equal(await page.page.evaluate(() => window.studio.handling.handles.handles.length), 0);
  });
});

// What is wrong with the layout of the page, in words.
function faultsOfLayout() {
  const faults = [];
  const root = document.documentElement;
  if (root.scrollWidth > root.clientWidth || root.scrollHeight > root.clientHeight) {
    faults.push(`the page is ${root.scrollWidth} x ${root.scrollHeight}`);
  }
  for (const column of document.querySelectorAll('.column')) {
    const box = column.getBoundingClientRect();
    if (box.bottom > window.innerHeight || box.right > window.innerWidth) faults.push(column.id);
    const panels = [...column.children].map((panel) => panel.getBoundingClientRect());
    panels.slice(1).forEach((panel, i) => {
      const gap = panel.top - panels[i].bottom;
      if (Math.abs(gap - 8) > 1) faults.push(`a gap of ${gap} in ${column.id}`);
    });
    // What is below is reached.
    column.scrollTop = column.scrollHeight;
    const last = column.lastElementChild.getBoundingClientRect();
    if (last.bottom > box.bottom + 1) faults.push(`the end of ${column.id} is not reached`);
    column.scrollTop = 0;
  }
  for (const field of document.querySelectorAll('main input[type="number"]')) {
    if (field.scrollWidth > field.clientWidth + 1) {
      faults.push(`${field.getAttribute('aria-label') || field.id} is cut: ${field.value}`);
    }
  }
  for (const id of ['contacts', 'results']) {
    const table = document.getElementById(id);
    if (table.offsetWidth > table.parentElement.clientWidth) faults.push(`${id} are cut`);
  }
  const bar = document.getElementById('state-bar').getBoundingClientRect();
  if (bar.width === 0 || bar.right > window.innerWidth) faults.push('the bar is cut');
  return faults.concat(brokenWords());

  // Words that stand on two lines. Names may break after an underscore.
  function brokenWords() {
    const broken = [];
    const texts = document.createTreeWalker(document.querySelector('main'), NodeFilter.SHOW_TEXT);
    for (let text = texts.nextNode(); text; text = texts.nextNode()) {
      for (const {0: word, index} of text.data.matchAll(/\S+/g)) {
        const range = document.createRange();
        range.setStart(text, index);
        range.setEnd(text, index + word.length);
        const lines = new Set([...range.getClientRects()].map(({top}) => Math.round(top)));
        if (lines.size > 1 && word.length < 30) broken.push(`broken: ${word}`);
      }
    }
    return broken;
  }
}

function boxOf(page, selector) {
  return page.page.locator(selector).boundingBox();
}

test('panels push neither each other nor the stage, and words and numbers are whole', async () => {
  for (const scene of ['panda_on_table', 'mug']) {
    await inStudio([scene], async (page) => {
      const stage = await boxOf(page, '#stage');
      assert.deepEqual(await page.page.evaluate(faultsOfLayout), []);
      await page.page.locator('#plan-trials').fill('60');
      if (scene !== 'mug') await page.page.locator('#plan-paths').check();
      await page.page.locator('#plan').click();
      await page.until(() => {
        const {results, planning} = window.studio.live.state;
        return results > 0 && !planning;
      });
      await page.settle();
      await page.click('#results button[data-grasp="0"]');
      await page.click('#load-weight');
      await page.click('#pin');
      await page.click('#time-step');
      await page.page.locator('#section-fixed').selectOption('fx,fy,tz');
      await page.settle();
      assert.notEqual(await page.text('#contact-count'), '0');
      assert.deepEqual(await page.page.evaluate(faultsOfLayout), []);
      assert.deepEqual(await boxOf(page, '#stage'), stage);
      await page.click('#time-stop');
    }, {viewport: {width: 1280, height: 900}});
  }
});

test('the picture of what is put aside suits a dark page', async () => {
  await inStudio(['mug'], async (page) => {
    await page.click('#pin');
    const [corner, middle] = await page.page.evaluate(() => {
      const canvas = document.querySelector('#pins canvas');
      const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      const alphas = [...data].filter((_, i) => i % 4 === 3);
      return [alphas[0], Math.max(...alphas)];
    });
    assert.deepEqual([corner, middle], [0, 255]);
  });
});

// Presses buttons, boxes and choices one after the other, by a fixed row of numbers.
async function clickBlindly(count) {
  let number = 12345;
  const next = (size) => {
    number = (1103515245 * number + 12345) % 2147483648;
    return Math.floor(number / 65536) % size;
  };
  for (let k = 0; k < count; ++k) {
    const dialog = document.querySelector('dialog[open]');
    const all = [...(dialog || document).querySelectorAll('button, input, select')].filter(
        (node) => node.type !== 'file' && (dialog || !node.closest('dialog')));
    const node = all[next(all.length)];
    if (node.localName === 'select') {
      node.selectedIndex = next(Math.max(node.options.length, 1));
      node.dispatchEvent(new Event('change'));
    } else if (node.type === 'number' || node.type === 'range') {
      node.value = String(next(20));
      node.dispatchEvent(new Event('input'));
      node.dispatchEvent(new Event('change'));
    } else if (node.id !== 'screenshot' && node.id !== 'save' && node.id !== 'load') {
      node.click();
    }
    if (k % 4 === 0) await window.studio.live.connection.call('state');
  }
}

test('whatever is pressed, also what is hidden, no script fails', async () => {
  await inStudio(['panda_on_table'], async (page) => {
    for (const id of ['path-play', 'path-time']) {
      await page.page.evaluate((name) => {
        const node = document.getElementById(name);
        node.click();
        node.dispatchEvent(new Event('input'));
      }, id);
    }
    await page.page.evaluate(clickBlindly, 250);
    await page.call('plan.cancel').catch(() => {});
    await page.page.evaluate(() => document.querySelectorAll('dialog').forEach((d) => d.close()));
    await page.until(() => {
      const {planning, finding_path} = window.studio.live.state;
      return !planning && !finding_path;
    });
  });
});

// Epsilon as the panel has it.
function shownEpsilon(page) {
  return page.page.locator('#epsilon').getAttribute('data-lower').then(Number);
}

test('friction, edges, norm and section are changed while one looks, and undone', async () => {
  await inStudio(['mug'], async (page) => {
    await page.click('#approach');
    await page.click('#auto-grasp');
    const before = await shownEpsilon(page);
    assert.ok(before > 0);
    const change = async (selector, value) => {
      const field = page.page.locator(selector);
      if (await field.evaluate((node) => node.localName === 'select')) {
        await field.selectOption(value);
      } else {
        await field.fill(value);
        await field.press('Enter');
      }
      await page.settle();
    };
    await change('#frictions input >> nth=0', '0.1');
    assert.ok(await shownEpsilon(page) < before);
    await page.click('#undo');
    assert.equal(await shownEpsilon(page), before);
    await change('#judge-norm', 'linf');
    assert.ok(await shownEpsilon(page) > 2 * before);
    await page.click('#undo');
    await change('#judge-edges', '16');
    assert.ok(await shownEpsilon(page) > before);
    await page.click('#undo');
    await change('#section-fixed', 'tx,ty,tz');
    assert.equal(await page.page.locator('#wrench-words span').count(), 3);
    assert.equal(await page.page.locator('#wrench-words span').nth(2).innerText(), 'fx, fy, fz');
    await change('#section-value-2', '0.05');
    assert.deepEqual((await page.state()).judge.fixed, {tx: 0, ty: 0, tz: 0.05});
    await page.click('#undo');
    await page.click('#undo');
    assert.equal(await page.page.locator('#wrench-words span').count(), 2);
    assert.equal(await shownEpsilon(page), before);
  });
});
