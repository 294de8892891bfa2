#include <optional>
#include <utility>

#include "cli/files/diagnostic_report.hh"
#include "cli/stop_signal.hh"
#include "cli/view/view_command.hh"
#include "cli/world/world_finder.hh"
#include "cli/world/world_state.hh"
#include "msgs/control/status_messages.hh"
#include "msgs/state/visible_world.hh"
#include "pongsim/node.hh"
#include "rendering/osmesa.hh"
#include "rendering/renderer.hh"
#include "rendering/scene.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::cli {

namespace {

class RunningSight final : public Sight {
 public:
  /// @param time At which actors are placed.
  RunningSight(description::World world, Time time)
      : world_(std::move(world)), entities_(world_), state_(entities_), renderer_(rendering::openOsmesa()) {
    state_.time = time;
    Diagnostics found;
    scene_.build(entities_, state_, found);
    say(found, Severity::kWarning, Severity::kError);
  }

  std::vector<std::string> names() override {
    std::vector<std::string> names;
    for (const world::ModelRecord& model : entities_.models()) names.push_back(model.scopedName);
    for (const world::ActorRecord& actor : entities_.actors()) names.push_back(actor.description->name);
    return names;
  }

  Eigen::AlignedBox3d bounds(const std::string& name) override {
    if (name.empty()) return scene_.bounds(entities_, world::kNoSlot);
    const world::Slot model = entities_.findModel(name);
    return model != world::kNoSlot ? scene_.bounds(entities_, model) : scene_.actorBounds(name);
  }

  void draw(const PictureView& view, std::span<std::uint8_t> pixels) override {
    renderer_.drawColors(scene_, view, pixels);
  }

 private:
  const description::World world_;
  const world::Entities entities_;
  world::State state_;
  rendering::Scene scene_;
  rendering::Renderer renderer_;
};

MessagePointer stateOf(const ViewOptions& options) {
  // before the transport, whose threads inherit the signal mask
  const StopSignal signal;
  Transport transport;
  const std::optional<std::string> world = findWorld(transport, signal, options.world, options.timeout);
  return world ? askForState(transport, *world, options.timeout) : nullptr;
}

}  // namespace

std::unique_ptr<Sight> sightOfRunningWorld(const ViewOptions& options) {
  const MessagePointer state = stateOf(options);
  if (state == nullptr) return nullptr;
  Diagnostics missing;
  description::World world = msgs::visibleWorld(*state, missing);
  say(missing, Severity::kWarning, Severity::kError);
  return std::make_unique<RunningSight>(std::move(world), msgs::statusOfState(*state).simulated);
}

}  // namespace pongsim::cli
