// SPDX-License-Identifier: BSD-3-Clause
// Write the licences of every package that viewer.bundle.js holds, after esbuild's list of its inputs.
import { build } from 'esbuild';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';

const result = await build({
  entryPoints: ['viewer.js'], bundle: true, minify: true, target: 'es2020', write: false, metafile: true,
});
const names = new Set(Object.keys(result.metafile.inputs).flatMap((path) => {
  const match = path.match(/.*node_modules\/((?:@[^/]+\/)?[^/]+)\//);
  return match ? [match[0]] : [];
}));
const parts = [...names].sort().map((folder) => {
  const about = JSON.parse(readFileSync(`${folder}package.json`, 'utf8'));
  const file = readdirSync(folder).find((name) => /^(licen[cs]e|copying|copyright)/i.test(name));
  const text = file && existsSync(folder + file) ? readFileSync(folder + file, 'utf8').trim() : '(the package holds no text)';
  return `${about.name} ${about.version}: ${about.license}\n\n${text}\n`;
});
writeFileSync('LICENSES.txt', `What viewer.bundle.js holds beside viewer.js\n\n${parts.join(`\n${'-'.repeat(72)}\n\n`)}`);
