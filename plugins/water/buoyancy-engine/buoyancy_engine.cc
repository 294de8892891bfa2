#include <ignition/msgs/double.pb.h>

#include <algorithm>
#include <optional>
#include <string>

#include "pongsim/commands.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

/// Controls the buoyancy of a link by pumping oil into and out of an external bladder.
class BuoyancyEngine : public System {
 public:
  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override;

  void reset() override { volume_ = target_ = startVolume_; }

  void transfer(StateArchive& archive) override {
    archive(volume_);
    archive(target_);
  }

 private:
  void checkVolumes(const SystemContext& context);

  std::string linkName_;
  std::string namespace_;
  double leastVolume_ = 3e-5;
  double mostVolume_ = 9.9e-4;
  double neutralVolume_ = 3e-4;
  std::optional<double> defaultVolume_;
  double mostRate_ = 3e-6;
  double density_ = 1000;
  std::optional<double> surface_;

  World* world_ = nullptr;
  std::optional<Link> link_;
  double startVolume_ = 0;
  /// Current and desired volume of the bladder [m^3].
  double volume_ = 0;
  double target_ = 0;

  Subscription targets_;
  Publisher volumes_;
  ignition::msgs::Double message_;
};

void BuoyancyEngine::declare(Declaration& declaration) {
  declaration.is("Controls the buoyancy of a link by pumping oil into and out of an external bladder.",
                 Declaration::Place::kModel);
  declaration.parameter("link_name", &linkName_, "", "link with the bladder").required();
  declaration.parameter("namespace", &namespace_, "", "topics begin with `/model/NAMESPACE`").otherwise("none");
  declaration.parameter("min_volume", &leastVolume_, "m^3", "minimum volume of the bladder").atLeast(0);
  declaration.parameter("neutral_volume", &neutralVolume_, "m^3", "neutral volume").atLeast(0);
  declaration.parameter("default_volume", &defaultVolume_, "m^3", "volume at the start")
      .atLeast(0)
      .otherwise("min_volume");
  declaration.parameter("max_volume", &mostVolume_, "m^3", "maximum volume").atLeast(0);
  declaration.parameter("max_inflation_rate", &mostRate_, "m^3/s", "pump rate").atLeast(0);
  declaration.parameter("fluid_density", &density_, "kg/m^3", "density of the fluid").above(0);
  declaration.parameter("surface", &surface_, "m", "height above which there is no fluid").otherwise("none");
  declaration.subscribes("/buoyancy_engine", "ignition.msgs.Double",
                         "desired volume [m^3]; with `<namespace>`, "
                         "`/model/NAMESPACE/buoyancy_engine`");
  declaration.publishes("/buoyancy_engine/current_volume", "ignition.msgs.Double",
                        "volume of the bladder [m^3], every step; with `<namespace>`, likewise");
}

void BuoyancyEngine::configure(const SystemContext& context) {
  world_ = &context.world;
  link_ = requiredLink(context.sdf, "link_name", *context.model);
  checkVolumes(context);
  startVolume_ = defaultVolume_.value_or(leastVolume_);
  volume_ = target_ = startVolume_;
  const std::string topic = (namespace_.empty() ? "" : "/model/" + namespace_) + "/buoyancy_engine";
  targets_ = context.node.subscribe<ignition::msgs::Double>(
      cleanTopic(topic),
      [this](const ignition::msgs::Double& message) {
        target_ = std::clamp(message.data(), leastVolume_, mostVolume_);
      },
      kCommands);
  volumes_ = context.node.advertise<ignition::msgs::Double>(cleanTopic(topic + "/current_volume"));
}

void BuoyancyEngine::checkVolumes(const SystemContext& context) {
  const Element& sdf = context.sdf;
  if (mostVolume_ < leastVolume_) {
    const Element* element = sdf.child("max_volume");
    refuse(element != nullptr ? *element : sdf, "<max_volume> is below <min_volume>");
  }
  if (defaultVolume_ && (*defaultVolume_ < leastVolume_ || *defaultVolume_ > mostVolume_)) {
    context.diagnostics.warning(sdf.child("default_volume")->position,
                                "<default_volume> is not between <min_volume> and <max_volume>");
  }
}

void BuoyancyEngine::preUpdate(const StepInfo& info) {
  if (info.paused) return;
  const double most = toSeconds(info.dt) * mostRate_;
  volume_ += std::clamp(target_ - volume_, -most, most);
  if (volumes_.hasSubscribers()) {
    message_.set_data(volume_);
    volumes_.publish(message_);
  }
  // the oil comes from inside the hull, so its weight is part of the link's
  const bool isInFluid = !surface_ || link_->pose().position.z() < *surface_;
  const double mass = (isInFluid ? density_ * volume_ : 0) - density_ * neutralVolume_;
  link_->addWrench(-mass * world_->gravity(), Vector3::Zero());
}

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::BuoyancyEngine, "ignition::gazebo::systems::BuoyancyEngine",
                      "gz::sim::systems::BuoyancyEngine");
