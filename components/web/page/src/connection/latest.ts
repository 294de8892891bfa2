/// Keeps only the latest value of each key until the next animation frame: a page that can't keep up, or that is
/// hidden, gets fewer values and never outdated ones.
export class Latest {
  private readonly waiting = new Map<unknown, () => void>();
  private isAsked = false;

  /// @param nextPicture Schedules a call: requestAnimationFrame, except in tests.
  constructor(private readonly nextPicture: (callback: () => void) => void) {}

  /// @param deliver Called once, unless a newer value with the same key arrives before.
  put(key: unknown, deliver: () => void): void {
    this.waiting.set(key, deliver);
    if (this.isAsked) return;
    this.isAsked = true;
    this.nextPicture(() => this.deliver());
  }

  drop(key: unknown): void {
    this.waiting.delete(key);
  }

  private deliver(): void {
    this.isAsked = false;
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
