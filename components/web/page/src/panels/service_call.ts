/// Calls a service with a request that is entered in a form for its type, and shows the answer.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h, labelled } from '../app/dom.ts';
import { messageForm } from './message_form.ts';
import { echoText } from './topic_echo.ts';

export function openServiceCall(context: Context, settings: Settings): Panel {
  const { connection } = context;
  const ends = new Ends();
  const list = h('datalist', { id: 'service-names' });
  const name = h('input', { value: setting(settings, 'service') ?? '', list: 'service-names', class: 'wide', placeholder: '/world/…' });
  const place = h('div', {});
  const note = h('p', { class: 'hint', role: 'status' });
  const answer = h('pre', { class: 'echo', tabindex: 0, role: 'region', 'aria-label': 'Answer', hidden: true });
  let form: ReturnType<typeof messageForm> | null = null;

  const choose = (): void => {
    form = null;
    answer.hidden = true;
    const service = connection.services.get(name.value);
    const request = service?.request && connection.types.find(service.request.schemaName);
    if (request) form = messageForm(request);
    place.replaceChildren(...(form ? [form.element] : []));
    button.disabled = !form;
    if (service && form) note.textContent = `${service.request?.schemaName} → ${service.response?.schemaName}`;
    else note.textContent = name.value ? `There is no service ${name.value} that this page can call` : 'Choose a service';
  };
  const call = async (): Promise<void> => {
    const service = connection.services.get(name.value);
    if (!form || !service?.response) return;
    button.disabled = true;
    const begin = performance.now();
    try {
      const found = await connection.call(name.value, form.value());
      answer.textContent = echoText(connection.types.json(service.response.schemaName, found));
      answer.hidden = false;
      note.textContent = `Answered after ${(performance.now() - begin).toFixed(0)} ms`;
    } catch (fault) {
      answer.hidden = true;
      note.textContent = `Refused: ${(fault as Error).message}`;
    }
    button.disabled = false;
  };
  const button = h('button', { type: 'button', onclick: () => void call() }, 'Call');
  const offer = (): void => {
    list.replaceChildren(...[...connection.services.keys()].sort().map((value) => h('option', { value })));
    if (!form) choose();
  };
  name.addEventListener('change', choose);
  ends.add(connection.servicesChanged.on(offer));
  offer();
  const element = h('div', { class: 'service-call' }, labelled('Service', name), list, place, h('div', { class: 'row' }, button), note, answer);
  return { element, close: ends.end, settings: () => ({ service: [name.value] }) };
}
