#pragma once

#include <embree3/rtcore.h>

#include <memory>

namespace pongsim::sensing {

/// Embree's functions, without the prefix `rtc`. The library is opened with the first scene, since only runs with
/// lidars need it and loading takes time.
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

/// @throws std::runtime_error if the library can't be opened; the message names the package.
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
