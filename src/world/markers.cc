#include "world/markers.hh"

#include <algorithm>
#include <iterator>

namespace pongsim::world {

namespace {

std::string nameOf(const Markers::Key& key) {
  return "marker " + std::to_string(key.second) + " of the name space '" + key.first + "'";
}

/// @return How many points count towards the limit.
std::size_t pointsOf(const Marker& marker) {
  return marker.points.size() + Markers::kPointsOfLetter * marker.text.size();
}

}  // namespace

Outcome<Markers::Key> Markers::apply(const MarkerChange& change, Time now) {
  return change.action == MarkerChange::Action::kAddOrModify ? add(change, now) : remove(change);
}

Outcome<Markers::Key> Markers::add(const MarkerChange& change, Time now) {
  Key key(change.space, change.id);
  while (key.second == 0 || (change.id == 0 && all_.contains(key))) key.second = nextId_++;
  const auto known = all_.find(key);
  const Marker old = known == all_.end() ? Marker() : *known->second;
  if (known == all_.end() && all_.size() >= kMost) {
    return {std::nullopt, "there are " + std::to_string(kMost) + " markers already, the most that a world may have"};
  }
  for (const std::string* text : {&change.space, &change.text, &change.parent}) {
    if (text->size() > kLongestText) {
      return {std::nullopt, "a text of " + nameOf({"...", key.second}) + " has more than " +
                                std::to_string(kLongestText) + " characters"};
    }
  }
  auto marker = std::make_shared<Marker>(old);
  if (change.type != Marker::Type::kNone) marker->type = change.type;
  if (marker->type == Marker::Type::kNone) return {std::nullopt, nameOf(key) + " has no type"};
  if (!change.points.empty()) marker->points = change.points;
  if (!change.text.empty()) marker->text = change.text;
  const std::size_t points = points_ - pointsOf(old) + pointsOf(*marker);
  if (points > kMostPoints) {
    return {std::nullopt, nameOf(key) + " has too many points or letters: all markers of a world together may have " +
                              std::to_string(kMostPoints)};
  }
  marker->X_ParentMarker = change.pose.value_or(old.X_ParentMarker);
  marker->scale = change.scale.value_or(old.scale);
  marker->color = change.color.value_or(old.color);
  if (!change.parent.empty()) marker->parent = change.parent;
  marker->isForAll = change.isForAll;
  marker->layer = change.layer;
  marker->end.reset();
  if (change.lifetime != Time(0) && change.lifetime <= Time::max() - now) {
    marker->end = now + change.lifetime;
    firstEnd_ = std::min(firstEnd_, *marker->end);
  }
  points_ = points;
  all_[key] = std::move(marker);
  ++version_;
  return {key, {}};
}

Outcome<Markers::Key> Markers::remove(const MarkerChange& change) {
  const Key key(change.space, change.id);
  const bool isOne = change.action == MarkerChange::Action::kDelete;
  const auto begin =
      isOne || !change.space.empty() ? all_.lower_bound({change.space, isOne ? change.id : 0}) : all_.begin();
  auto end = begin;
  while (end != all_.end() && (isOne ? end->first == key : change.space.empty() || end->first.first == change.space)) {
    ++end;
  }
  if (begin == end && isOne) return {std::nullopt, "there is no " + nameOf(key)};
  if (begin == end && !change.space.empty()) {
    return {std::nullopt, "there are no markers of the name space '" + change.space + "'"};
  }
  for (auto each = begin; each != end;) erase(each++);
  return {key, {}};
}

std::vector<Markers::Key> Markers::advance(Time now) {
  const bool goesBack = now < last_;
  last_ = now;
  std::vector<Key> gone;
  if (!goesBack && now < firstEnd_) return gone;
  firstEnd_ = Time::max();
  for (auto each = all_.begin(); each != all_.end();) {
    const auto marker = each++;
    if (!marker->second->end) continue;
    if (goesBack || *marker->second->end <= now) {
      gone.push_back(marker->first);
      erase(marker);
    } else {
      firstEnd_ = std::min(firstEnd_, *marker->second->end);
    }
  }
  return gone;
}

void Markers::erase(Map::const_iterator marker) {
  points_ -= pointsOf(*marker->second);
  all_.erase(marker);
  ++version_;
}

}  // namespace pongsim::world
