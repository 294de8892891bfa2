/// Shows how the page keeps up: frames of the view, the time that a request takes, what arrives by topic, and what the
/// server sends to whom.
import { Ends, type Context, type Panel } from '../app/context.ts';
import { h } from '../app/dom.ts';

const kEveryMs = 1000;
const kMostRows = 12;
/// Answers with what the server has sent to whom.
const kTrafficTopic = '/pongsim/traffic';

/// What the server has sent to a client so far: messages and bytes by topic, "" for what belongs to none.
export interface ClientTraffic {
  number: number;
  address: string;
  protocol: string;
  isYou: boolean;
  topics: Record<string, [messages: number, bytes: number]>;
}

export interface SentRate {
  /// "this page", "127.0.0.1 foxglove.sdk.v1"
  client: string;
  topic: string;
  /// Per second.
  messages: number;
  bytes: number;
}

/// What has been sent per second between two answers, the most bytes first. Clients that were not there before are not
/// in it.
export function sentRates(before: readonly ClientTraffic[], now: readonly ClientTraffic[], seconds: number): SentRate[] {
  const known = new Map(before.map((client) => [client.number, client]));
  const rates = now.flatMap((client) => {
    const old = known.get(client.number);
    if (!old) return [];
    const name = client.isYou ? 'this page' : `${client.address} ${client.protocol || 'without subprotocol'}`;
    return Object.entries(client.topics).map(([topic, [messages, bytes]]) => ({
      client: name, topic: topic || 'lists and replies',
      messages: (messages - (old.topics[topic]?.[0] ?? 0)) / seconds, bytes: (bytes - (old.topics[topic]?.[1] ?? 0)) / seconds,
    }));
  });
  return rates.filter(({ messages }) => messages > 0).sort((a, b) => b.bytes - a.bytes);
}

/// Adds up the rates of each client, the most bytes first.
export function ratesByClient(rates: readonly SentRate[]): [client: string, bytes: number][] {
  const sums = new Map<string, number>();
  for (const { client, bytes } of rates) sums.set(client, (sums.get(client) ?? 0) + bytes);
  return [...sums].sort(([, a], [, b]) => b - a);
}

/// "12.3 kB", in powers of 1000.
export function sizeText(bytes: number): string {
  const units = ['B', 'kB', 'MB', 'GB'];
  const unit = Math.min(Math.max(Math.floor(Math.log10(Math.max(bytes, 1)) / 3), 0), units.length - 1);
  return `${(bytes / 1000 ** unit).toFixed(unit === 0 ? 0 : 1)} ${units[unit]}`;
}

export function openPerformance(context: Context): Panel {
  const { connection, world, view, stream } = context;
  const ends = new Ends();
  const cell = (id: string): HTMLElement => h('dd', { id: `performance-${id}` }, '–');
  const [frames, resolution, work, trip, total] = [cell('frames'), cell('resolution'), cell('work'), cell('trip'), cell('total')];
  const rows = h('tbody', {});
  const sent = h('tbody', { id: 'performance-sent' });
  const clients = h('dl', { id: 'performance-clients' });
  let answer: { clients: ClientTraffic[]; at: number } | null = null;
  const showSent = (bytes: Uint8Array): void => {
    const now = { ...(JSON.parse(new TextDecoder().decode(bytes)) as { clients: ClientTraffic[] }), at: performance.now() };
    const seen = answer ? sentRates(answer.clients, now.clients, Math.max((now.at - answer.at) / 1000, 1e-3)) : [];
    answer = now;
    clients.replaceChildren(h('dt', {}, 'Clients'), h('dd', {}, String(now.clients.length)),
      ...ratesByClient(seen).flatMap(([client, sum]) => [h('dt', {}, client), h('dd', {}, `${sizeText(sum)} per second`)]));
    sent.replaceChildren(...seen.slice(0, kMostRows).map((rate) => h('tr', {},
      h('td', {}, rate.client), h('td', {}, rate.topic), h('td', {}, rate.messages.toFixed(rate.messages < 10 ? 1 : 0)), h('td', {}, sizeText(rate.bytes)))));
  };
  ends.add(connection.subscribeBytes(kTrafficTopic, showSent));
  let drawn = view?.statistics.frames ?? stream?.statistics.pictures ?? 0;
  let at = performance.now();
  let isAsking = false;
  // a request that changes nothing: to the world's thread and back, between two steps
  const ask = async (): Promise<void> => {
    if (isAsking) return;
    isAsking = true;
    const begin = performance.now();
    const isAnswered = await world.ask('gui/info').then(() => true, () => false);
    trip.textContent = isAnswered ? `${(performance.now() - begin).toFixed(0)} ms` : 'no answer';
    isAsking = false;
  };
  const show = (): void => {
    const now = performance.now();
    if (view) {
      const { frames: count, scale, drawCalls, triangles } = view.statistics;
      frames.textContent = `${((1000 * (count - drawn)) / (now - at)).toFixed(1)} per second`;
      resolution.textContent = `${Math.round(100 * scale)} %`;
      work.textContent = `${drawCalls} draw calls, ${triangles} triangles`;
      drawn = count;
    }
    if (stream) {
      const { pictures, width, height } = stream.statistics;
      frames.textContent = `${((1000 * (pictures - drawn)) / (now - at)).toFixed(1)} pictures of the server per second`;
      resolution.textContent = `${width} × ${height}`;
      drawn = pictures;
    }
    at = now;
    const rates = connection.traffic.take(now);
    total.textContent = `${sizeText(rates.reduce((sum, { bytes }) => sum + bytes, 0))} per second`;
    rows.replaceChildren(...rates.slice(0, kMostRows).map(({ topic, messages, bytes }) => h('tr', {},
      h('td', {}, topic), h('td', {}, messages.toFixed(messages < 10 ? 1 : 0)), h('td', {}, sizeText(bytes)))));
    void ask();
    connection.ask(kTrafficTopic, {});
  };
  const timer = setInterval(show, kEveryMs);
  ends.add(() => clearInterval(timer));
  // what came before does not count
  connection.traffic.take(at);
  const element = h('div', { class: 'performance', tabindex: 0, role: 'group', 'aria-label': 'Figures' },
    h('dl', {}, h('dt', {}, 'Frames drawn'), frames, h('dt', {}, 'Resolution'), resolution, h('dt', {}, 'Last frame'), work,
      h('dt', {}, 'Request and answer'), trip, h('dt', {}, 'Received'), total),
    h('table', {}, h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Topic'), h('th', { scope: 'col' }, 'per s'), h('th', { scope: 'col' }, 'bytes/s'))), rows),
    h('h3', {}, 'Sent by the server'), clients,
    h('table', {}, h('thead', {}, h('tr', {}, ...['Client', 'Topic', 'per s', 'bytes/s'].map((name) => h('th', { scope: 'col' }, name)))), sent),
    h('p', { class: 'hint' }, 'The view draws only when something changes.'));
  return { element, close: ends.end };
}
