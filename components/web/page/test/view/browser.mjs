// Runs the view alone in a browser: serves a page with it and the tests' files, with the real page's security headers.
import { build } from 'esbuild';
import { chromium } from 'playwright-core';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join, normalize } from 'node:path';

const here = 'test/view';
const rules = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src 'self'";
const page = '<!doctype html><title>view</title><link rel="icon" href="icon.svg"><link rel="stylesheet" href="style.css">'
  + '<div id="view"></div><script type="module" src="harness.js"></script>';
const style = 'html, body { margin: 0; height: 100% } #view { width: 100%; height: 100% }';

/// The path of the machine's browser; undefined if there is none.
export function browserPath() {
  const places = ['chromium', 'chromium-browser', 'google-chrome'].map((name) => `/usr/bin/${name}`);
  return [process.env.PONGSIM_CHROMIUM, ...places].find((path) => path && existsSync(path));
}

async function serve() {
  const made = await build({
    entryPoints: [`${here}/harness.ts`],
    bundle: true,
    format: 'esm',
    write: false,
    preserveSymlinks: true,
    logLevel: 'warning',
  });
  const answers = {
    '/': ['text/html', page],
    '/style.css': ['text/css', style],
    '/icon.svg': ['image/svg+xml', '<svg xmlns="http://www.w3.org/2000/svg"/>'],
    '/harness.js': ['text/javascript', made.outputFiles[0].contents],
  };
  const server = createServer((request, response) => {
    const [type, body] = answers[request.url] ?? file(request.url);
    response.statusCode = body === null ? 404 : 200;
    response.setHeader('content-type', type);
    response.setHeader('content-security-policy', rules);
    response.end(body ?? 'not there');
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return server;
}

function file(url) {
  const path = join(here, normalize(url));
  return ['application/octet-stream', existsSync(path) ? readFileSync(path) : null];
}

/// Opens the view. Errors of the page are collected in `errors`.
/// @param flags Further options of the browser.
export async function openView(flags = []) {
  const server = await serve();
  const browser = await chromium.launch({
    executablePath: browserPath(),
    timeout: 120_000,
    args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', ...flags],
  });
  const tab = await browser.newPage({ viewport: { width: 320, height: 240 } });
  tab.setDefaultTimeout(60_000);
  const errors = [];
  tab.on('pageerror', (error) => errors.push(error.stack ?? String(error)));
  tab.on('console', (line) => {
    if (line.type() === 'error') errors.push(line.text());
  });
  await tab.goto(`http://127.0.0.1:${server.address().port}/`);
  const close = async () => {
    await browser.close();
    server.close();
  };
  return { tab, errors, close };
}

/// Shows a scene from a viewpoint, and waits until it has been drawn.
export async function show(tab, scene, eye) {
  await tab.evaluate(async ([message, pose]) => {
    window.view.setScene(message);
    window.view.setCamera(pose);
    await window.drawn();
  }, [scene, eye]);
}

/// The colour of a pixel; x and y from 0 to 1.
export const colorAt = (tab, x, y) => tab.evaluate(([a, b]) => window.colorAt(a, b), [x, y]);

/// Why tests of the view are skipped, or false.
export const without = browserPath() !== undefined
  ? false : 'not run: there is no Chromium on this machine (PONGSIM_CHROMIUM=PATH names one)';
