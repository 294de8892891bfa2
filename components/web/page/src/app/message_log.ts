/// Messages for the log; errors are also shown at once.
import { Emitter } from '../connection/emitter.ts';

export interface Entry {
  level: 'info' | 'warning' | 'error';
  text: string;
  /// When the page received it [ms since 1970].
  at: number;
  /// Number of consecutive repetitions.
  times: number;
  /// Whether it is only shown in the log.
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
