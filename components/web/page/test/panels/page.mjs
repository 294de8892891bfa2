// Runs pongsim, and its page in a browser, for tests.
import { chromium } from 'playwright-core';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, realpathSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

// node sees this file by a link in the build tree, so the link is resolved
export const repository = fileURLToPath(new URL('../../../../../', pathToFileURL(realpathSync(fileURLToPath(import.meta.url)))));
const program = process.env.PONGSIM;

/// Time limit for anything to happen, even on a busy machine [ms].
export const patience = 60_000;

/// Runs a world with the page.
/// @return Its address, and a function that ends it.
async function run(world, options, environment) {
  const home = mkdtempSync(join(tmpdir(), 'pongsim-page-'));
  const child = spawn(program, ['run', world, '--web', '0', ...options], {
    stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, HOME: home, PONGSIM_OFFLINE: '1', ...environment },
  });
  let said = '';
  const ended = once(child, 'exit');
  const address = await new Promise((resolve, reject) => {
    const hear = (text) => {
      said += text;
      const found = /http:\/\/[^\s]+/.exec(said);
      if (found) resolve(found[0]);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.on('exit', (code) => reject(new Error(`pongsim ended with ${code}: ${said}`)));
  });
  let isEnded = false;
  const end = async () => {
    if (isEnded) return;
    isEnded = true;
    child.kill('SIGINT');
    await ended;
    rmSync(home, { recursive: true });
  };
  return { address, end };
}

/// Opens the page of a world, and waits until it shows the world.
/// @param options Further options of `pongsim run`.
/// @param flags Further options of the browser.
/// @param environment Further variables of `pongsim run`.
/// @param first What is waited for.
export async function openPage(world, {
  options = ['--paused'], flags = [], viewport = { width: 1280, height: 800 }, environment = {}, first = '.panel', hasTouch = false,
} = {}) {
  const simulator = await run(world, options, environment);
  const browser = await chromium.launch({
    executablePath: process.env.PONGSIM_CHROMIUM,
    timeout: 2 * patience,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...flags],
  });
  const context = await browser.newContext({ viewport, colorScheme: 'dark', acceptDownloads: true, hasTouch });
  const tab = await context.newPage();
  tab.setDefaultTimeout(patience);
  const errors = [];
  tab.on('pageerror', (error) => errors.push(error.stack ?? String(error)));
  tab.on('console', (line) => {
    if (line.type() === 'error') errors.push(line.text());
  });
  await tab.goto(simulator.address);
  await tab.locator(first).first().waitFor();
  const close = async () => {
    await browser.close();
    await simulator.end();
  };
  return { tab, errors, close, endServer: simulator.end, address: simulator.address };
}

/// Opens a further panel from the menu.
export async function openPanel(tab, title) {
  await tab.locator('summary', { hasText: 'Panels' }).click();
  await tab.locator('.menu .items button', { hasText: new RegExp(`^${title}$`) }).click();
  return panel(tab, title);
}

export function panel(tab, title) {
  return tab.locator('section.panel', { has: tab.locator('h2', { hasText: new RegExp(`^${title}$`) }) });
}

/// Selects an entity by its name in the tree.
export async function choose(tab, name) {
  const tree = panel(tab, 'Entity tree');
  await tree.getByRole('treeitem', { name: new RegExp(`^${name} \\w+$`) }).locator('> .row .name').click();
}

/// The position [m] and angles [rad] of the selected entity in the inspector.
export async function shownPose(tab) {
  const text = await tab.locator('#inspector-pose').getAttribute('title');
  return text.split(' ').map((number) => Number(Number(number).toFixed(9)));
}

/// Waits until `holds` is true for the result of `look`.
/// @return That result.
export async function until(look, holds, what) {
  const end = Date.now() + patience;
  for (;;) {
    const found = await look();
    if (holds(found)) return found;
    if (Date.now() > end) throw new Error(`${what}: the last was ${JSON.stringify(found)}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

/// Runs pongsim until it ends.
/// @return Its standard output.
export function pongsim(...words) {
  const { stdout, stderr, status } = spawnSync(program, words, { encoding: 'utf8', timeout: patience });
  if (status !== 0) throw new Error(`pongsim ${words.join(' ')}: ${stderr}`);
  return stdout;
}
