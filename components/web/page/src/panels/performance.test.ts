import assert from 'node:assert/strict';
import test from 'node:test';
import { ratesByClient, sentRates, sizeText, type ClientTraffic } from './performance.ts';

test('sizes have the unit that suits them', () => {
  assert.deepEqual([0, 999, 1000, 12_345, 2_500_000, 7e12].map(sizeText), ['0 B', '999 B', '1.0 kB', '12.3 kB', '2.5 MB', '7000.0 GB']);
});

test('what the server sends per second is told by client and topic', () => {
  const client = (number: number, isYou: boolean, topics: ClientTraffic['topics']): ClientTraffic =>
    ({ number, address: '127.0.0.1', protocol: 'foxglove.sdk.v1', isYou, topics });
  const before = [client(1, true, { '/a': [1, 10] }), client(2, false, { '/a': [5, 50], '': [1, 1] })];
  const now = [client(1, true, { '/a': [3, 30], '/b': [2, 400] }), client(2, false, { '/a': [5, 50], '': [3, 5] }), client(3, false, { '/a': [9, 9] })];
  const rates = sentRates(before, now, 2);
  assert.deepEqual(rates, [
    { client: 'this page', topic: '/b', messages: 1, bytes: 200 },
    { client: 'this page', topic: '/a', messages: 1, bytes: 10 },
    { client: '127.0.0.1 foxglove.sdk.v1', topic: 'lists and replies', messages: 1, bytes: 2 },
  ]);
  assert.deepEqual(ratesByClient(rates), [['this page', 210], ['127.0.0.1 foxglove.sdk.v1', 2]]);
});
