#include <cstdlib>
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
constexpr std::string_view kPictures[] = {"camera",
                                          "depth_camera",
                                          "depth",
                                          "rgbd_camera",
                                          "thermal_camera",
                                          "thermal",
                                          "segmentation",
                                          "segmentation_camera",
                                          "boundingbox",
                                          "boundingbox_camera",
                                          "boundingbox_camera_3d",
                                          "gpu_ray",
                                          "gpu_lidar",
                                          "lidar",
                                          "ray",
                                          "wide_angle_camera",
                                          "wideanglecamera",
                                          "logical_camera"};

class Ign final : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Puts the topics and services of the world on ign-transport, for the clients of Fortress or later.",
                   Declaration::Place::kWorld);
    declaration.standsOutside();
    declaration
        .parameter("names", &names_, "", "of types and environment variables: Fortress's, or those since Garden (gz)")
        .oneOf({"ign", "gz"});
  }

  void configure(const SystemContext& context) override {
    const Generation generation = names_ == "gz" ? Generation::kGz : Generation::kIgn;
    // the library's settings are those of the whole process
    static const Generation first = generation;
    if (generation != first) {
      context.diagnostics.error(context.sdf.position, "a process is either for Fortress's clients or for later ones",
                                "run the worlds in two processes: pongsim run FILE -w WORLD");
      return;
    }
    Place place;
    try {
      place = placeOfEnvironment(generation);
    } catch (const std::exception& error) {
      // an error in `configure`: the run does not start
      context.diagnostics.error(context.sdf.position, error.what());
      return;
    }
    warnOfOtherNames(generation, context.log);
    settle(place, queueLengthFor(context.world), generation);
    if (library().myAddress.empty()) {
      context.diagnostics.error(context.sdf.position, "ign-transport can't open sockets at " + place.address);
      return;
    }
    filterDiscovery(place.isOpen);
    context.log.info("partition '" + place.partition + "' at " + place.address);
    if (place.isOpen) {
      context.log.warning("open to the network of " + place.address + ": anybody there can command it");
    }
    if (isSecured()) {
      context.log.warning("ign-transport is not secured, only DDS is");
    }
    bridge_.emplace(context.node, context.log, place.address, generation);
    // the bridge has opened another discovery socket
    filterDiscovery(place.isOpen);
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

  /// Warns of a partition or address that these clients do not read.
  static void warnOfOtherNames(Generation generation, const Logger& log) {
    for (const GazeboVariable& variable : {gazebo::kPartition, gazebo::kIp}) {
      const std::string read = nameFor(variable, generation);
      const std::string other = nameFor(variable, generation == Generation::kIgn ? Generation::kGz : Generation::kIgn);
      if (std::getenv(other.c_str()) == nullptr || std::getenv(read.c_str()) != nullptr) continue;
      log.warning(other + " has no effect, since these clients read " + read);
    }
  }

  std::string names_ = "ign";
  std::optional<Bridge> bridge_;
};

}  // namespace

}  // namespace pongsim::ign

PONGSIM_EXPORT_SYSTEM(pongsim::ign::Ign, "pongsim::systems::Ign");
