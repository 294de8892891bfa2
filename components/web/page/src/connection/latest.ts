/// Keeps only the latest value of each key until the next animation frame. A page that is too slow, or hidden,
/// processes fewer values, and never outdated ones.
export class Latest {
  private readonly waiting = new Map<unknown, () => void>();
  private isScheduled = false;

  /// @param nextAnimationFrame Schedules a call; `requestAnimationFrame`, except in tests.
  constructor(private readonly nextAnimationFrame: (callback: () => void) => void) {}

  /// @param deliver Called in the next animation frame, unless a newer value with the same key replaces it before.
  put(key: unknown, deliver: () => void): void {
    this.waiting.set(key, deliver);
    if (this.isScheduled) return;
    this.isScheduled = true;
    this.nextAnimationFrame(() => this.deliver());
  }

  drop(key: unknown): void {
    this.waiting.delete(key);
  }

  private deliver(): void {
    this.isScheduled = false;
    const now = [...this.waiting.values()];
    this.waiting.clear();
    for (const each of now) {
      try {
        each();
      } catch (fault) {
        console.error(fault);
      }
    }
  }
}
