// What the scene shows, in the words of its author.

import { element } from './element.js';

/** The words of the page, else those of its first recording. */
export function wordsFor(page, recordings) {
  const header = recordings[0]?.header ?? {};
  return {
    title: page.title || header.title || 'A recording',
    explanation: page.explanation || header.explanation || '',
    lookFor: page.look_for || header.look_for || '',
    row: page.row ?? null,
    links: Array.isArray(page.links) ? page.links : [],
    method: methods(recordings),
  };
}

function methods(recordings) {
  const { integrator, dt } = recordings[0]?.header ?? {};
  if (recordings.length !== 1 || !integrator) return '';
  return dt ? `${integrator}, step ${quotient(dt)} s` : integrator;
}

/** Pages are passed around: a link must lead to a page and not run a script. Without a colon it is a relative one. */
function safe(href) {
  return typeof href === 'string' && (/^https?:/i.test(href) || !href.includes(':'));
}

function paragraphs(text) {
  return text.split(/\n\s*\n/).filter(Boolean).map((part) => element('p', {}, part));
}

export function headline({ title, row }) {
  const eyebrow = row !== null && row !== '' && element('p', { class: 'eyebrow' }, /^\d+$/.test(String(row)) ? `Lecture, row ${row}` : String(row));
  return element('div', { class: 'headline' }, eyebrow, element('h1', {}, title));
}

export function explain({ explanation, lookFor, links, method }) {
  const good = links.filter((link) => safe(link?.href));
  if (!explanation && !lookFor && !good.length && !method) return null;
  const panel = element('section', { class: 'panel explain', 'aria-label': 'Explanation' }, ...paragraphs(explanation));
  if (lookFor) {
    panel.append(element('div', { class: 'look-for' }, element('h2', {}, 'Look for'), ...paragraphs(lookFor)));
  }
  if (method) panel.append(element('p', { class: 'method' }, method));
  if (good.length) {
    const items = good.map(({ href, text }) => element('li', {}, element('a', { href }, text || href)));
    panel.append(element('ul', { class: 'links' }, ...items));
  }
  return panel;
}

// 1/240 reads better than 0.004166666666666667.
function quotient(dt) {
  const per = Math.round(1 / dt);
  return dt < 1 && per < 1e6 && Math.abs(per * dt - 1) < 1e-12 && String(dt).length > 8 ? `1/${per}` : String(dt);
}
