// Sessions that tests open in one browser.
import {after, before} from 'node:test';

import {launch} from './browser.mjs';
import {Studio} from './studio.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

export function anotherTab(studio) {
  return studio.open(browser);
}

// Opens a page of a session of its own; `work` gets page and session.
export async function inStudio(words, work, options) {
  const studio = await Studio.start(...words);
  try {
    const page = await studio.open(browser, options);
    await work(page, studio);
    await page.close();
  } finally {
    await studio.stop();
  }
}

export function sceneBytes(page) {
  return page.call('scene.text').then(({text}) => text);
}
