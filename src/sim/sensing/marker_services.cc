#include "pongsim/sensing/marker_services.hh"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "msgs/control/control_messages.hh"
#include "msgs/fields/number_check.hh"
#include "msgs/scene/marker_message.hh"
#include "pongsim/message.hh"
#include "pongsim/scene.hh"
#include "pongsim/service.hh"
#include "rendering/placed_markers.hh"
#include "sim/api/access.hh"

namespace pongsim {

namespace {

constexpr const char* kMarker = "ignition.msgs.Marker";
constexpr const char* kMarkers = "ignition.msgs.Marker_V";

/// Farther than anything can be seen [m]; also for scales and colours.
constexpr double kFarthest = 1e9;

constexpr auto kAdd = world::MarkerChange::Action::kAddOrModify;

/// A program may send the same nonsense with each step.
constexpr std::size_t kMostComplaints = 20;

std::string markerService(MarkerViewers viewers) {
  return viewers == MarkerViewers::kSensors ? "/sensors/marker" : "/marker";
}

}  // namespace

struct MarkerServices::Content {
  sim::Access& access;
  world::Markers& markers;
  const Logger* log;
  Publisher changes = {};
  std::vector<Service> services = {};
  std::set<std::string> complaints = {};

  /// Says why if it is refused.
  Outcome<void> change(const Message& message) {
    Outcome<void> done = tryTo(message);
    if (!done && complaints.size() < kMostComplaints && complaints.insert(done.error).second) log->warning(done.error);
    return done;
  }

  ServiceAnswer changeAll(const Message& messages) {
    std::string refused;
    std::size_t number = 0, refusals = 0;
    for (const Message* message : msgs::markersIn(messages)) {
      ++number;
      const Outcome<void> done = change(*message);
      if (!done && refusals++ == 0) refused = "number " + std::to_string(number) + ": " + done.error;
    }
    if (refusals == 0) return true;
    if (refusals > 1) refused += "; and " + std::to_string(refusals - 1) + " others";
    return ServiceAnswer::refused(refused);
  }

  void advance(Time now) {
    const std::vector<world::Markers::Key> gone = markers.advance(now);
    if (gone.empty() || !changes || !changes.hasSubscribers()) return;
    for (const world::Markers::Key& key : gone) {
      const MessagePointer told = newMessage(kMarker);
      msgs::setMarkerRemoval(key, false, *told);
      publish(*told);
    }
  }

  void list(Message& reply) const {
    msgs::setWorldOfMarkers(world(), reply);
    for (const auto& [key, marker] : markers.all()) {
      msgs::setMarker(key, *marker, access.state.time, msgs::addMarker(reply));
    }
  }

 private:
  std::string world() const { return cleanTopic(access.entities.description().name); }

  void publish(Message& told) {
    msgs::setWorldOfMarker(world(), told);
    changes.publish(told);
  }

  Outcome<void> tryTo(const Message& message) {
    if (const auto fault = msgs::unusableNumber(message, kFarthest)) return {"a marker's " + *fault};
    const Outcome<world::MarkerChange> asked = msgs::markerChange(message);
    if (!asked) return {asked.error};
    const std::string& parent = asked.value->parent;
    // before they are quoted
    if (std::max(parent.size(), asked.value->space.size()) > world::Markers::kLongestText) {
      return {"a marker's name space or parent has more than " + std::to_string(world::Markers::kLongestText) +
              " characters"};
    }
    if (asked.value->action == kAdd && !rendering::markerParentPose(parent, access.entities, access.state)) {
      return {"marker " + std::to_string(asked.value->id) + " has the parent '" + parent +
              "', but there is no such model, link (MODEL::LINK) or visual (MODEL::LINK::VISUAL)"};
    }
    const Outcome<world::Markers::Key> done = markers.apply(*asked.value, access.state.time);
    if (!done) return {done.error};
    tell(asked.value->action, *done.value);
    return {};
  }

  /// Publishes what has become of a marker.
  void tell(world::MarkerChange::Action action, const world::Markers::Key& key) {
    if (!changes || !changes.hasSubscribers()) return;
    const MessagePointer told = newMessage(kMarker);
    if (action == kAdd) {
      msgs::setMarker(key, *markers.all().at(key), access.state.time, *told);
    } else {
      msgs::setMarkerRemoval(key, action == world::MarkerChange::Action::kDeleteAll, *told);
    }
    publish(*told);
  }
};

MarkerServices::MarkerServices(const World& world, Node& node, const Logger& log, MarkerViewers viewers) {
  sim::Access& access = *Scene(world).access_;
  const bool isForSensors = viewers == MarkerViewers::kSensors;
  content_.reset(new Content{access, isForSensors ? access.sensorMarkers : access.peopleMarkers, &log});
  const std::string name = markerService(viewers);
  if (!isForSensors) content_->changes = node.advertise(name, kMarker);
  Content* const content = content_.get();
  // without an answer, as in Fortress
  content_->services.push_back(
      node.serve(name, kMarker, "ignition.msgs.Empty", [content](const Message& asked, Message&) {
        const Outcome<void> done = content->change(asked);
        return done ? ServiceAnswer(true) : ServiceAnswer::refused(done.error);
      }));
  content_->services.push_back(
      node.serve(name + "_array", kMarkers, "ignition.msgs.Boolean", [content](const Message& asked, Message& reply) {
        msgs::setBoolean(true, reply);
        return content->changeAll(asked);
      }));
  content_->services.push_back(
      node.serve(name + "/list", "ignition.msgs.Empty", kMarkers, [content](const Message&, Message& reply) {
        content->list(reply);
        return true;
      }));
}

MarkerServices::~MarkerServices() = default;
MarkerServices::MarkerServices(MarkerServices&&) noexcept = default;
MarkerServices& MarkerServices::operator=(MarkerServices&&) noexcept = default;

void MarkerServices::declare(Declaration& declaration, MarkerViewers viewers) {
  const std::string name = markerService(viewers);
  const bool isForSensors = viewers == MarkerViewers::kSensors;
  const std::string whom = isForSensors ? "colour and depth cameras" : "pages and `pongsim view`";
  declaration.serves(name, kMarker, "ignition.msgs.Empty", "adds, changes or removes a marker for " + whom);
  declaration.serves(name + "_array", kMarkers, "ignition.msgs.Boolean", "the same for several markers");
  declaration.serves(name + "/list", "ignition.msgs.Empty", kMarkers, "all of these markers");
  if (!isForSensors) declaration.publishes(name, kMarker, "each marker that is added, changed or removed");
}

void MarkerServices::update(Time now) { content_->advance(now); }

}  // namespace pongsim
