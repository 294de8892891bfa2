/// A list of listeners, which are called for each change. An exception in one does not prevent calls of the others.
export class Emitter<T> {
  private readonly listeners = new Set<(value: T) => void>();

  /// @return A function that removes the listener.
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

  get hasListeners(): boolean {
    return this.listeners.size > 0;
  }
}
