// Builds dist/viewer.html: the template with its style and one script, all inline.

import { readFile, mkdir, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';

const here = new URL('./', import.meta.url);
const MARKER = '<!-- recordings -->';

/** The page as text. The same sources and packages give the same bytes. */
export async function page() {
  const read = (name) => readFile(new URL(name, here), 'utf8');
  const common = { bundle: true, minify: true, write: false, legalComments: 'none', logLevel: 'warning', target: 'es2022' };
  const [script, style] = await Promise.all([
    build({ ...common, entryPoints: [fileURLToPath(new URL('src/main.js', here))], format: 'esm', charset: 'utf8' }),
    build({ ...common, entryPoints: [fileURLToPath(new URL('src/style.css', here))], charset: 'utf8' }),
  ]);
  const [template, licence] = await Promise.all([read('src/index.html'), read('node_modules/three/LICENSE')]);
  // The parser of HTML must not see the end of a script, or a comment, inside the text of one.
  const safe = script.outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  const notices = `<!--\nThis page contains three.js.\n\n${licence.replaceAll('--', '- -').trim()}\n-->`;
  const text = template
    .replace('<!-- notices -->', () => notices)
    .replace('/* style */', () => style.outputFiles[0].text.trim())
    .replace('/* script */', () => safe.trim());
  if (text.split(MARKER).length !== 2) throw new Error(`the page must hold ${MARKER} exactly once`);
  return text;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const text = await page();
  await mkdir(new URL('dist/', here), { recursive: true });
  await writeFile(new URL('dist/viewer.html', here), text);
  console.log(`dist/viewer.html: ${(text.length / 1024).toFixed(0)} KiB`);
}
