// How the studio draws its scene: light and shadow, what is seen through, and when it draws.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {inStudio} from './in_studio.mjs';

// Until the page has drawn all that it ever will unless something happens, and the number of
// pictures then.
async function atRest(page) {
  await page.settle();
  await page.until(() => window.studio.stage.canvas.dataset.drawn === 'fine');
  return page.page.evaluate(() => window.studio.stage.renderer.info.render.frame);
}

// So many frames of the browser later.
function frames(page, count) {
  return page.page.evaluate(async (n) => {
    for (let k = 0; k < n; ++k) await new Promise((done) => requestAnimationFrame(done));
  }, count);
}

// What the stage shows, as it is drawn at once: kept in the page under a name.
function keepPicture(page, name) {
  return page.page.evaluate((key) => {
    const {stage} = window.studio;
    stage.draw();
    const gl = stage.renderer.getContext();
    const {drawingBufferWidth: width, drawingBufferHeight: height} = gl;
    window[key] = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, window[key]);
  }, name);
}

// How many pixels of the stage change by what `change` does in the page.
async function pixelsChangedBy(page, change) {
  await atRest(page);  // in full resolution
  await keepPicture(page, 'pictureBefore');
  await page.page.evaluate(change);
  await keepPicture(page, 'pictureAfter');
  return page.page.evaluate(() => {
    const {pictureBefore: a, pictureAfter: b} = window;
    let count = 0;
    for (let i = 0; i < a.length; i += 4) {
      if (Math.abs(a[i] - b[i]) > 8) ++count;
    }
    return count;
  });
}

test('nothing is drawn while nothing happens', async () => {
  for (const scene of ['mug', 'shelf']) {
    await inStudio([scene], async (page) => {
      const before = await atRest(page);
      await frames(page, 60);
      assert.equal(await atRest(page), before);
      await page.click('#approach');
      assert.ok(await atRest(page) > before);
    });
  }
});

test(
    'the object and the hand throw shadows, which are made anew only where they move', async () => {
      await inStudio(['mug'], async (page) => {
        await atRest(page);
        const shaded = await pixelsChangedBy(page, () => {
          window.studio.stage.ground.shade.visible = false;
        });
        assert.ok(shaded > 500, `${shaded} pixels are shaded`);
        await page.page.evaluate(() => {
          const {ground} = window.studio.stage;
          const {lightOn} = ground;
          window.lit = 0;
          ground.lightOn = (points) => {
            ++window.lit;
            lightOn.call(ground, points);
          };
        });
        await page.page.keyboard.press('1');
        await page.settle();
        assert.equal(await page.page.evaluate(() => window.lit), 0);
        await page.click('#approach');
        assert.ok(await page.page.evaluate(() => window.lit) > 0);
        // The ground is under the object, and stays there when that is lifted.
        const heights = () => page.page.evaluate(() => {
          const {stage} = window.studio;
          const box = new window.THREE.Box3().setFromObject(stage.bodies.get('object').group);
          return [stage.ground.group.position.z, box.min.z];
        });
        const cell = await page.page.evaluate(() => window.studio.stage.ground.cell);
        assert.equal(await page.text('#grid-size'), `grid: ${Math.round(1000 * cell)} mm`);
        const [ground, bottom] = await heights();
        assert.ok(ground < bottom && ground > bottom - 0.001, `${ground}, ${bottom}`);
        const {position} = (await page.state()).object.X_world_object;
        await page.call('switches.set', {stop_at_contact: false});
        await page.call(
            'object.move',
            {X_world_object: {position: [position[0], position[1], position[2] + 0.1]}});
        await page.settle();
        const [still, lifted] = await heights();
        assert.ok(still === ground && lifted > bottom + 0.09);
      });
    });

test('the ends of the axes turn the camera, and not what it looks at', async () => {
  for (const viewport of [{width: 1400, height: 900}, {width: 400, height: 800}]) {
    await inStudio(['mug'], async (page) => {
      const view = () => page.page.evaluate(() => {
        const {stage} = window.studio;
        const {target} = stage.controls;
        return {
          direction: stage.direction().toArray(),
          target: target.toArray(),
          distance: stage.camera.position.distanceTo(target),
        };
      });
      const {target, distance} = await view();
      const ends = {
        front: [0, -1, 0],
        right: [1, 0, 0],
        above: [0, 0, 1],
        left: [-1, 0, 0],
        back: [0, 1, 0],
      };
      for (const [name, wanted] of Object.entries(ends)) {
        // From aslant, where no end hides another.
        await page.page.keyboard.press('7');
        await page.settle();
        const {x, y, width, height} =
            await page.page.locator(`[data-from="${name}"]`).boundingBox();
        await page.page.mouse.click(x + width / 2, y + height / 2);
        await page.settle();
        const now = await view();
        const apart = Math.hypot(...now.direction.map((d, i) => d - wanted[i]));
        assert.ok(apart < 2e-3, `${name}: ${now.direction}`);
        if (name !== 'front') continue;
        assert.ok(Math.hypot(...now.target.map((t, i) => t - target[i])) < 1e-9);
        assert.ok(Math.abs(now.distance - distance) < 1e-9);
      }
      await page.page.locator('[data-from="above"]').press('Enter');
      await page.settle();
      assert.ok((await view()).direction[2] > 0.999);
    }, {viewport});
  }
});

function opacityOf(page, key) {
  return page.page.evaluate((name) => window.studio.stage.bodies.get(name).opacity, key);
}

test('the object is opaque until somebody wants to see through it', async () => {
  await inStudio(['mug'], async (page) => {
    assert.equal(await opacityOf(page, 'object'), 1);
    await page.click('#approach');
    await page.click('#auto-grasp');
    const slider = page.page.locator('#object-opacity');
    const {x, y, width, height} = await slider.boundingBox();
    await page.drag([x + width - 5, y + height / 2], [x + 0.4 * width, y + height / 2]);
    const opacity = await opacityOf(page, 'object');
    assert.ok(opacity > 0.1 && opacity < 0.8, `${opacity}`);
    const changed = await pixelsChangedBy(page, () => window.studio.stage.setOpacity('object', 1));
    assert.ok(changed > 500, `${changed} pixels`);
    // Marks inside of it are seen all the same.
    const marked = await pixelsChangedBy(page, () => {
      window.studio.stage.marks.visible = false;
    });
    assert.ok(marked > 50, `${marked} pixels`);
    // It is where it was, and still taken hold of.
    const picked = await page.page.evaluate(() => {
      const {stage} = window.studio;
      return stage.bodies.get('object').group.children[0].children[0].userData.body;
    });
    assert.equal(picked, 'object');
  });
});

test('obstacles in the way of sight are seen through, others are not', async () => {
  await inStudio(['mug_on_table'], async (page) => {
    assert.equal(await opacityOf(page, 'obstacle table'), 1);
    await page.page.locator('#view').selectOption('below');
    await page.settle();
    assert.ok(await opacityOf(page, 'obstacle table') < 0.5);
    await page.page.locator('#view').selectOption('above');
    await page.settle();
    assert.equal(await opacityOf(page, 'obstacle table'), 1);
    await page.page.keyboard.press('v');
    await page.page.locator('#view').selectOption('below');
    await page.settle();
    assert.ok(await opacityOf(page, 'obstacle table') < 0.5);
  });
});
