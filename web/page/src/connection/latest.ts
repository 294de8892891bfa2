/// Lets only the latest value of each key wait until the browser draws its next picture: a page that can't keep up, or
/// that nobody sees, gets fewer values and never old ones.
export class Latest {
  private readonly waiting = new Map<unknown, () => void>();
  private isAsked = false;

  /// @param nextPicture Calls back when it is time: requestAnimationFrame, but for tests.
  constructor(private readonly nextPicture: (callback: () => void) => void) {}

  /// @param deliver Called once, unless another one comes under the same key before.
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
