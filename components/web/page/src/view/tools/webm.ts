/// The length of a WebM file, which browsers leave out when they record: players then show no length and can't seek.

// EBML ids
const segment = 0x18538067;
const info = 0x1549a966;
const timecodeScale = 0x2ad7b1;
const duration = 0x4489;
const nsPerMs = 1e6;

interface Element {
  id: number;
  /// Where its size and its content begin, and the content ends; an unknown size reaches to the end.
  sizeAt: number;
  begin: number;
  end: number;
}

/// The number of bytes of an id or size that begins with this byte.
function lengthOf(first: number): number {
  return Math.clz32(first) - 23;
}

function elementAt(bytes: Uint8Array, at: number): Element | null {
  const idLength = lengthOf(bytes[at] ?? 0);
  const sizeAt = at + idLength;
  const sizeLength = lengthOf(bytes[sizeAt] ?? 0);
  const begin = sizeAt + sizeLength;
  if (idLength > 4 || sizeLength > 8 || begin > bytes.length) return null;
  const id = bytes.slice(at, sizeAt).reduce((number, byte) => number * 256 + byte, 0);
  const digits = bytes.slice(sizeAt, begin);
  digits[0]! &= (1 << (8 - sizeLength)) - 1;
  const isUnknown = digits.every((byte, i) => byte === (i === 0 ? (1 << (8 - sizeLength)) - 1 : 255));
  const size = digits.reduce((number, byte) => number * 256 + byte, 0);
  return { id, sizeAt, begin, end: isUnknown ? bytes.length : Math.min(begin + size, bytes.length) };
}

function childOf(bytes: Uint8Array, parent: { begin: number; end: number }, id: number): Element | null {
  for (let at = parent.begin; at < parent.end;) {
    const element = elementAt(bytes, at);
    if (element === null) return null;
    if (element.id === id) return element;
    at = element.end;
  }
  return null;
}

/// The file with its length.
/// @param bytes The file, or its first part, which contains `Info`.
/// @param ms Its length [ms].
/// @return The same bytes if they have a length already, or are not as browsers write them.
export function withDuration(bytes: Uint8Array<ArrayBuffer>, ms: number): Uint8Array<ArrayBuffer> {
  const whole = { begin: 0, end: bytes.length };
  const outer = childOf(bytes, whole, segment);
  const inner = outer && childOf(bytes, outer, info);
  if (!inner || inner.end - inner.begin > 0xffff || childOf(bytes, inner, duration)) return bytes;
  const scale = childOf(bytes, inner, timecodeScale);
  const unit = scale ? bytes.slice(scale.begin, scale.end).reduce((number, byte) => number * 256 + byte, 0) : nsPerMs;
  const added = new Uint8Array(11);
  added.set([0x44, 0x89, 0x88]);
  new DataView(added.buffer).setFloat64(3, (ms * nsPerMs) / unit);
  const size = new Uint8Array(4);
  new DataView(size.buffer).setUint32(0, 0x10000000 + inner.end - inner.begin + added.length);
  const parts = [bytes.subarray(0, inner.sizeAt), size, bytes.subarray(inner.begin, inner.end), added, bytes.subarray(inner.end)];
  const result = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    result.set(part, at);
    at += part.length;
  }
  return result;
}
