// Measures the page in a browser: node bench/page.mjs BUILD... Several builds are measured in turn, so that a busy machine
// affects all of them: the page's compressed size; the time until the first picture; frames drawn while the viewpoint
// moves; and the processor time of the server's thread with one page open. Medians of kRounds.
import { chromium } from 'playwright-core';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readdirSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';

const builds = process.argv.slice(2);
const kWorlds = (process.env.PONGSIM_BENCH_WORLDS ?? '').split(':').filter((world) => world !== '');
const kRounds = Number(process.env.PONGSIM_BENCH_ROUNDS ?? 3);
const kSeconds = 5;
const kPatience = 120_000;

/// Of what a browser loads at first [kB].
function compressedSize(build) {
  const folder = join(build, 'share/pongsim/web');
  const bytes = readdirSync(folder).filter((name) => name.endsWith('.gz')).map((name) => statSync(join(folder, name)).size);
  return bytes.reduce((sum, size) => sum + size, 0) / 1000;
}

async function run(build, world) {
  const home = mkdtempSync(join(tmpdir(), 'pongsim-bench-'));
  const child = spawn(join(build, 'bin/pongsim'), ['run', world, '--web', '0'], {
    stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, HOME: home, PONGSIM_OFFLINE: '1' },
  });
  let said = '';
  const ended = once(child, 'exit');
  const address = await new Promise((resolve, reject) => {
    child.stderr.on('data', (text) => {
      said += text;
      const found = /http:\/\/[^\s]+/.exec(said);
      if (found) resolve(found[0]);
    });
    child.on('exit', (code) => reject(new Error(`${build}/bin/pongsim ended with ${code}: ${said}`)));
  });
  const end = async () => {
    child.kill('SIGINT');
    await ended;
    rmSync(home, { recursive: true });
  };
  return { address, pid: child.pid, end };
}

/// Processor time of the server's thread [s].
function serverSeconds(pid) {
  for (const task of readdirSync(`/proc/${pid}/task`)) {
    const folder = `/proc/${pid}/task/${task}`;
    if (readFileSync(`${folder}/comm`, 'utf8').trim() === 'web') return Number(readFileSync(`${folder}/schedstat`, 'utf8').split(' ')[0]) * 1e-9;
  }
  throw new Error('the server has no thread "web"');
}

/// The animation frames within some time, while the mouse turns the view, per second.
async function orbit(tab) {
  const { x, y, width, height } = await tab.locator('#view canvas').boundingBox();
  const [middleX, middleY] = [x + width / 2, y + height / 2];
  await tab.evaluate((ms) => {
    window.counted = new Promise((resolve) => {
      let frames = 0;
      const begin = performance.now();
      const count = () => {
        ++frames;
        const now = performance.now();
        if (now - begin > ms) resolve((1000 * frames) / (now - begin));
        else requestAnimationFrame(count);
      };
      requestAnimationFrame(count);
    });
  }, 1000 * kSeconds);
  await tab.mouse.move(middleX, middleY);
  await tab.mouse.down({ button: 'middle' });
  let isDone = false;
  const counted = tab.evaluate(() => window.counted).finally(() => (isDone = true));
  for (let i = 0; !isDone; ++i) await tab.mouse.move(middleX + 150 * Math.sin(i / 10), middleY + 10 * Math.cos(i / 10));
  await tab.mouse.up({ button: 'middle' });
  return counted;
}

async function measure(build, world) {
  const server = await run(build, world);
  const browser = await chromium.launch({
    executablePath: process.env.PONGSIM_CHROMIUM, timeout: kPatience,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  try {
    const tab = await browser.newPage({ viewport: { width: 1280, height: 800 } });
    tab.setDefaultTimeout(kPatience);
    const begin = performance.now();
    await tab.goto(server.address);
    // the view draws a new scene in the next frame
    await tab.locator('[role=treeitem][data-id]').first().waitFor();
    await tab.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    const first = (performance.now() - begin) / 1000;
    const [cpuBegin, wallBegin] = [serverSeconds(server.pid), performance.now()];
    const frames = await orbit(tab);
    const share = (serverSeconds(server.pid) - cpuBegin) / ((performance.now() - wallBegin) / 1000);
    return { first, frames, share: 100 * share };
  } finally {
    await browser.close();
    await server.end();
  }
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

for (const build of builds) console.log(`${build}: the page has ${compressedSize(build).toFixed(0)} kB, compressed`);
console.log(`${'world'.padEnd(28)} ${'build'.padEnd(8)} ${'first picture [s]'.padStart(18)} ${'frames/s'.padStart(9)} ${'server [% core]'.padStart(16)}`);
for (const world of kWorlds) {
  const results = builds.map(() => []);
  for (let round = 0; round < kRounds; ++round) {
    for (const [i, build] of builds.entries()) results[i].push(await measure(build, world));
  }
  for (const i of builds.keys()) {
    const of = (name) => median(results[i].map((result) => result[name]));
    const name = builds.length === 1 ? 'this' : i === 0 ? 'this' : 'earlier';
    console.log(`${basename(world).padEnd(28)} ${name.padEnd(8)} ${of('first').toFixed(2).padStart(18)} ${of('frames').toFixed(1).padStart(9)} ${of('share').toFixed(2).padStart(16)}`);
  }
}
