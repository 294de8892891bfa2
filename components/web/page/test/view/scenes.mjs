// Scenes for tests of the view, as ignition.msgs.Scene.

export const white = { r: 1, g: 1, b: 1, a: 1 };
export const type = {
  box: 0, cylinder: 1, sphere: 2, plane: 3, heightmap: 5, mesh: 6, polyline: 9, cone: 10, capsule: 14, ellipsoid: 15,
};

export function paint(r, g, b, more = {}) {
  const color = { r, g, b, a: 1 };
  return { ambient: color, diffuse: color, specular: { r: 0.2, g: 0.2, b: 0.2, a: 1 }, lighting: true, ...more };
}

export function box(x, y, z) {
  return { type: type.box, box: { size: { x, y, z } } };
}

/// A model with one link; its parts have the ids id, id + 1, ...
export function model(id, [x, y, z], geometry, material, more = {}) {
  return {
    id,
    name: `model${id}`,
    pose: { position: { x, y, z }, orientation: { w: 1 } },
    link: [{
      id: id + 1,
      name: 'link',
      visual: [{ id: id + 2, name: 'visual', geometry, material, castShadows: true }],
      collision: [{ id: id + 3, name: 'collision', geometry }],
      ...more,
    }],
  };
}

export const sun = {
  id: 9001, name: 'sun', type: 2, castShadows: true, direction: { x: 0.5, y: 0.3, z: -1 }, diffuse: { ...white }, intensity: 0.8,
  specular: white,
};

export const ground = model(
  9100, [0, 0, 0], { type: type.plane, plane: { normal: { z: 1 }, size: { x: 20, y: 20 } } }, paint(0.7, 0.7, 0.7),
);

export function scene(models, more = {}) {
  return {
    ambient: { r: 0.4, g: 0.4, b: 0.4, a: 1 }, background: { r: 0.7, g: 0.7, b: 0.7, a: 1 }, shadows: true, grid: false,
    model: models, light: [sun], ...more,
  };
}

/// The pose of a camera that looks along x.
export function eyeAt(x, y = 0, z = 0) {
  return { position: [x, y, z], orientation: [0, 0, 0, 1] };
}

/// A scene with an example of each shape, material and light.
export function everything() {
  const shapes = [
    model(10, [0, 3, 0.5], box(1, 1, 1), paint(0.9, 0.1, 0.1)),
    model(20, [0, 1.5, 0.5], { type: type.sphere, sphere: { radius: 0.5 } }, paint(0.1, 0.2, 0.9)),
    model(30, [0, 0, 0.5], { type: type.cylinder, cylinder: { radius: 0.4, length: 1 } }, paint(0.1, 0.8, 0.1)),
    model(40, [0, -1.5, 0.8], { type: type.capsule, capsule: { radius: 0.3, length: 1 } }, paint(0.9, 0.9, 0.1)),
    model(50, [0, -3, 0.4], { type: type.ellipsoid, ellipsoid: { radii: { x: 0.3, y: 0.7, z: 0.4 } } }, paint(0.8, 0.1, 0.8)),
    model(60, [2.5, 3, 0.5], { type: type.cone, cone: { radius: 0.5, length: 1 } }, paint(0.1, 0.8, 0.8)),
    model(70, [2.5, 1, 0], {
      type: type.polyline,
      polyline: [{ height: 0.8, point: [{ x: 0, y: 0 }, { x: 1, y: 0 }, { x: 0.5, y: 1 }] }],
    }, paint(0.9, 0.5, 0.1)),
    model(80, [2.5, -0.5, 0.5], box(0.8, 0.8, 0.8), paint(0.9, 0.8, 0.6, {
      pbr: { type: 1, metalness: 1, roughness: 0.2 },
    })),
    model(90, [3, -2.5, 1], { type: type.mesh, mesh: { filename: '/meshes/square.obj' } }),
    model(100, [7, 0, 0], {
      type: type.heightmap, heightmap: { filename: '/hills.png', size: { x: 6, y: 10, z: 2 } },
    }, paint(0.5, 0.6, 0.4)),
  ];
  const lamp = {
    id: 9002, name: 'lamp', type: 1, castShadows: true, pose: { position: { x: -1, y: 0, z: 3 }, orientation: { w: 1 } },
    direction: { z: -1 }, diffuse: { r: 1, g: 0.6, b: 0.3 }, spotInnerAngle: 0.6, spotOuterAngle: 1, spotFalloff: 1,
    range: 10, attenuationConstant: 0.3, attenuationLinear: 0.05, intensity: 1,
  };
  return scene([ground, ...shapes], { sky: { time: 12, sunrise: 6, sunset: 20 }, light: [sun, lamp] });
}

/// A model with a joint and a lidar.
export function robot() {
  const inertial = { mass: 4, ixx: 0.1, iyy: 0.2, izz: 0.25, pose: { position: { z: 0.1 }, orientation: { w: 1 } } };
  const base = model(10, [0, 0, 0.3], box(1, 0.8, 0.3), paint(0.8, 0.8, 0.8), {
    name: 'base', inertial, sensor: [{ id: 16, name: 'lidar', pose: { position: { z: 0.3 }, orientation: { w: 1 } } }],
  });
  const arm = {
    id: 20, name: 'arm', pose: { position: { x: 0.3, z: 0.6 }, orientation: { w: 1 } }, inertial: { ...inertial, mass: 1 },
    visual: [{ id: 21, name: 'look', geometry: box(0.1, 0.1, 0.9), material: paint(0.3, 0.3, 0.9), castShadows: true }],
    collision: [{ id: 22, name: 'touch', geometry: box(0.2, 0.2, 0.9) }],
  };
  const joint = {
    id: 30, name: 'shoulder', type: 0, parent: 'base', child: 'arm', axis1: { xyz: { y: 1 } },
    pose: { position: { z: -0.4 }, orientation: { w: 1 } },
  };
  return { ...base, link: [...base.link, arm], joint: [joint] };
}
