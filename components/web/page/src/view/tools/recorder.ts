import { withDuration } from './webm.ts';

/// Supported video formats, best first.
const kinds = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

// frames per second
const rate = 30;

/// Records a video of a canvas.
export class Recorder {
  private readonly pieces: Blob[] = [];
  private readonly recorder: MediaRecorder;
  private readonly begin = performance.now();

  /// @throws Error if this browser can't record video.
  constructor(canvas: HTMLCanvasElement) {
    const mimeType = kinds.find((kind) => typeof MediaRecorder !== 'undefined' && MediaRecorder.isTypeSupported(kind));
    if (mimeType === undefined) throw new Error('this browser cannot record WebM videos');
    this.recorder = new MediaRecorder(canvas.captureStream(rate), { mimeType });
    this.recorder.addEventListener('dataavailable', ({ data }) => this.pieces.push(data));
    // data is passed on once a second, so that little is lost on a failure
    this.recorder.start(1000);
  }

  /// @returns The video, a WebM file.
  stop(): Promise<Blob> {
    const length = performance.now() - this.begin;
    return new Promise((resolve, reject) => {
      const finish = () => {
        for (const track of this.recorder.stream.getTracks()) track.stop();
        this.file(length).then(resolve, reject);
      };
      this.recorder.addEventListener('stop', finish, { once: true });
      this.recorder.stop();
    });
  }

  /// @param length [ms]
  private async file(length: number): Promise<Blob> {
    const [first, ...rest] = this.pieces;
    const head = first ? [withDuration(new Uint8Array(await first.arrayBuffer()), length)] : [];
    return new Blob([...head, ...rest], { type: 'video/webm' });
  }
}
