/// Shows the points of a depth camera or lidar in the 3D view.
import { Ends, setting, type Context, type Panel, type Settings } from '../app/context.ts';
import { h } from '../app/dom.ts';
import { topicChooser, topicSetting } from './topics.ts';

export function openPointCloud(context: Context, settings: Settings): Panel {
  const { connection, view } = context;
  const ends = new Ends();
  let stop = (): void => {};
  let shown = '';
  const note = h('p', { class: 'hint' }, view ? 'No topic with points' : 'This browser has no WebGL 2');
  const listen = (topic: string): void => {
    stop();
    stop = (): void => {};
    if (shown) view?.setPointCloud(shown, null);
    shown = topic;
    if (!topic || !view) return;
    note.textContent = 'Waiting for points';
    stop = connection.subscribe(topic, (cloud) => {
      note.textContent = `${Number(cloud.width) * Number(cloud.height)} points`;
      view.setPointCloud(topic, cloud);
    });
  };
  const select = topicChooser(context, ['ignition.msgs.PointCloudPacked'], setting(settings, 'point_cloud_topic'), ends, listen);
  ends.add(() => {
    stop();
    if (shown) view?.setPointCloud(shown, null);
  });
  return { element: h('div', { class: 'point-cloud' }, select, note), close: ends.end, settings: () => topicSetting(select, 'point_cloud_topic') };
}
