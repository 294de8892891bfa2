/// Counts what arrives, by topic.

export interface Rate {
  topic: string;
  /// Messages, and bytes of their content, per second.
  messages: number;
  bytes: number;
}

export class Traffic {
  private counts = new Map<string, { messages: number; bytes: number }>();

  constructor(private since = 0) {}

  add(topic: string, bytes: number): void {
    const count = this.counts.get(topic) ?? { messages: 0, bytes: 0 };
    ++count.messages;
    count.bytes += bytes;
    this.counts.set(topic, count);
  }

  /// The rates since the last call, the most bytes first. Topics without messages since then are not in it.
  /// @param now [ms]
  take(now: number): Rate[] {
    const seconds = Math.max((now - this.since) / 1000, 1e-3);
    const rates = [...this.counts].map(([topic, { messages, bytes }]) => ({ topic, messages: messages / seconds, bytes: bytes / seconds }));
    this.counts.clear();
    this.since = now;
    return rates.sort((a, b) => b.bytes - a.bytes || a.topic.localeCompare(b.topic));
  }
}
