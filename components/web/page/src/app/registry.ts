/// All panels, each with the names of Fortress's plugins that it replaces.
import { openEntityTree } from '../panels/entity_tree.ts';
import { openForce } from '../panels/force.ts';
import { openImageDisplay } from '../panels/image_display.ts';
import { openInspector } from '../panels/inspector.ts';
import { openJointPositions } from '../panels/joint_positions.ts';
import { openKeyPublisher } from '../panels/key_publisher.ts';
import { openLidarPlot } from '../panels/lidar_plot.ts';
import { openLights } from '../panels/lights.ts';
import { openLog } from '../panels/log.ts';
import { openPerformance } from '../panels/performance.ts';
import { openPlot } from '../panels/plot.ts';
import { openPointCloud } from '../panels/point_cloud.ts';
import { openPublisher } from '../panels/publisher.ts';
import { openServiceCall } from '../panels/service_call.ts';
import { openSpawn } from '../panels/spawn.ts';
import { openTeleop } from '../panels/teleop.ts';
import { openTimeline } from '../panels/timeline.ts';
import { openTopicEcho } from '../panels/topic_echo.ts';
import { openTopicTree } from '../panels/topic_tree.ts';
import { openTransform } from '../panels/transform.ts';
import { openViewSettings } from '../panels/view_settings.ts';
import { openWorldControl } from '../panels/world_control.ts';
import { openWorldStats } from '../panels/world_stats.ts';
import type { PanelKind } from './context.ts';

export const kPanels: readonly PanelKind[] = [
  { id: 'WorldControl', title: 'World control', place: 'corner-left', isForWriting: true, open: openWorldControl },
  { id: 'WorldStats', title: 'World stats', place: 'corner-right', open: openWorldStats },
  { id: 'EntityTree', title: 'Entity tree', place: 'right', open: openEntityTree },
  { id: 'ComponentInspector', title: 'Component inspector', place: 'right', open: openInspector },
  { id: 'KeyPublisher', title: 'Key publisher', place: 'right', isForWriting: true, open: openKeyPublisher },
  { id: 'Teleop', title: 'Teleop', place: 'right', isForWriting: true, open: openTeleop },
  { id: 'JointPositionController', title: 'Joint position controller', place: 'right', isForWriting: true, open: openJointPositions },
  { id: 'ImageDisplay', title: 'Image display', place: 'right', isMany: true, open: openImageDisplay },
  { id: 'VisualizeLidar', title: 'Visualize lidar', place: 'right', isMany: true, open: openLidarPlot },
  { id: 'PointCloud', title: 'Point cloud', place: 'right', isMany: true, open: openPointCloud },
  { id: 'Plotting', also: ['Plot'], title: 'Plot', place: 'bottom', isMany: true, open: openPlot },
  { id: 'TopicEcho', also: ['TopicViewer'], title: 'Topic echo', place: 'bottom', isMany: true, open: openTopicEcho },
  { id: 'TopicTree', title: 'Topics', place: 'left', open: openTopicTree },
  { id: 'Publisher', title: 'Publisher', place: 'left', isMany: true, isForWriting: true, open: openPublisher },
  { id: 'ServiceCall', title: 'Service', place: 'left', isMany: true, open: openServiceCall },
  { id: 'TransformControl', title: 'Transform control', place: 'left', open: openTransform },
  { id: 'ApplyForceTorque', title: 'Apply force torque', place: 'left', isForWriting: true, open: openForce },
  { id: 'Shapes', also: ['ResourceSpawner', 'Spawn'], title: 'Spawn', place: 'left', isForWriting: true, open: openSpawn },
  { id: 'Lights', title: 'Lights', place: 'left', isForWriting: true, open: openLights },
  {
    id: 'ViewAngle', also: ['VisualizationCapabilities', 'VisualizeContacts', 'CameraTracking', 'GridConfig'],
    title: 'View', place: 'left', open: openViewSettings,
  },
  { id: 'PlaybackScrubber', title: 'Timeline', place: 'bottom', isForWriting: true, open: openTimeline },
  { id: 'Performance', title: 'Performance', place: 'right', open: openPerformance },
  { id: 'Log', title: 'Messages', place: 'bottom', open: openLog },
];

/// @param plugin Name of a plugin, "WorldControl" or "libWorldControl.so".
export function panelFor(plugin: string): PanelKind | undefined {
  const name = plugin.replace(/^lib/, '').replace(/\.so$/, '');
  return kPanels.find(({ id, also }) => id === name || also?.includes(name));
}
