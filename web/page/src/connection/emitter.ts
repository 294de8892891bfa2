/// Tells everybody who has asked of each change. A listener that throws keeps no other from hearing.
export class Emitter<T> {
  private readonly listeners = new Set<(value: T) => void>();

  /// @return Ends it.
  on(listener: (value: T) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  emit(value: T): void {
    for (const listener of [...this.listeners]) {
      try {
        listener(value);
      } catch (fault) {
        console.error(fault);
      }
    }
  }

  get isHeard(): boolean {
    return this.listeners.size > 0;
  }
}
