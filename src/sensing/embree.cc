#include "sensing/embree.hh"

#include "base/shared_library.hh"

namespace pongsim::sensing {

namespace {

Embree openEmbree() {
  const auto library = base::SharedLibrary::require(PONGSIM_EMBREE, "libembree3-3");
  Embree functions{};
  library.bind(functions.newDevice, "rtcNewDevice");
  library.bind(functions.releaseDevice, "rtcReleaseDevice");
  library.bind(functions.getDeviceProperty, "rtcGetDeviceProperty");
  library.bind(functions.newScene, "rtcNewScene");
  library.bind(functions.releaseScene, "rtcReleaseScene");
  library.bind(functions.setSceneFlags, "rtcSetSceneFlags");
  library.bind(functions.commitScene, "rtcCommitScene");
  library.bind(functions.newGeometry, "rtcNewGeometry");
  library.bind(functions.releaseGeometry, "rtcReleaseGeometry");
  library.bind(functions.attachGeometry, "rtcAttachGeometry");
  library.bind(functions.commitGeometry, "rtcCommitGeometry");
  library.bind(functions.setGeometryUserData, "rtcSetGeometryUserData");
  library.bind(functions.setGeometryUserPrimitiveCount, "rtcSetGeometryUserPrimitiveCount");
  library.bind(functions.setGeometryBoundsFunction, "rtcSetGeometryBoundsFunction");
  library.bind(functions.setGeometryIntersectFunction, "rtcSetGeometryIntersectFunction");
  library.bind(functions.intersect1, "rtcIntersect1");
  library.bind(functions.intersect8, "rtcIntersect8");
  return functions;
}

}  // namespace

const Embree& embree() {
  static const Embree functions = openEmbree();
  return functions;
}

}  // namespace pongsim::sensing
