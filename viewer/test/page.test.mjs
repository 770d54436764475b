// The built page in headless Chromium.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { writeFileSync } from 'node:fs';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { page as buildPage } from '../build.mjs';
import { launch, opener } from './browser.mjs';
import * as scenes from './scenes.mjs';
import { pageOf } from './write.mjs';

// A grid alone gives a picture variance of about 1e-3; bodies are judged with all else hidden.
const BLANK = { variance: 1e-4, bodyPixels: 20 };

let browser;
let pages;
before(async () => {
  browser = await launch();
  pages = await opener(browser);
});
after(async () => {
  await browser?.close();
  await pages?.close();
});

async function open(recordings, { words, ...options } = {}) {
  const page = await pages.open(pageOf(recordings, words), options);
  return page;
}

const notBlank = ({ variance, bodyPixels }) => variance > BLANK.variance && bodyPixels > BLANK.bodyPixels;
const picture = (page) => page.locator('.views').screenshot();
const state = (page) => page.evaluate(() => ({ time: polhode.time, playing: polhode.playing, layers: polhode.layers, selected: polhode.selected }));
const frame = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

test('dist/viewer.html is what src/ builds, with one place for recordings', async () => {
  const committed = await readFile(new URL('../dist/viewer.html', import.meta.url), 'utf8');
  assert.ok(committed === (await buildPage()), 'run npm run build and commit dist/viewer.html');
  assert.equal(committed.split('<!-- recordings -->').length, 2);
  assert.ok(committed.indexOf('<!-- recordings -->') < committed.indexOf('<script type="module">'));
});

test('a free body: not blank, plots drawn, seeking moves it, keys work', async () => {
  const page = await open([scenes.racket()], { words: { row: 36, links: [{ href: 'next.html', text: 'Next' }, { href: 'javascript:alert(1)', text: 'No' }] } });
  const [view] = await page.evaluate(() => polhode.pixels());
  assert.ok(notBlank(view), JSON.stringify(view));
  for (const plot of await page.evaluate(() => polhode.plots())) assert.ok(plot.curves[0].length > 100, JSON.stringify(plot));
  assert.deepEqual((await state(page)).layers, ['axes', 'omega', 'momentum', 'grid']);
  assert.equal(await page.locator('.links a').count(), 1);
  assert.match(await page.locator('.inspector').innerText(), /rad\/s/);

  await page.evaluate(() => polhode.seek(0));
  const first = await picture(page);
  await page.evaluate(() => polhode.seek(3));
  assert.notDeepEqual(await picture(page), first);

  const keys = page.keyboard;
  await keys.press('Home');
  await keys.press('ArrowRight');
  await frame(page);
  assert.ok(Math.abs((await state(page)).time - 1 / 30) < 1e-9);
  await keys.press('ArrowLeft');
  await keys.press('Space');
  await frame(page);
  assert.equal((await state(page)).playing, true);
  await page.waitForFunction(() => polhode.time > 0.02);
  await keys.press('Space');
  await frame(page);
  assert.equal((await state(page)).playing, false);
  for (const key of ['o', 'h', 's', 'p']) await keys.press(key);
  await keys.press('a');
  await frame(page);
  const { layers } = await state(page);
  assert.ok(layers.includes('polhode') && layers.includes('herpolhode') && !layers.includes('axes'), layers.join());
  await keys.press('?');
  assert.equal(await page.locator('dialog.help').isVisible(), true);
  await keys.press('Escape');
  assert.equal(await page.locator('dialog.help').isVisible(), false);
  assert.deepEqual(page.errors, []);
  await page.close();
});

test('a drag turns the camera, the wheel zooms, a plot seeks, a button is a switch', async () => {
  const page = await open([scenes.racket()]);
  const before = await picture(page);
  const box = await page.locator('.views').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 + 90, box.y + box.height / 2 + 20);
  await page.mouse.up();
  await frame(page);
  const turned = await picture(page);
  assert.notDeepEqual(turned, before);
  await page.mouse.wheel(0, -300);
  await frame(page);
  assert.notDeepEqual(await picture(page), turned);
  await page.locator('.plot-area').first().click();
  await frame(page);
  const { time } = await state(page);
  assert.ok(time > 4 && time < 8, `a click in the middle of a plot of 12 s went to ${time}`);
  await page.locator('.layer', { hasText: 'Angular velocity' }).click();
  await frame(page);
  assert.ok(!(await state(page)).layers.includes('omega'));
  await page.close();
});

test('it plays by itself in real time, but not for who asked for less motion', async () => {
  const still = await open([scenes.racket()]);
  assert.equal((await state(still)).playing, false);
  await still.close();
  const page = await open([scenes.links()], { reducedMotion: 'no-preference', viewport: { width: 400, height: 500 } });
  assert.equal((await state(page)).playing, true);
  // The page asked for its frame first, so that both see the same clock in each, however few frames there are.
  const ratio = await page.evaluate(async () => {
    const moment = () => new Promise((done) => requestAnimationFrame((now) => done({ now, time: polhode.time })));
    const first = await moment();
    let last = first;
    while (last.now - first.now < 800) last = await moment();
    const span = polhode.end - polhode.start;
    return ((last.time - first.time + span) % span) / ((last.now - first.now) / 1000);
  });
  assert.ok(Math.abs(ratio - 1) < 0.01, `time passes ${ratio} times as fast as it should`);
  await page.close();
});

test('two recordings side by side, at one time, in two colours', async () => {
  const page = await open([scenes.racket({ label: 'explicit Euler', drift: 1e-3 }), scenes.racket({ label: 'pdmv6' })], { viewport: { width: 1100, height: 700 } });
  const views = await page.evaluate(() => polhode.pixels());
  assert.equal(views.length, 2);
  assert.ok(views.every(notBlank), JSON.stringify(views));
  assert.deepEqual(await page.locator('.cell-name').allInnerTexts(), ['explicit Euler', 'pdmv6']);
  const cells = await page.locator('.cell').evaluateAll((all) => all.map((one) => one.getBoundingClientRect().left));
  assert.ok(cells[1] > cells[0] + 100, 'the views are beside each other');
  const strokes = await page.locator('.plot').first().locator('.trace').evaluateAll((all) => all.map((one) => getComputedStyle(one).stroke));
  assert.equal(new Set(strokes).size, 2);
  assert.match(await page.locator('.plot').first().innerText(), /explicit Euler[\s\S]*pdmv6/);
  await page.close();
});

test('nothing is wider than the window at 360 and at 1600 px; views stack on a phone', async () => {
  const page = await open([scenes.racket({ label: 'a' }), scenes.racket({ label: 'b' })], { viewport: { width: 360, height: 640 } });
  for (const width of [360, 1600]) {
    await page.setViewportSize({ width, height: 800 });
    await frame(page);
    const facts = await page.evaluate(() => ({
      over: document.documentElement.scrollWidth - document.documentElement.clientWidth,
      cells: [...document.querySelectorAll('.cell')].map((cell) => ({ left: cell.getBoundingClientRect().left, top: cell.getBoundingClientRect().top })),
      views: polhode.pixels(),
    }));
    assert.ok(facts.over <= 0, `${facts.over} px too wide at ${width}`);
    assert.ok(facts.views.every(notBlank), JSON.stringify(facts.views));
    const stacked = facts.cells[1].top > facts.cells[0].top + 50;
    assert.equal(stacked, width === 360);
  }
  await page.close();
});

test('every shape draws something, in 3D and face on', async () => {
  const page = await open(scenes.SHAPES.filter((shape) => shape.type !== 'half_space').map((shape) => scenes.gallery([shape])), { viewport: { width: 660, height: 400 } });
  const views = await page.evaluate(() => polhode.pixels());
  views.forEach((view, k) => assert.ok(view.bodyShare > 0.01, `${scenes.SHAPES[k].type}: ${JSON.stringify(view)}`));
  assert.deepEqual(page.errors, []);
  await page.close();
  const planar = await open([scenes.gallery(scenes.SHAPES.slice(8, 12), { planar: true })]);
  assert.ok(notBlank((await planar.evaluate(() => polhode.pixels()))[0]));
  await planar.close();
});

test('a half-space is a floor, links are drawn, a planar scene is seen face on', async () => {
  for (const scene of [scenes.gallery(), scenes.links(), scenes.puck(), scenes.projectile()]) {
    const page = await open([scene], { viewport: { width: 400, height: 400 } });
    const [view] = await page.evaluate(() => {
      for (const layer of ['trail', 'frenet', 'parallel', 'velocity', 'torque']) polhode.toggle(layer, true);
      return polhode.pixels();
    });
    assert.ok(notBlank(view), `${await page.title()}: ${JSON.stringify(view)}`);
    assert.deepEqual(page.errors, [], await page.title());
    await page.close();
  }
});

test('a body too small to be seen is a dot', async () => {
  const page = await open([scenes.gallery([{ type: 'sphere', radius: 1e-4 }, { type: 'sphere', radius: 1e-4 }])]);
  const [view] = await page.evaluate(() => polhode.pixels());
  assert.ok(notBlank(view) && view.bodyShare < 0.01, JSON.stringify(view));
  await page.close();
});

test('a click on a body shows its numbers', async () => {
  const page = await open([scenes.gallery([{ type: 'sphere', radius: 0.7 }, { type: 'cuboid', size: [1, 1, 1] }])]);
  const box = await page.locator('.views').boundingBox();
  const hit = new Map();
  for (let u = 0.15; u < 0.9; u += 0.1) {
    await page.mouse.click(box.x + u * box.width, box.y + 0.5 * box.height);
    hit.set((await state(page)).selected, await page.locator('.pick select').first().inputValue());
  }
  assert.deepEqual([...hit.entries()].sort(), [[0, '0'], [1, '1']]);
  await page.close();
});

test('where a Frenet frame does not exist the view says so', async () => {
  const page = await open([scenes.projectile()]);
  assert.equal(await page.locator('.cell-notes').innerText(), '');
  await page.evaluate(() => polhode.seek(1.7));
  assert.match(await page.locator('.cell-notes').innerText(), /undefined here/);
  await page.close();
});

test('channel matrix deforms the body, and the view says how far it has grown', async () => {
  const page = await open([scenes.explicitR({ label: 'explicit R' }), scenes.explicitR({ label: 'kept', kept: true })]);
  await page.evaluate(() => polhode.seek(0));
  const start = await page.evaluate(() => polhode.pixels());
  await page.evaluate(() => polhode.seek(0.7));
  const [grown, kept] = await page.evaluate(() => polhode.pixels());
  assert.ok(grown.bodyShare > 1.2 * kept.bodyShare, JSON.stringify({ start, grown, kept }));
  await page.evaluate(() => polhode.seek(5));
  assert.ok(notBlank((await page.evaluate(() => polhode.pixels()))[0]));
  assert.match(await page.locator('.cell-notes').first().innerText(), /grown ×5\.75/);
  await page.close();
});

test('an empty recording is seen to be empty', async () => {
  const page = await open([scenes.empty()]);
  const [view] = await page.evaluate(() => polhode.pixels());
  assert.equal(notBlank(view), false, JSON.stringify(view));
  assert.equal(view.bodyPixels, 0);
  assert.match(await page.locator('.cell-notes').innerText(), /no bodies/);
  await page.close();
});

test('numbers that end, grow without end or are missing leave the page working', async () => {
  for (const nFrames of [20, 1]) {
    const page = await open([scenes.broken({ nFrames })]);
    for (const t of [0, 5, 15, 19]) {
      await page.evaluate((time) => {
        for (const layer of ['trail', 'polhode', 'herpolhode', 'follow']) polhode.toggle(layer);
        polhode.seek(time);
      }, t);
    }
    if (nFrames > 1) assert.match(await page.locator('.cell-notes').innerText(), /lost: no longer a finite number/);
    assert.match(await page.locator('.plot').nth(1).textContent(), /no finite values/);
    assert.deepEqual(page.errors, []);
    await page.close();
  }
});

test('the screenshot script fails on an empty page and passes a good one', async () => {
  const folder = await mkdtemp(join(tmpdir(), 'polhode-shot-'));
  const shoot = (name, html) => {
    writeFileSync(join(folder, name), html);
    const script = fileURLToPath(new URL('shot.mjs', import.meta.url));
    return new Promise((done) => {
      execFile(process.execPath, [script, join(folder, name), join(folder, `${name}.png`), '480', '500'], (error, out) => done({ code: error?.code ?? 0, facts: JSON.parse(out) }));
    });
  };
  const [bad, good] = await Promise.all([shoot('bad.html', pageOf([scenes.empty()])), shoot('good.html', pageOf([scenes.racket()]))]);
  await rm(folder, { recursive: true });
  assert.equal(bad.code, 1);
  assert.deepEqual(bad.facts.problems, ['view 1 is blank']);
  assert.equal(good.code, 0, JSON.stringify(good.facts.problems));
});

test('what is wrong is said in the page', async () => {
  const good = scenes.links();
  const flipped = Buffer.from(good);
  flipped[flipped.length - 100] ^= 4;
  const says = async (page, pattern) => assert.match(await page.locator('[role=alert]').innerText(), pattern);

  const alone = await open([flipped]);
  await says(alone, /checksum/);
  assert.equal(await alone.locator('.drop').isVisible(), true);
  await alone.close();

  const both = await open([good, good.subarray(0, good.length - 500)]);
  await says(both, /Recording 2: .*cut short/);
  assert.ok(notBlank((await both.evaluate(() => polhode.pixels()))[0]));
  await both.close();

  const text = await pages.open(pageOf([good]).replace(good.toString('base64'), '%%%'));
  await says(text, /base64/);
  await text.close();
});

test('without WebGL the plots and numbers remain, and the page says why', async () => {
  const context = await browser.newContext({ reducedMotion: 'reduce' });
  await context.addInitScript(() => {
    const real = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
      return /webgl/.test(kind) ? null : real.call(this, kind, ...rest);
    };
  });
  const page = await pages.open(pageOf([scenes.racket()]), { context });
  assert.match(await page.locator('.views [role=alert]').innerText(), /no WebGL/);
  assert.ok((await page.evaluate(() => polhode.plots()))[0].curves[0].length > 100);
  await context.close();
});

test('a page without recordings opens files', async () => {
  const page = await pages.open(pageOf([]));
  await page.setInputFiles('input[type=file]', [
    { name: 'a.plh', mimeType: 'application/octet-stream', buffer: scenes.links() },
    { name: 'b.plh', mimeType: 'application/octet-stream', buffer: scenes.puck() },
  ]);
  await page.waitForFunction(() => window.polhode?.ready);
  await frame(page);
  assert.equal((await page.evaluate(() => polhode.pixels())).length, 2);
  await page.close();
});

test('dark and light differ, and change without reloading', async () => {
  const page = await open([scenes.links()]);
  const light = await picture(page);
  await page.emulateMedia({ colorScheme: 'dark' });
  await frame(page);
  assert.notDeepEqual(await picture(page), light);
  assert.deepEqual(page.errors, []);
  await page.close();
});
