/// What the user has changed in the world, to undo and redo it.
import { Emitter } from '../connection/emitter.ts';

/// A change that can be made, taken back and made again.
export interface Change {
  /// "Move box"
  what: string;
  redo(): Promise<void>;
  undo(): Promise<void>;
}

/// Oldest changes beyond it are forgotten.
export const kMostChanges = 100;

export class History {
  readonly changed = new Emitter<void>();
  private done: Change[] = [];
  private undone: Change[] = [];
  private readonly replaced = new Map<number, number>();
  private last: Promise<unknown> = Promise.resolve();

  /// Makes a change. Changes are made one after the other.
  /// @throws Error with the reason if the world refuses it; it is then not part of the history.
  perform(change: Change): Promise<void> {
    return this.queue(async () => {
      await change.redo();
      this.done.push(change);
      if (this.done.length > kMostChanges) this.done.shift();
      this.undone = [];
    });
  }

  /// Takes the last change back. A change that the world refuses to take back is forgotten, as the entity has gone.
  /// @return What it was; undefined if there is none.
  undo(): Promise<string | undefined> {
    return this.move(() => this.done, () => this.undone, (change) => change.undo());
  }

  /// Makes the change again that was taken back last.
  redo(): Promise<string | undefined> {
    return this.move(() => this.undone, () => this.done, (change) => change.redo());
  }

  /// The change that `undo` or `redo` would concern.
  get nextUndo(): string | undefined {
    return this.done.at(-1)?.what;
  }
  get nextRedo(): string | undefined {
    return this.undone.at(-1)?.what;
  }

  /// Forgets all changes: the world has been reset.
  clear(): void {
    this.done = [];
    this.undone = [];
    this.replaced.clear();
    this.changed.emit();
  }

  /// An entity that was removed is there again, under another id.
  replace(before: number, now: number): void {
    if (before !== now) this.replaced.set(before, now);
  }

  /// The id that an entity has now.
  current(id: number): number {
    let now = id;
    for (let next = this.replaced.get(now); next !== undefined; next = this.replaced.get(now)) now = next;
    return now;
  }

  private move(from: () => Change[], to: () => Change[], act: (change: Change) => Promise<void>): Promise<string | undefined> {
    return this.queue(async () => {
      const change = from().pop();
      if (!change) return undefined;
      await act(change);
      to().push(change);
      return change.what;
    });
  }

  private queue<T>(act: () => Promise<T>): Promise<T> {
    const result = this.last.then(act, act).finally(() => this.changed.emit());
    this.last = result.catch(() => {});
    return result;
  }
}
