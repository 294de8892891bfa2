import assert from 'node:assert/strict';
import test from 'node:test';
import { Requests } from './requests.ts';

test('each answer goes to its call', async () => {
  const requests = new Requests();
  const sent: Uint8Array[] = [];
  const send = (data: string | Uint8Array): void => void sent.push(data as Uint8Array);
  const first = requests.call(5, Uint8Array.of(1), send);
  const second = requests.call(5, Uint8Array.of(2), send);
  assert.deepEqual(sent.map((frame) => frame[5]), [1, 2]);
  requests.answer(2, Uint8Array.of(22));
  requests.answer(1, Uint8Array.of(11));
  requests.answer(77, Uint8Array.of(0));
  assert.deepEqual([...(await first), ...(await second)], [11, 22]);
});

test('refusals and the end of the connection are told to who waits', async () => {
  const requests = new Requests();
  const send = (): void => {};
  const refused = requests.call(1, new Uint8Array(), send);
  requests.refuse(1, 'no such model');
  await assert.rejects(refused, /no such model/);
  const file = requests.asset('a.dae', send);
  requests.answerAsset(2, 'not of this world', new Uint8Array());
  await assert.rejects(file, /not of this world/);
  const waiting = [requests.call(1, new Uint8Array(), send), requests.asset('b', send)];
  requests.fail('broken off');
  for (const each of waiting) await assert.rejects(each, /broken off/);
});
