// node test/shot.mjs PAGE.html OUT.png [width height time [dark]]
//
// Takes a picture of a page and prints what is on it as JSON. Exits with 1 when a view is blank, a plot is empty, the
// console has an error, or the page is wider than the window.

import { pathToFileURL } from 'node:url';
import { resolve } from 'node:path';
import { launch, ready, watchErrors } from './browser.mjs';

const [file, out, width = '1280', height = '800', time, scheme] = process.argv.slice(2);
if (!file || !out) {
  console.error('usage: node test/shot.mjs PAGE.html OUT.png [width height time [dark]]');
  process.exit(2);
}

const browser = await launch();
try {
  const page = await browser.newPage({
    viewport: { width: Number(width), height: Number(height) },
    reducedMotion: 'reduce',
    colorScheme: scheme === 'dark' ? 'dark' : 'light',
  });
  const errors = watchErrors(page);
  await page.goto(pathToFileURL(resolve(file)).href);
  await ready(page);
  const facts = await page.evaluate(look, time === undefined ? null : Number(time));
  await page.screenshot({ path: out, fullPage: true });
  const problems = judge(facts, errors);
  console.log(JSON.stringify({ page: file, picture: out, ...facts, errors, problems }, null, 2));
  process.exitCode = problems.length ? 1 : 0;
} finally {
  await browser.close();
}

/** Runs in the page. Without a time, the middle of the recording: the start is often the dullest moment. */
function look(time) {
  const { polhode } = window;
  if (polhode) polhode.seek(time ?? (polhode.start + polhode.end) / 2);
  const root = document.documentElement;
  return {
    title: document.title,
    time: polhode?.time ?? null,
    recordings: polhode?.recordings ?? [],
    views: polhode?.pixels() ?? [],
    plots: polhode?.plots() ?? [],
    complaints: [...document.querySelectorAll('[role=alert]')].map((node) => node.textContent),
    overflow: Math.max(0, root.scrollWidth - root.clientWidth),
  };
}

function judge({ recordings, views, plots, complaints, overflow }, errors) {
  const problems = [...complaints, ...errors];
  if (!recordings.length) problems.push('no recording is played');
  if (views.length < recordings.length) problems.push('a recording has no view');
  views.forEach(({ variance, bodyPixels }, k) => {
    // The smallest thing drawn, the dot of a far body, has about forty pixels.
    if (variance < 1e-4 || bodyPixels < 20) problems.push(`view ${k + 1} is blank`);
  });
  for (const { title, curves } of plots) {
    if (!curves.some(({ length }) => length > 0)) problems.push(`plot “${title}” is empty`);
  }
  if (overflow > 0) problems.push(`the page is ${overflow} px wider than the window`);
  return problems;
}
