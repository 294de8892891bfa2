#pragma once

#include <embree3/rtcore.h>

#include <memory>

namespace pongsim::sensing {

/// What is used of Embree's functions, by their names without `rtc`. Its library is opened with the first scene: only
/// runs with a lidar need it, and every command would wait for it.
struct Embree {
  decltype(&rtcNewDevice) newDevice;
  decltype(&rtcReleaseDevice) releaseDevice;
  decltype(&rtcGetDeviceProperty) getDeviceProperty;
  decltype(&rtcNewScene) newScene;
  decltype(&rtcReleaseScene) releaseScene;
  decltype(&rtcSetSceneFlags) setSceneFlags;
  decltype(&rtcCommitScene) commitScene;
  decltype(&rtcNewGeometry) newGeometry;
  decltype(&rtcReleaseGeometry) releaseGeometry;
  decltype(&rtcAttachGeometry) attachGeometry;
  decltype(&rtcCommitGeometry) commitGeometry;
  decltype(&rtcSetGeometryUserData) setGeometryUserData;
  decltype(&rtcSetGeometryUserPrimitiveCount) setGeometryUserPrimitiveCount;
  decltype(&rtcSetGeometryBoundsFunction) setGeometryBoundsFunction;
  decltype(&rtcSetGeometryIntersectFunction) setGeometryIntersectFunction;
  decltype(&rtcIntersect1) intersect1;
  decltype(&rtcIntersect8) intersect8;
};

/// @throws std::runtime_error where its library can't be opened, saying what to install.
const Embree& embree();

struct ReleaseDevice {
  void operator()(RTCDeviceTy* device) const { embree().releaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCSceneTy* scene) const { embree().releaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometryTy* geometry) const { embree().releaseGeometry(geometry); }
};
using DevicePointer = std::unique_ptr<RTCDeviceTy, ReleaseDevice>;
using ScenePointer = std::unique_ptr<RTCSceneTy, ReleaseScene>;
using GeometryPointer = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

}  // namespace pongsim::sensing
