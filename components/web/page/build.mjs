// Builds the page from its sources: node build.mjs FOLDER MESSAGE_TYPES. Output: one script, one style sheet, the
// descriptors of all message types, and a gzip-compressed copy of each.
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
  // gzipSync writes no time into the header: the same sources give the same bytes
  writeFileSync(join(target, `${file}.gz`), gzipSync(readFileSync(join(target, file)), { level: 9 }));
}

/// The text of licences.txt: the packages in the bundle, each with its licence.
function licences(files) {
  const names = files.map((file) => /(?:^|\/)node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1]).filter(Boolean);
  return [...new Set(names)].sort().map((name) => {
    const folder = join('node_modules', name);
    const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
    return `${name} ${version}: ${license}\n${file ? `\n${readFileSync(join(folder, file), 'utf8')}` : ''}`;
  }).join(`\n${'-'.repeat(80)}\n\n`);
}
