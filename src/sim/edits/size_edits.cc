#include "sim/edits/size_edits.hh"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "description/limits.hh"
#include "description/size.hh"
#include "sim/edits/stretched_mass.hh"

namespace pongsim::sim {

namespace {

using description::Geometry;
using description::sizeOf;

// of a shape [m]
constexpr double kLeastLength = 1e-6;

bool isLength(double number) { return number >= kLeastLength && number <= description::kLargestPosition; }

/// @param what "collision 'c'"
Outcome<void> checkSize(const std::string& what, const Geometry& geometry, std::span<const double> size) {
  const std::size_t count = sizeOf(geometry).size();
  if (count == 0) {
    return {what + " has no size that can be changed: it is no box, sphere, cylinder, capsule or ellipsoid"};
  }
  std::ostringstream text;
  if (size.size() != count) {
    text << "the size of " << what << " has " << count << (count == 1 ? " number" : " numbers") << ", not "
         << size.size();
    return {text.str()};
  }
  for (const double number : size) {
    if (isLength(number)) continue;
    text << "the size of " << what << " must be " << kLeastLength << " m to " << description::kLargestPosition
         << " m, not " << number;
    return {text.str()};
  }
  return {};
}

std::string nameOf(const Access& access, world::Slot link) {
  const world::LinkRecord& record = access.entities.links()[link];
  return access.entities.models()[record.model].scopedName + "::" + record.description->name;
}

std::shared_ptr<description::Link> copyOf(const Access& access, world::Slot link) {
  return std::make_shared<description::Link>(*access.entities.links()[link].description);
}

/// Takes the sizes of a copy of the link.
void take(Access& access, world::Slot link, std::shared_ptr<const description::Link> changed) {
  access.entities.changeLink(link, std::move(changed));
  access.noteChange();
}

/// Calls `use` with each collision and visual.
template <class Link, class Use>
void forEachShape(Link& link, Use use) {
  for (auto& collision : link.collisions) use(collision.geometry);
  for (auto& visual : link.visuals) use(visual.geometry);
}

std::vector<double> sizesOf(const description::Link& link) {
  std::vector<double> sizes;
  forEachShape(link, [&](const Geometry& geometry) {
    for (const double number : sizeOf(geometry)) sizes.push_back(number);
  });
  return sizes;
}

std::shared_ptr<const description::Link> readSizes(StateArchive& archive, const world::LinkRecord& record) {
  const bool isChanged = record.changed != nullptr;
  auto link = std::make_shared<description::Link>(isChanged ? *record.ofFile : *record.description);
  forEachShape(*link, [&](Geometry& geometry) {
    std::vector<double> size = sizeOf(geometry);
    for (double& number : size) {
      const double ofFile = number;
      archive(number);
      archive.check(isLength(number) || number == ofFile);
    }
    if (!size.empty()) description::setSize(geometry, size);
  });
  return link;
}

}  // namespace

Outcome<void> setCollisionSize(Access& access, world::Slot link, std::size_t number, std::span<const double> size,
                               const SizeFollowers& followers) {
  auto changed = copyOf(access, link);
  description::Collision& collision = changed->collisions[number];
  const std::string what = "collision '" + nameOf(access, link) + "::" + collision.name + "'";
  if (Outcome<void> checked = checkSize(what, collision.geometry, size); !checked) return checked;
  const Geometry before = collision.geometry;
  description::setSize(collision.geometry, size);
  Outcome<physics::Engine::Mass> mass{access.engine.mass(link), {}};
  if (followers.mass) mass = stretchedMass(access, link, before, collision);
  if (!mass) return {mass.error};
  for (description::Visual& visual : changed->visuals) {
    const bool follows =
        followers.visuals && visual.geometry == before && visual.X_LinkVisual == collision.X_LinkCollision;
    if (follows) description::setSize(visual.geometry, size);
  }
  if (sizesOf(*changed) == sizesOf(*access.entities.links()[link].description)) return {};
  take(access, link, std::move(changed));
  access.engine.reshape(link);
  if (followers.mass) access.engine.setMass(link, *mass);
  return {};
}

Outcome<void> setVisualSize(Access& access, world::Slot link, std::size_t number, std::span<const double> size) {
  auto changed = copyOf(access, link);
  description::Visual& visual = changed->visuals[number];
  const std::string what = "visual '" + nameOf(access, link) + "::" + visual.name + "'";
  if (Outcome<void> checked = checkSize(what, visual.geometry, size); !checked) return checked;
  description::setSize(visual.geometry, size);
  take(access, link, std::move(changed));
  return {};
}

void transferSizes(StateArchive& archive, Access& access) {
  const std::vector<world::LinkRecord>& links = access.entities.links();
  std::vector<std::uint64_t> changed;
  for (world::Slot slot = 0; slot < links.size(); ++slot) {
    if (links[slot].changed != nullptr) changed.push_back(slot);
  }
  const std::vector<std::uint64_t> before = changed;
  archive(changed);
  for (const std::uint64_t slot : changed) {
    archive.check(slot < links.size());
    if (!archive.isGiving()) {
      for (double number : sizesOf(*links[slot].description)) archive(number);
      continue;
    }
    auto link = readSizes(archive, links[slot]);
    if (sizesOf(*link) != sizesOf(*links[slot].description)) take(access, slot, std::move(link));
  }
  if (!archive.isGiving()) return;
  for (const std::uint64_t slot : before) {
    if (std::ranges::find(changed, slot) == changed.end()) take(access, slot, nullptr);
  }
}

}  // namespace pongsim::sim
