// What gzweb expects of a browser and node has not: WebSockets with blobs, and their reader.
import WebSocket from 'ws';

class BrowserSocket extends WebSocket {
  constructor(address, protocols) {
    super(address, protocols);
    this.binaryType = 'blob';
  }
}

class FileReader {
  #read(promise) {
    promise.then((result) => {
      this.result = result;
      this.onloadend();
    });
  }
  readAsText(blob) {
    this.#read(blob.text());
  }
  readAsArrayBuffer(blob) {
    this.#read(blob.arrayBuffer());
  }
}

globalThis.WebSocket = BrowserSocket;
globalThis.FileReader = FileReader;
