/// What was asked of the world and has not been told by it yet. A request often says all of a thing, such as a pose or a
/// light, of which the user has changed one number: the next one, made meanwhile, builds on what was asked for.

interface Wish {
  value: unknown;
  /// Requests that have not settled.
  pending: number;
}

export class Asked {
  private readonly wishes = new Map<string, Wish>();

  /// Makes a change.
  /// @param key Of the thing and what is changed of it.
  /// @param told What the world has told last.
  /// @param how What it is to be, from what was asked for last.
  /// @param request Asks for it.
  /// @param isTold Awaited after the request, if the world tells the result only later.
  async change<T>(
    key: string, told: T, how: (now: T) => T, request: (before: T, after: T) => Promise<void>, isTold: () => Promise<void> = async () => {},
  ): Promise<void> {
    const before = this.now(key, told);
    const after = how(before);
    const wish = this.wishes.get(key) ?? { value: after, pending: 0 };
    wish.value = after;
    ++wish.pending;
    this.wishes.set(key, wish);
    const settle = (): void => {
      if (--wish.pending === 0 && this.wishes.get(key) === wish) this.wishes.delete(key);
    };
    try {
      await request(before, after);
    } catch (fault) {
      // what was asked for after it is not built upon either
      if (this.wishes.get(key) === wish) this.wishes.delete(key);
      throw fault;
    }
    void isTold().finally(settle);
  }

  /// What was asked for, or else what the world has told.
  now<T>(key: string, told: T): T {
    const wish = this.wishes.get(key);
    return wish ? (wish.value as T) : told;
  }
}
