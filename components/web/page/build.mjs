// Makes the page of its sources: node build.mjs FOLDER MESSAGE_TYPES. One script, one style sheet, the description of all
// message types, and each of them compressed beside it.
import { build } from 'esbuild';
import { copyFileSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

const [target, messageTypes] = process.argv.slice(2);
if (!messageTypes) throw new Error('usage: build.mjs FOLDER MESSAGE_TYPES');
mkdirSync(target, { recursive: true });
const { metafile } = await build({
  entryPoints: { page: 'src/app/main.ts', style: 'src/app/style.css' },
  outdir: target,
  bundle: true,
  minify: true,
  format: 'esm',
  target: ['chrome110', 'firefox115', 'safari16.4'],
  legalComments: 'none',
  preserveSymlinks: true,
  logLevel: 'warning',
  metafile: true,
});
writeFileSync(join(target, 'licences.txt'), licences(Object.keys(metafile.inputs)));
for (const file of readdirSync('static')) copyFileSync(join('static', file), join(target, file));
copyFileSync(messageTypes, join(target, 'message_types.bin'));
for (const file of readdirSync(target).filter((name) => /\.(js|css|bin|svg|html)$/.test(name))) {
  // its head holds no time: the same sources are the same bytes
  writeFileSync(join(target, `${file}.gz`), gzipSync(readFileSync(join(target, file)), { level: 9 }));
}

/// The packages that are in the page, with the terms of each.
function licences(files) {
  const names = files.map((file) => /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1]).filter(Boolean);
  return [...new Set(names)].sort().map((name) => {
    const folder = join('node_modules', name);
    const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
    return `${name} ${version}: ${license}\n${file ? `\n${readFileSync(join(folder, file), 'utf8')}` : ''}`;
  }).join(`\n${'-'.repeat(80)}\n\n`);
}
