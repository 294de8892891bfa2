#include "physics/islands/neighbourhoods.hh"

#include <algorithm>

namespace pongsim::physics {

void Neighbourhoods::form(std::size_t bodies, std::span<const Islands::Ends> pairs,
                          std::span<const Islands::Ends> joints, std::size_t batches) {
  islands_.form(bodies, pairs, joints);
  bodies_.clear();
  pairs_.clear();
  joints_.clear();
  places_.resize(bodies);
  starts_.assign(1, end());
  const std::size_t full = fullBatch(batches);
  const auto sizeOfLast = [this] {
    const Start& start = starts_.back();
    return bodies_.size() - start.bodies + pairs_.size() - start.pairs + joints_.size() - start.joints;
  };
  for (std::size_t island = 0; island < islands_.count(); ++island) {
    if (isCrowd(island)) continue;
    add(island);
    if (sizeOfLast() >= full) starts_.push_back(end());
  }
  if (sizeOfLast() > 0) starts_.push_back(end());
  for (std::size_t island = 0; island < islands_.count(); ++island) {
    if (isCrowd(island)) add(island);
  }
  starts_.push_back(end());
}

Neighbourhoods::Members Neighbourhoods::batch(std::size_t number) const {
  if (starts_.empty()) return {};
  const Start &start = starts_[number], &end = starts_[number + 1];
  return {std::span(bodies_).subspan(start.bodies, end.bodies - start.bodies),
          std::span(pairs_).subspan(start.pairs, end.pairs - start.pairs),
          std::span(joints_).subspan(start.joints, end.joints - start.joints)};
}

std::size_t Neighbourhoods::fullBatch(std::size_t batches) const {
  std::size_t total = 0;
  for (std::size_t island = 0; island < islands_.count(); ++island) {
    if (isCrowd(island)) continue;
    total += islands_.bodies(island).size() + islands_.touches(island).size() + islands_.joints(island).size();
  }
  return std::min(kFullBatch, total / batches);
}

// behind what the last batch has
void Neighbourhoods::add(std::size_t island) {
  const auto append = [](std::vector<std::uint32_t>& all, std::span<const std::uint32_t> more) {
    all.insert(all.end(), more.begin(), more.end());
  };
  int place = static_cast<int>(bodies_.size() - starts_.back().bodies);
  for (const std::uint32_t body : islands_.bodies(island)) places_[body] = place++;
  append(bodies_, islands_.bodies(island));
  append(pairs_, islands_.touches(island));
  append(joints_, islands_.joints(island));
}

}  // namespace pongsim::physics
