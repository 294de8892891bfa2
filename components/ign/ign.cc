#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "ign/bridge.hh"
#include "ign/closed_sockets.hh"
#include "ign/library.hh"
#include "ign/place.hh"
#include "pongsim/program/keystore.hh"
#include "pongsim/sensing/sensor.hh"
#include "pongsim/system.hh"

namespace pongsim::ign {

namespace {

// Limit of messages in ZeroMQ's queue for each subscriber: Fortress's value, and a lower one in worlds with images or
// point clouds, where a stopped subscriber would otherwise take gigabytes.
constexpr int kQueue = 1000;
constexpr int kQueueWithPictures = 100;
constexpr std::string_view kPictures[] = {
    "camera",  "depth_camera", "depth", "rgbd_camera",     "thermal_camera", "thermal", "segmentation_camera",
    "gpu_ray", "gpu_lidar",    "lidar", "wideanglecamera", "logical_camera"};

class Ign final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Puts the topics and services of the world on ign-transport 11, for the clients of Fortress.",
                   Declaration::Place::kWorld);
  }

  void configure(const SystemContext& context) override {
    Place place;
    try {
      place = placeOfEnvironment();
    } catch (const std::exception& error) {
      // an error in `configure`: the run does not start
      context.diagnostics.error(context.sdf.position, error.what());
      return;
    }
    settle(place, queueLengthFor(context.world));
    if (library().myAddress.empty()) {
      context.diagnostics.error(context.sdf.position, "ign-transport can't open sockets at " + place.address);
      return;
    }
    if (!place.isOpen) closeDiscoveryToOthers();
    context.log.info("partition '" + place.partition + "' at " + place.address);
    if (place.isOpen) {
      context.log.warning("open to the network of " + place.address + ": anybody there can command it");
    }
    if (isSecured()) {
      context.log.warning("ign-transport is not secured, only DDS is");
    }
    bridge_.emplace(context.node, context.log, place.address);
    // the bridge has opened another discovery socket
    if (!place.isOpen) closeDiscoveryToOthers();
  }

  void preUpdate(const StepInfo&) override {
    if (bridge_) bridge_->update();
  }

 private:
  static int queueLengthFor(const World& world) {
    for (const std::string_view type : kPictures) {
      if (!world.sensors(type).empty()) return kQueueWithPictures;
    }
    return kQueue;
  }

  std::optional<Bridge> bridge_;
};

}  // namespace

}  // namespace pongsim::ign

PONGSIM_EXPORT_SYSTEM(pongsim::ign::Ign, "pongsim::systems::Ign");
