/// Writes a model as SDF, from scene and state, which contain no plugins, sensors and friction.
import { shortest, sixfoldOf } from './poses.ts';
import type { Message } from './types.ts';

const kJointTypes = ['revolute', 'revolute2', 'prismatic', 'universal', 'ball', 'screw', 'gearbox', 'fixed'];

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');
const xyz = (v: Message | undefined): string => [v?.x, v?.y, v?.z].map((value) => shortest((value as number) ?? 0)).join(' ');
const poseText = (pose: Message | undefined): string => sixfoldOf(pose).map(shortest).join(' ');
const rgba = (color: Message | undefined): string => [color?.r, color?.g, color?.b, color?.a].map((value) => shortest((value as number) ?? 0)).join(' ');

/// Lines of XML, indented by two blanks per level.
class Lines {
  private readonly lines: string[] = [];
  private level = 0;

  value(name: string, text: string): void {
    this.lines.push(`${'  '.repeat(this.level)}<${name}>${escaped(text)}</${name}>`);
  }

  within(open: string, fill: () => void): void {
    this.lines.push(`${'  '.repeat(this.level)}<${open}>`);
    this.level++;
    fill();
    this.level--;
    this.lines.push(`${'  '.repeat(this.level)}</${open.split(' ')[0]!}>`);
  }

  text(): string {
    return this.lines.join('\n') + '\n';
  }
}

/// @param model An ignition.msgs.Model of a completed scene.
/// @param pose Its current pose, an ignition.msgs.Pose.
export function modelSdf(model: Message, pose: Message | undefined): string {
  const lines = new Lines();
  lines.within('sdf version="1.9"', () => writeModel(model, pose, lines));
  return `<?xml version="1.0"?>\n${lines.text()}`;
}

function writeModel(model: Message, pose: Message | undefined, lines: Lines): void {
  lines.within(`model name="${escaped(model.name as string)}"`, () => {
    lines.value('pose', poseText(pose));
    if (model.isStatic) lines.value('static', 'true');
    for (const link of (model.link ?? []) as Message[]) writeLink(link, lines);
    for (const joint of (model.joint ?? []) as Message[]) writeJoint(joint, lines);
    for (const inner of (model.model ?? []) as Message[]) writeModel(inner, inner.pose as Message, lines);
  });
}

function writeLink(link: Message, lines: Lines): void {
  lines.within(`link name="${escaped(link.name as string)}"`, () => {
    lines.value('pose', poseText(link.pose as Message));
    const inertial = link.inertial as Message | undefined;
    if (inertial) {
      lines.within('inertial', () => {
        lines.value('pose', poseText(inertial.pose as Message));
        lines.value('mass', shortest(inertial.mass as number));
        lines.within('inertia', () => {
          for (const moment of ['ixx', 'ixy', 'ixz', 'iyy', 'iyz', 'izz']) lines.value(moment, shortest(inertial[moment] as number));
        });
      });
    }
    for (const collision of (link.collision ?? []) as Message[]) writeShape('collision', collision, lines);
    for (const visual of (link.visual ?? []) as Message[]) writeShape('visual', visual, lines);
  });
}

function writeShape(kind: 'collision' | 'visual', shape: Message, lines: Lines): void {
  lines.within(`${kind} name="${escaped(shape.name as string)}"`, () => {
    lines.value('pose', poseText(shape.pose as Message));
    lines.within('geometry', () => writeGeometry(shape.geometry as Message | undefined, lines));
    const material = shape.material as Message | undefined;
    if (kind !== 'visual' || !material) return;
    lines.within('material', () => {
      for (const color of ['ambient', 'diffuse', 'specular', 'emissive']) {
        if (material[color]) lines.value(color, rgba(material[color] as Message));
      }
    });
  });
}

function writeGeometry(geometry: Message | undefined, lines: Lines): void {
  const { box, sphere, cylinder, cone, capsule, ellipsoid, plane, mesh } = geometry ?? {};
  const round = (name: string, shape: Message): void => lines.within(name, () => {
    lines.value('radius', shortest(shape.radius as number));
    if (shape.length !== undefined) lines.value('length', shortest(shape.length as number));
  });
  if (box) lines.within('box', () => lines.value('size', xyz(box.size as Message)));
  else if (sphere) round('sphere', sphere as Message);
  else if (cylinder) round('cylinder', cylinder as Message);
  else if (cone) round('cone', cone as Message);
  else if (capsule) round('capsule', capsule as Message);
  else if (ellipsoid) lines.within('ellipsoid', () => lines.value('radii', xyz(ellipsoid.radii as Message)));
  else if (plane) {
    lines.within('plane', () => {
      lines.value('normal', xyz(plane.normal as Message));
      lines.value('size', `${shortest((plane.size?.x as number) ?? 1)} ${shortest((plane.size?.y as number) ?? 1)}`);
    });
  } else if (mesh) {
    lines.within('mesh', () => {
      lines.value('uri', mesh.filename as string);
      lines.value('scale', xyz(mesh.scale as Message));
      if (mesh.submesh) lines.within('submesh', () => lines.value('name', mesh.submesh as string));
    });
  } else lines.within('empty', () => {});
}

function writeJoint(joint: Message, lines: Lines): void {
  const type = kJointTypes[joint.type as number] ?? 'fixed';
  lines.within(`joint name="${escaped(joint.name as string)}" type="${type}"`, () => {
    lines.value('pose', poseText(joint.pose as Message));
    lines.value('parent', joint.parent as string);
    lines.value('child', joint.child as string);
    for (const [name, axis] of [['axis', joint.axis1], ['axis2', joint.axis2]] as [string, Message | undefined][]) {
      if (axis) writeAxis(name, axis, lines);
    }
  });
}

function writeAxis(name: string, axis: Message, lines: Lines): void {
  lines.within(name, () => {
    lines.value('xyz', xyz(axis.xyz as Message));
    lines.within('limit', () => {
      for (const limit of ['lower', 'upper', 'effort', 'velocity']) {
        const value = axis[`limit${limit[0]!.toUpperCase()}${limit.slice(1)}`] as number;
        lines.value(limit, Number.isFinite(value) ? shortest(value) : value < 0 ? '-inf' : 'inf');
      }
    });
    lines.within('dynamics', () => {
      lines.value('damping', shortest(axis.damping as number));
      lines.value('friction', shortest(axis.friction as number));
    });
  });
}
