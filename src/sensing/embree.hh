#pragma once

#include <embree3/rtcore.h>

#include <memory>

namespace pongsim::sensing {

struct ReleaseDevice {
  void operator()(RTCDeviceTy* device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCSceneTy* scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometryTy* geometry) const { rtcReleaseGeometry(geometry); }
};
using DevicePointer = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using ScenePointer = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using GeometryPointer = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

}  // namespace pongsim::sensing
