/// Contact points of the world, from its channel `/world/W/contacts`. See components/web/frames/contact_channel.hh.
import type { Message } from './types.ts';

const kHead = 4;
const kEntry = 40;

/// Decodes them as an ignition.msgs.Contacts, as contact sensors publish it, with one point each.
/// @throws Error if the bytes are cut off.
export function readContacts(bytes: Uint8Array): Message {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = bytes.length < kHead ? -1 : view.getUint32(0, true);
  if (bytes.length !== kHead + count * kEntry) throw new Error('the contacts of the server are cut off');
  const vector = (at: number): Message => ({ x: view.getFloat32(at, true), y: view.getFloat32(at + 4, true), z: view.getFloat32(at + 8, true) });
  const contact = Array.from({ length: count }, (_, i) => {
    const at = kHead + i * kEntry;
    return { position: [vector(at)], normal: [vector(at + 12)], wrench: [{ body1Wrench: { force: vector(at + 24) } }], depth: [view.getFloat32(at + 36, true)] };
  });
  return { contact };
}
