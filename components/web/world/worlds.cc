#include "web/world/worlds.hh"

#include <algorithm>
#include <tuple>
#include <utility>

namespace pongsim::web {

namespace {

template <class Named>
std::string_view nameOf(const Named& named) {
  return named.name;
}

}  // namespace

std::shared_ptr<void> Worlds::watch(Watch watch) {
  auto shared = std::make_shared<const Watch>(std::move(watch));
  {
    const std::lock_guard lock(watching_);
    watches_.push_back(shared);
    watchCount_ = static_cast<int>(watches_.size());
  }
  // lists are only updated while there are watches
  for (const auto& world : all()) world->changed();
  return {this, [worlds = shared_from_this(), shared](void*) {
            const std::lock_guard lock(worlds->watching_);
            std::erase(worlds->watches_, shared);
            worlds->watchCount_ = static_cast<int>(worlds->watches_.size());
          }};
}

std::vector<std::shared_ptr<WorldLink>> Worlds::all() const {
  const std::lock_guard lock(mutex_);
  return worlds_;
}

bool Worlds::areListsKnown() const {
  return std::ranges::all_of(all(), [](const auto& world) { return world->areListsKnown(); });
}

std::shared_ptr<WorldLink> Worlds::find(std::string_view world) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(worlds_, world, [](const auto& each) { return each->world(); });
  return found == worlds_.end() ? nullptr : *found;
}

std::vector<Worlds::TopicPlace> Worlds::topics() const {
  std::vector<TopicPlace> places;
  for (const auto& world : all()) {
    for (const Topic& topic : world->lists()->topics) places.push_back({world, topic});
  }
  std::ranges::stable_sort(places, {}, [](const TopicPlace& place) {
    return std::make_tuple(std::string_view(place.topic.name), place.topic.publishers == 0);
  });
  const auto twice = std::ranges::unique(places, {}, [](const TopicPlace& place) { return place.topic.name; });
  places.erase(twice.begin(), twice.end());
  return places;
}

std::vector<Worlds::ServicePlace> Worlds::services() const {
  std::vector<ServicePlace> places;
  for (const auto& world : all()) {
    for (const OwnService& service : world->lists()->services) places.push_back({world, service});
  }
  const auto name = [](const ServicePlace& place) { return place.service.name; };
  std::ranges::stable_sort(places, {}, name);
  const auto twice = std::ranges::unique(places, {}, name);
  places.erase(twice.begin(), twice.end());
  return places;
}

std::optional<Worlds::TopicPlace> Worlds::findTopic(std::string_view name) const {
  std::optional<TopicPlace> found;
  for (const auto& world : all()) {
    const auto lists = world->lists();
    for (auto each = std::ranges::lower_bound(lists->topics, name, {}, nameOf<Topic>);
         each != lists->topics.end() && each->name == name; ++each) {
      if (each->publishers > 0) return TopicPlace{world, *each};
      if (!found) found = TopicPlace{world, *each};
    }
  }
  return found;
}

std::optional<Worlds::ServicePlace> Worlds::findService(std::string_view name) const {
  for (const auto& world : all()) {
    const auto lists = world->lists();
    const auto each = std::ranges::lower_bound(lists->services, name, {}, nameOf<OwnService>);
    if (each != lists->services.end() && each->name == name) return ServicePlace{world, *each};
  }
  return std::nullopt;
}

void Worlds::add(std::shared_ptr<WorldLink> world) {
  {
    const std::lock_guard lock(mutex_);
    worlds_.push_back(std::move(world));
  }
  changed();
}

void Worlds::remove(const WorldLink& world) {
  {
    const std::lock_guard lock(mutex_);
    std::erase_if(worlds_, [&](const auto& each) { return each.get() == &world; });
  }
  changed();
}

void Worlds::changed() {
  const std::lock_guard lock(watching_);
  for (const auto& watch : watches_) watch->changed();
}

}  // namespace pongsim::web
