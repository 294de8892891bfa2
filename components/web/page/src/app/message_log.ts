/// The messages of the log panel; errors are also shown in a box above the page.
import { Emitter } from '../connection/emitter.ts';

export interface LogLine {
  level: 'info' | 'warning' | 'error';
  text: string;
  /// Time of receipt [ms since 1970].
  at: number;
  /// Number of times that it arrived consecutively.
  times: number;
  /// Whether it is shown in the log panel only.
  isQuiet: boolean;
}

const kMost = 500;

export class MessageLog {
  readonly lines: LogLine[] = [];
  readonly changed = new Emitter<LogLine>();

  add(level: LogLine['level'], text: string, isQuiet = false): void {
    const last = this.lines.at(-1);
    if (last && last.level === level && last.text === text) {
      last.times++;
      last.at = Date.now();
      this.changed.emit(last);
      return;
    }
    const line = { level, text, at: Date.now(), times: 1, isQuiet };
    this.lines.push(line);
    if (this.lines.length > kMost) this.lines.shift();
    this.changed.emit(line);
  }

  clear(): void {
    this.lines.length = 0;
  }
}
