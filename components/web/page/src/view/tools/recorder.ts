/// Supported video formats, best first.
const kinds = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

// frames per second
const rate = 30;

/// Records a video of a canvas.
export class Recorder {
  private readonly pieces: Blob[] = [];
  private readonly recorder: MediaRecorder;

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
    return new Promise((resolve) => {
      const finish = () => {
        for (const track of this.recorder.stream.getTracks()) track.stop();
        resolve(new Blob(this.pieces, { type: 'video/webm' }));
      };
      this.recorder.addEventListener('stop', finish, { once: true });
      this.recorder.stop();
    });
  }
}
