/// What has happened, for the log and, where it is a fault, for everybody to see at once.
import { Emitter } from '../connection/emitter.ts';

export interface Entry {
  level: 'info' | 'warning' | 'error';
  text: string;
  /// When the page heard of it [ms since 1970].
  at: number;
  /// How many times in a row.
  times: number;
  /// Whether it is not for everybody to see at once.
  isQuiet: boolean;
}

const kMost = 500;

export class MessageLog {
  readonly entries: Entry[] = [];
  readonly changed = new Emitter<Entry>();

  add(level: Entry['level'], text: string, isQuiet = false): void {
    const last = this.entries.at(-1);
    if (last && last.level === level && last.text === text) {
      last.times++;
      last.at = Date.now();
      this.changed.emit(last);
      return;
    }
    const entry = { level, text, at: Date.now(), times: 1, isQuiet };
    this.entries.push(entry);
    if (this.entries.length > kMost) this.entries.shift();
    this.changed.emit(entry);
  }

  clear(): void {
    this.entries.length = 0;
  }
}
