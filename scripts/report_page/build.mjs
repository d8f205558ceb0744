// Makes page.html, which `trunk report` fills: one file with styles, program and licences.

import { createHash } from 'node:crypto';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { build } from 'esbuild';

const { outputFiles } = await build({
  entryPoints: ['src/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2022',
  charset: 'utf8',
  legalComments: 'none', // the licences stand in the page in full
  outdir: 'out',
  write: false,
});
const output = (ending) => outputFiles.find(({ path }) => path.endsWith(ending)).text.trim();
const script = output('.js').replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const style = output('.css');

const hash = createHash('sha256').update(script).digest('base64');
// No origin may be asked for anything, and no script runs but this one.
const policy = `default-src 'none'; script-src 'sha256-${hash}'; style-src 'unsafe-inline'; img-src data: blob:; base-uri 'none'; form-action 'none'`;

const version = (name) => JSON.parse(readFileSync(`node_modules/${name}/package.json`)).version;
const licence = (name) => `${name} ${version(name)}\n\n${readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim()}`;
const licences = ['three', 'uplot'].map(licence).join('\n\n').replaceAll('--', '- -');

// What the page was made of, for a test: as sha256sum lists these files.
const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');
const sources = ['build.mjs', 'package-lock.json', 'package.json', 'page.in.html', ...readdirSync('src').sort().map((f) => `src/${f}`)];
const made = sha256(sources.map((f) => `${sha256(readFileSync(f))}  ${f}\n`).join(''));

const parts = { policy, licences, made, style, script };
const page = readFileSync('page.in.html', 'utf8').replace(/@(policy|licences|made|style|script)@/g, (_, name) => parts[name]);
writeFileSync('page.html', page);
console.log(`page.html: ${(page.length / 1000).toFixed(0)} kB`);
