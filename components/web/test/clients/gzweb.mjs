// gzweb's own classes, from its sources: its bundle wants a browser with WebGL.
export { Topic } from './node_modules/gzweb/src/Topic.ts';
export { Transport } from './node_modules/gzweb/src/Transport.ts';
