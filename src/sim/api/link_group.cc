#include "pongsim/link_group.hh"

#include <stdexcept>
#include <string>

#include "sim/api/access.hh"

namespace pongsim {

LinkGroup::LinkGroup(const World& world, std::span<const Link> links) : access_(world.access_) {
  ids_.reserve(links.size());
  for (const Link& link : links) ids_.push_back(link.id());
  slots_.resize(ids_.size());
  poses_.resize(ids_.size());
}

void LinkGroup::lookUp() {
  if (isKnown_ && changes_ == access_->changes) return;
  for (std::size_t i = 0; i < ids_.size(); ++i) slots_[i] = sim::slotOf(*access_, ids_[i]);
  changes_ = access_->changes;
  isKnown_ = true;
}

std::span<const Pose* const> LinkGroup::poses() {
  lookUp();
  const world::LinkState* const links = access_->state.links.data();
  for (std::size_t i = 0; i < slots_.size(); ++i) poses_[i] = &links[slots_[i]].X_WorldLink;
  return poses_;
}

void LinkGroup::copyPoses(std::span<Pose> X_WorldLinks) {
  if (X_WorldLinks.size() != ids_.size()) {
    throw std::invalid_argument(std::to_string(X_WorldLinks.size()) + " places for the poses of a group of " +
                                std::to_string(ids_.size()) + " links");
  }
  lookUp();
  const world::LinkState* const links = access_->state.links.data();
  for (std::size_t i = 0; i < slots_.size(); ++i) X_WorldLinks[i] = links[slots_[i]].X_WorldLink;
}

void LinkGroup::addWrenches(std::span<const Wrench> wrenches) {
  if (wrenches.size() != ids_.size()) {
    throw std::invalid_argument(std::to_string(wrenches.size()) + " wrenches for a group of " +
                                std::to_string(ids_.size()) + " links");
  }
  lookUp();
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto& [force, torque] = wrenches[i];
    if (sim::areWithin(force, torque, sim::kMostForce)) {
      access_->engine.addLinkWrench(slots_[i], force, torque);
    } else {
      access_->refuse("link '" + access_->entities.links()[slots_[i]].description->name +
                      "' was given a wrench that is not finite or beyond " + sim::kMostForceText);
    }
  }
}

}  // namespace pongsim
