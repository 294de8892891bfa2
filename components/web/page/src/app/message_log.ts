/// Messages for the log; errors are also shown at once.
import { Emitter } from '../connection/emitter.ts';

export interface LogLine {
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
