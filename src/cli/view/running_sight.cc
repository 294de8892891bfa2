#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <utility>

#include "cli/files/diagnostic_report.hh"
#include "cli/look_around.hh"
#include "cli/stop_signal.hh"
#include "cli/view/view_command.hh"
#include "cli/world/world_finder.hh"
#include "cli/world/world_state.hh"
#include "msgs/control/status_messages.hh"
#include "msgs/scene/marker_message.hh"
#include "msgs/state/visible_world.hh"
#include "pongsim/node.hh"
#include "rendering/renderer.hh"
#include "rendering/renderer_choice.hh"
#include "rendering/scene.hh"
#include "world/actor_motion.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::cli {

namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kMarkerList = "/marker/list";

/// A world at the time of a message.
struct Snapshot {
  /// @param step See `msgs::visibleWorld`.
  Snapshot(const Message& step, Diagnostics& missing)
      : description(msgs::visibleWorld(step, missing)), entities(description), state(entities) {
    // at which actors are placed
    state.time = msgs::statusOfState(step).simulated;
  }

  description::World description;
  world::Entities entities;
  world::State state;
};

class RunningSight final : public Sight {
 public:
  RunningSight(std::unique_ptr<Transport> transport, std::string world, std::chrono::nanoseconds timeout)
      : transport_(std::move(transport)), world_(std::move(world)), timeout_(timeout) {
    for (const ServiceInfo& service : servicesAround(*transport_)) hasMarkers_ |= service.name == kMarkerList;
  }

  /// Asks for what is there now.
  /// @return Whether there was an answer.
  bool look() {
    MessagePointer answer = askForState(*transport_, world_, timeout_, answer_ != nullptr);
    if (answer == nullptr) return false;
    Diagnostics missing;
    now_ = std::make_unique<Snapshot>(*answer, missing);
    if (stage_ == nullptr || !msgs::haveSameLooks(*answer, *answer_)) {
      stage_ = std::make_unique<Stage>(*now_, missing);
      // what is in the scene refers to it
      built_ = std::move(now_);
      now_ = std::make_unique<Snapshot>(*answer, missing);
      sayNew(missing);
    }
    stage_->scene.update(now_->entities, now_->state);
    stage_->scene.show(markers(), now_->entities, now_->state);
    answer_ = std::move(answer);
    return true;
  }

  std::vector<std::string> names() override {
    std::vector<std::string> names;
    for (const world::ModelRecord& model : now_->entities.models()) names.push_back(model.scopedName);
    for (const world::ActorRecord& actor : now_->entities.actors()) names.push_back(actor.description->name);
    return names;
  }

  Eigen::AlignedBox3d bounds(const std::string& name) override {
    if (name.empty()) return stage_->scene.bounds(now_->entities, world::kNoSlot);
    const world::Slot model = now_->entities.findModel(name);
    return model != world::kNoSlot ? stage_->scene.bounds(now_->entities, model) : stage_->scene.actorBounds(name);
  }

  std::optional<Vector3> position(const std::string& name) override {
    const world::Slot model = now_->entities.findModel(name);
    if (model != world::kNoSlot) return world::modelPose(now_->entities, now_->state, model).position;
    for (const world::ActorRecord& actor : now_->entities.actors()) {
      if (actor.description->name == name) return world::actorPose(*actor.description, now_->state).position;
    }
    return std::nullopt;
  }

  std::optional<Time> advance(Time time) override {
    for (auto left = start_ + time - Clock::now(); left > Clock::duration(0); left = start_ + time - Clock::now()) {
      transport_->dispatchFor(left);
    }
    const Time reached = Clock::now() - start_;
    return look() ? std::optional(reached) : std::nullopt;
  }

  void drawColors(const PictureView& view, std::span<std::uint8_t> pixels) override {
    stage_->renderer.drawColors(stage_->scene, view, pixels);
  }
  void drawDepths(const PictureView& view, std::span<float> depths) override {
    stage_->renderer.drawDepths(stage_->scene, view, depths);
  }
  void drawTemperatures(const PictureView& view, std::span<float> temperatures) override {
    const auto air = rendering::airTemperatures(now_->description.environment.atmosphere, view);
    stage_->renderer.drawTemperatures(stage_->scene, view, air, temperatures);
  }
  void drawNumbers(const PictureView& view, std::span<std::uint32_t> numbers) override {
    stage_->renderer.drawNumbers(stage_->scene, view, numbers);
  }
  std::span<const SeenVisual> visuals() override { return stage_->scene.visuals(); }

 private:
  /// What draws, until something looks different.
  struct Stage {
    Stage(const Snapshot& snapshot, Diagnostics& found) : renderer(rendering::openContexts()) {
      scene.build(snapshot.entities, snapshot.state, found);
    }

    rendering::Scene scene;
    rendering::Renderer renderer;
  };

  /// @return The markers that the world's page shows; none if it has no page.
  rendering::MarkerList markers() {
    if (!hasMarkers_) return {};
    const MessagePointer request = newMessage("ignition.msgs.Empty"), reply = newMessage("ignition.msgs.Marker_V");
    rendering::MarkerList list;
    // all worlds' services have this name
    if (!transport_->node().call(kMarkerList, *request, *reply, timeout_) || msgs::worldOfMarkers(*reply) != world_) {
      return list;
    }
    world::Markers told;
    for (const Message* message : msgs::markersIn(*reply)) {
      const Outcome<world::MarkerChange> change = msgs::markerChange(*message);
      if (change) told.apply(*change.value, now_->state.time);
    }
    for (const auto& [key, marker] : told.all()) list.push_back(marker);
    return list;
  }

  void sayNew(const Diagnostics& found) {
    Diagnostics unsaid;
    for (const Diagnostic& each : found.all()) {
      if (said_.insert(each.message).second) unsaid.add(each);
    }
    say(unsaid, Severity::kWarning, Severity::kError);
  }

  std::unique_ptr<Transport> transport_;
  std::string world_;
  std::chrono::nanoseconds timeout_;
  bool hasMarkers_ = false;
  Clock::time_point start_ = Clock::now();
  MessagePointer answer_;
  std::unique_ptr<Snapshot> built_, now_;
  std::unique_ptr<Stage> stage_;
  std::set<std::string> said_;
};

}  // namespace

std::unique_ptr<Sight> sightOfRunningWorld(const ViewOptions& options) {
  // before the transport, whose threads inherit the signal mask
  const StopSignal signal;
  auto transport = std::make_unique<Transport>();
  const std::optional<std::string> world = findWorld(*transport, signal, options.world, options.timeout);
  if (!world) return nullptr;
  auto sight = std::make_unique<RunningSight>(std::move(transport), *world, options.timeout);
  return sight->look() ? std::move(sight) : nullptr;
}

}  // namespace pongsim::cli
