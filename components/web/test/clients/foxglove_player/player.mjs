// Foxglove's player for rosbridge, as the package @foxglove/studio-base has it. Only what connects it to a browser is another:
// it opens its WebSocket here, and not in a worker.
import roslib from '@foxglove/roslibjs';

const { Ros } = roslib;
roslib.Ros = function (options) {
  return new Ros({ ...options, transportLibrary: 'websocket' });
};

export { default as RosbridgePlayer } from '@foxglove/studio-base/src/players/RosbridgePlayer.js';
export { logged } from './log.mjs';
