// A pongsim that clients talk to, for tests.
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { join } from 'node:path';

/// Longer than anything takes on a busy machine.
const patience = 60_000;

/// Runs a world of this folder.
/// @param options More of `pongsim run`.
/// @return Where WebSockets go, the program's process number, and how to end it.
export async function runWorld(world = 'world.sdf', options = ['--web', '0']) {
  const child = spawn(process.env.PONGSIM, ['run', join(process.env.PONGSIM_CLIENTS_WORLDS, world), ...options], {
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  let said = '';
  const ended = once(child, 'exit');
  const address = await new Promise((resolve, reject) => {
    const hear = (text) => {
      said += text;
      const found = /http:(\/\/[\d.]+:\d+\/)/.exec(said);
      if (found) resolve(`ws:${found[1]}`);
    };
    child.stdout.on('data', hear);
    child.stderr.on('data', hear);
    child.on('exit', (code) => reject(new Error(`pongsim ended with ${code}: ${said}`)));
  });
  const end = async () => {
    child.kill('SIGINT');
    await ended;
  };
  return { address, pid: child.pid, end };
}

/// Waits until that is something.
/// @return What it is then.
export async function until(look, what) {
  const end = Date.now() + patience;
  for (;;) {
    const found = look();
    if (found) return found;
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}
