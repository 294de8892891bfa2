#include "log/playback/recorded_state.hh"

#include <ignition/msgs/double_v.pb.h>
#include <ignition/msgs/serialized.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "pongsim/components.hh"

namespace pongsim::log {

namespace im = ignition::msgs;

namespace {

// no world contains what is farther away [m]
constexpr double kFarthest = 1e9;

}  // namespace

void RecordedState::clear() {
  entities_.clear();
  changed_.clear();
  hasNews_ = true;
}

void RecordedState::remove(std::uint64_t entity) {
  if (entities_.erase(entity) > 0) hasNews_ = true;
  changed_.erase(entity);
}

void RecordedState::set(std::uint64_t entity, const im::SerializedComponent& component) {
  const auto [known, isNew] = entities_.try_emplace(entity);
  if (isNew) hasNews_ = true;
  changed_.insert(entity);
  if (component.remove()) {
    known->second.erase(component.type());
  } else {
    known->second[component.type()] = component.component();
  }
}

bool RecordedState::apply(std::string_view type, std::string_view payload) {
  const auto size = static_cast<int>(payload.size());
  if (type == "ignition.msgs.SerializedStateMap") {
    im::SerializedStateMap message;
    if (!message.ParseFromArray(payload.data(), size)) return false;
    for (const auto& [id, entity] : message.entities()) {
      if (entity.remove()) {
        remove(id);
        continue;
      }
      for (const auto& [key, component] : entity.components()) set(id, component);
    }
    return true;
  }
  im::SerializedState message;
  if (!message.ParseFromArray(payload.data(), size)) return false;
  for (const im::SerializedEntity& entity : message.entities()) {
    if (entity.remove()) {
      remove(entity.id());
      continue;
    }
    for (const im::SerializedComponent& component : entity.components()) set(entity.id(), component);
  }
  return true;
}

bool RecordedState::takeNews() { return std::exchange(hasNews_, false); }

std::unordered_set<std::uint64_t> RecordedState::takeChanged() { return std::exchange(changed_, {}); }

std::vector<std::uint64_t> RecordedState::entitiesWith(std::string_view component) const {
  const std::uint64_t type = componentType(component);
  std::vector<std::uint64_t> ids;
  for (const auto& [id, components] : entities_) {
    if (components.contains(type)) ids.push_back(id);
  }
  std::ranges::sort(ids);
  return ids;
}

std::vector<std::uint64_t> RecordedState::childrenWith(std::uint64_t parent, std::string_view component) const {
  std::vector<std::uint64_t> ids = entitiesWith(component);
  std::erase_if(ids, [&](std::uint64_t id) { return parentOf(id) != parent; });
  return ids;
}

const std::string* RecordedState::find(std::uint64_t entity, std::string_view component) const {
  const auto known = entities_.find(entity);
  if (known == entities_.end()) return nullptr;
  const auto found = known->second.find(componentType(component));
  return found == known->second.end() ? nullptr : &found->second;
}

std::string RecordedState::text(std::uint64_t entity, std::string_view component) const {
  const std::string* const bytes = find(entity, component);
  return bytes == nullptr ? std::string() : *bytes;
}

std::uint64_t RecordedState::parentOf(std::uint64_t entity) const {
  const std::string parent = text(entity, "ParentEntity");
  std::uint64_t id = 0;
  std::from_chars(parent.data(), parent.data() + parent.size(), id);
  return id;
}

Pose RecordedState::poseOf(std::uint64_t entity) const {
  const std::string* const bytes = find(entity, "Pose");
  const Pose pose = bytes == nullptr ? Pose() : componentPose(*bytes).value_or(Pose());
  const bool isSound = pose.position.cwiseAbs().maxCoeff() <= kFarthest && pose.rotation.coeffs().allFinite();
  return isSound && pose.position.allFinite() ? pose : Pose();
}

std::vector<double> RecordedState::numbersOf(std::uint64_t entity, std::string_view component) const {
  const std::string* const bytes = find(entity, component);
  im::Double_V message;
  if (bytes == nullptr || !message.ParseFromString(*bytes)) return {};
  return {message.data().begin(), message.data().end()};
}

std::string RecordedState::scopedName(std::uint64_t entity) const {
  std::string name = text(entity, "Name");
  // a damaged log may contain a cycle
  int depth = 0;
  for (std::uint64_t parent = parentOf(entity); find(parent, "Model") != nullptr && depth < 100; ++depth) {
    name.insert(0, text(parent, "Name") + "::");
    parent = parentOf(parent);
  }
  return name;
}

}  // namespace pongsim::log
