// One headless Chromium for all tests of a file, and how a finished page is recognised.

import { writeFile, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { chromium } from 'playwright-core';

const FLAGS = [
  '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync',
];

export function launch() {
  return chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: FLAGS });
}

/** Collects what a reader of the console would call an error. */
export function watchErrors(page) {
  const errors = [];
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) errors.push(`asked the network for ${request.url()}`);
  });
  return errors;
}

export async function ready(page) {
  await page.waitForFunction(() => document.documentElement.dataset.ready === '1', null, { timeout: 30_000 });
}

/** Opens pages from a folder that is removed by `close`. */
export async function opener(browser) {
  const folder = await mkdtemp(join(tmpdir(), 'polhode-viewer-'));
  let count = 0;
  return {
    async open(html, { context, ...options } = {}) {
      const file = join(folder, `${count++}.html`);
      await writeFile(file, html);
      const page = await (context ?? browser).newPage(context ? {} : { viewport: { width: 420, height: 560 }, reducedMotion: 'reduce', ...options });
      page.setDefaultTimeout(20_000);
      page.errors = watchErrors(page);
      await page.goto(pathToFileURL(file).href);
      await ready(page);
      return page;
    },
    close: () => rm(folder, { recursive: true }),
  };
}
