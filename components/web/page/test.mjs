// Runs the unit tests, which are beside the code that they test: node test.mjs [PART OF A NAME]. All run in one
// process, because one process per file takes longer to start than the tests take.
import { build } from 'esbuild';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';

const wanted = process.argv[2] ?? '';
const tests = readdirSync('src', { recursive: true }).filter((name) => name.endsWith('.test.ts') && name.includes(wanted));
if (tests.length === 0) {
  console.error(`no unit test has '${wanted}' in its name`);
  process.exit(1);
}
// in this folder, beside which node finds the packages that are not bundled
const folder = mkdtempSync('unit-tests-');
const all = join(folder, 'all.mjs');
await build({
  stdin: { contents: tests.map((name) => `import './${name}';`).join('\n'), resolveDir: 'src' },
  outfile: all,
  bundle: true,
  platform: 'node',
  format: 'esm',
  target: 'node18',
  sourcemap: 'inline',
  packages: 'external',
  preserveSymlinks: true,
  logLevel: 'warning',
});
const { status } = spawnSync(process.execPath, ['--enable-source-maps', all], { stdio: 'inherit' });
rmSync(folder, { recursive: true });
process.exit(status ?? 1);
