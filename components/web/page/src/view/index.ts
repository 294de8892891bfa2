/// The interface of the 3D view. It is independent of the connection: the page passes in scenes, poses and files.
export type { Direction } from './camera/orbit_camera.ts';
export type { Pose } from './maths/placement.ts';
export type { Message } from './messages.ts';
export type { Frame } from './scene/places.ts';
export type { Overlay } from './scene/shown.ts';
export { StreamedView, type PictureWish } from './stream/streamed_view.ts';
export type { Tool } from './tools/handles.ts';
export { View, type ViewOptions } from './view.ts';
