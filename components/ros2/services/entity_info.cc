#include "ros2/services/entity_info.hh"

#include <algorithm>

#include "pongsim/scene.hh"
#include "pongsim/sensing/sensor.hh"

namespace pongsim::ros2 {

namespace si = simulation_interfaces;
using Category = si::EntityCategory;

namespace {

/// @return Whether it has a movable joint or a sensor.
bool movesOrSenses(const Model& model) {
  return std::ranges::any_of(model.joints(), [](const Joint& joint) { return joint.axisCount() > 0; }) ||
         std::ranges::any_of(model.links(), [](const Link& link) { return !link.sensors().empty(); }) ||
         std::ranges::any_of(model.models(), [](const Model& each) { return movesOrSenses(each); });
}

std::uint8_t categoryOf(const Model& model) {
  if (model.isStatic()) return Category::kCategoryStaticObject;
  return movesOrSenses(model) ? Category::kCategoryRobot : Category::kCategoryObject;
}

bool isKnown(std::uint8_t category) {
  return category == Category::kCategoryObject || category == Category::kCategoryRobot ||
         category == Category::kCategoryHuman || category == Category::kCategoryDynamicObject ||
         category == Category::kCategoryStaticObject;
}

}  // namespace

si::EntityInfo EntityInfos::of(const World& world, const Model& model) const {
  if (const auto found = set_.find(model.id().value); found != set_.end()) return found->second;
  const Semantics& semantics = Scene(world).semantics(model.id());
  return {{semantics.category ? *semantics.category : categoryOf(model)}, semantics.description, semantics.tags};
}

Result EntityInfos::set(const Model& model, const si::EntityInfo& info) {
  if (!isKnown(info.category.category)) {
    return failed("there is no category " + std::to_string(info.category.category) + ": 0, 1, 2, 4 and 5 are some");
  }
  set_[model.id().value] = info;
  return succeeded();
}

void EntityInfos::sweep(const World& world) {
  std::erase_if(set_, [&](const auto& each) {
    const ModelId id{each.first};
    return !world.model(id);
  });
}

bool matches(const si::TagsFilter& filter, const std::vector<std::string>& tags) {
  if (filter.tags.empty()) return true;
  const auto has = [&](const std::string& tag) { return std::ranges::find(tags, tag) != tags.end(); };
  return filter.filter_mode == si::TagsFilter::kFilterModeAll ? std::ranges::all_of(filter.tags, has)
                                                              : std::ranges::any_of(filter.tags, has);
}

std::optional<std::string> filterError(const si::TagsFilter& filter) {
  if (filter.filter_mode <= si::TagsFilter::kFilterModeAll) return std::nullopt;
  return "there is no filter mode " + std::to_string(filter.filter_mode) + ": 0 is any tag, 1 is all";
}

}  // namespace pongsim::ros2
