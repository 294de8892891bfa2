/// The log: warnings of the server, refused requests, errors of the page.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';

export function openLog(context: Context): Panel {
  const { log } = context;
  const ends = new Ends();
  const list = h('ul', { class: 'log' });
  const level = h('select', { 'aria-label': 'Messages shown' },
    h('option', { value: 'info' }, 'All'), h('option', { value: 'warning' }, 'Warnings'), h('option', { value: 'error' }, 'Errors'));
  const order = ['info', 'warning', 'error'];
  const show = (): void => {
    const least = order.indexOf(level.value);
    const entries = log.lines.filter((line) => order.indexOf(line.level) >= least).slice(-200);
    list.replaceChildren(...entries.reverse().map((line) => h('li', { class: line.level },
      h('time', {}, new Date(line.at).toLocaleTimeString()), ' ', h('b', {}, line.level), ' ', line.text,
      line.times > 1 && ` (${line.times} times)`)));
    if (entries.length === 0) list.replaceChildren(h('li', { class: 'hint' }, 'Nothing'));
  };
  level.addEventListener('change', show);
  const clear = h('button', { type: 'button', onclick: () => {
    log.clear();
    show();
  } }, 'Clear');
  ends.add(log.changed.on(show));
  show();
  return { element: h('div', {}, h('div', { class: 'row' }, level, clear), h('div', { role: 'log', 'aria-label': 'Messages' }, list)), close: ends.end };
}
