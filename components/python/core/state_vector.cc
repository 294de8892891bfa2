#include "core/state_vector.hh"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "core/errors.hh"
#include "core/values.hh"

namespace pongsim::python {

namespace {

constexpr std::size_t kPoseSize = 7;
constexpr std::size_t kTwistSize = 6;

void putPose(const Pose& pose, std::span<double> to) {
  std::copy_n(pose.position.data(), 3, to.begin());
  std::copy_n(pose.rotation.coeffs().data(), 4, to.begin() + 3);
}

void putTwist(const Twist& twist, std::span<double> to) {
  std::copy_n(twist.linear.data(), 3, to.begin());
  std::copy_n(twist.angular.data(), 3, to.begin() + 3);
}

Twist twistIn(std::span<const double> from) {
  return {Vector3(from[0], from[1], from[2]), Vector3(from[3], from[4], from[5])};
}

void checkFinite(std::span<const double> numbers, const char* what) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (std::isfinite(numbers[i])) continue;
    throw py::value_error(std::string(what) + " must be finite, but number " + std::to_string(i) + " is " +
                          std::to_string(numbers[i]));
  }
}

void collectParts(const Model& model, std::vector<Link>& links, std::vector<std::pair<std::string, Joint>>& joints) {
  for (const Link& link : model.links()) links.push_back(link);
  for (const Joint& joint : model.joints()) {
    joints.emplace_back(model.scopedName() + "::" + std::string(joint.name()), joint);
  }
  for (const Model& nested : model.models()) collectParts(nested, links, joints);
}

/// The links of a world, grouped by joints.
class Assemblies {
 public:
  explicit Assemblies(const std::vector<Link>& links) : parents_(links.size()) {
    std::iota(parents_.begin(), parents_.end(), 0);
    for (std::size_t i = 0; i < links.size(); ++i) {
      places_[links[i].id().value] = i;
      if (links[i].model().isStatic()) anchor(i);
    }
  }
  void join(const Joint& joint) {
    const std::size_t child = places_.at(joint.child().id().value);
    if (const std::optional<Link> parent = joint.parent()) {
      const std::size_t a = rootOf(child), b = rootOf(places_.at(parent->id().value));
      parents_[std::max(a, b)] = std::min(a, b);
    } else {
      anchor(child);
    }
  }
  /// @return The first link of the group.
  std::size_t rootOf(std::size_t link) const {
    while (parents_[link] != link) link = parents_[link];
    return link;
  }
  bool isAnchored(std::size_t root) const {
    return std::ranges::any_of(anchored_, [&](std::size_t link) { return rootOf(link) == root; });
  }

 private:
  void anchor(std::size_t link) { anchored_.push_back(link); }
  std::map<std::uint64_t, std::size_t> places_;
  std::vector<std::size_t> parents_;
  std::vector<std::size_t> anchored_;
};

}  // namespace

Twist velocityOf(const Model& model) {
  const std::optional<Link> link = model.canonicalLink();
  if (!link) return {};
  const Vector3 w = link->angularVelocity();
  return {link->linearVelocity() + w.cross(model.pose().position - link->pose().position), w};
}

std::vector<std::uint64_t> StateVector::countOf(Simulation& simulation) {
  std::vector<std::uint64_t> contents;
  const auto add = [&](const auto& self, const std::vector<Model>& models) -> void {
    for (const Model& model : models) {
      contents.push_back(model.id().value);
      contents.push_back(model.joints().size());
      self(self, model.models());
    }
  };
  add(add, simulation.world().models());
  return contents;
}

StateVector::StateVector(Simulation& simulation) : contents_(countOf(simulation)) {
  std::vector<Link> links;
  std::vector<std::pair<std::string, Joint>> joints;
  std::vector<std::size_t> firstLink;
  const std::vector<Model> tops = simulation.world().models();
  for (const Model& top : tops) {
    firstLink.push_back(links.size());
    collectParts(top, links, joints);
  }
  firstLink.push_back(links.size());
  Assemblies assemblies(links);
  for (const auto& [name, joint] : joints) assemblies.join(joint);
  std::map<std::size_t, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < links.size(); ++i) groups[assemblies.rootOf(i)].push_back(i);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    std::vector<Free> free;
    for (std::size_t link = firstLink[i]; link < firstLink[i + 1]; ++link) {
      const auto group = groups.find(link);
      if (group == groups.end() || assemblies.isAnchored(link)) continue;
      const std::size_t size = group->second.size();
      // a group within this model begins at its first link, so it is the whole if it has as many
      const bool isWhole = size == firstLink[i + 1] - firstLink[i] && group->second.back() < firstLink[i + 1];
      free.push_back({links[link], isWhole ? std::optional(tops[i]) : std::nullopt, isWhole || size == 1});
    }
    add(tops[i], i, free);
  }
}

void StateVector::add(const Model& top, std::size_t number, const std::vector<Free>& free) {
  const auto addPiece = [this, number](std::string name, bool isFree, std::size_t positions, std::size_t velocities) {
    pieces_.push_back({std::move(name), isFree, positionCount_, positions, velocityCount_, velocities, number});
    positionCount_ += positions;
    velocityCount_ += velocities;
  };
  for (const Free& each : free) {
    addPiece(each.model ? each.model->scopedName() : each.link.scopedName(), true, kPoseSize, kTwistSize);
    free_.push_back(each);
  }
  std::vector<Link> links;
  std::vector<std::pair<std::string, Joint>> joints;
  collectParts(top, links, joints);
  for (auto& [name, joint] : joints) {
    const auto axes = static_cast<std::size_t>(joint.axisCount());
    if (axes == 0) continue;
    addPiece(std::move(name), false, axes, axes);
    joints_.push_back(joint);
  }
}

Pose StateVector::Free::pose() const { return model ? model->pose() : link.pose(); }

Twist StateVector::Free::velocity() const {
  return model ? velocityOf(*model) : Twist{link.linearVelocity(), link.angularVelocity()};
}

Outcome<void> StateVector::Free::setPose(const Pose& pose) { return model ? model->setPose(pose) : link.setPose(pose); }

void StateVector::Free::setVelocity(const Twist& twist) {
  if (model) {
    model->setVelocity(twist.linear, twist.angular);
  } else {
    link.setVelocity(twist.linear, twist.angular);
  }
}

void StateVector::Free::checkCanBeSet(const std::string& name) const {
  if (!canBeSet) raise("Refused", "'" + name + "' is a part of several models, or one of several in its model");
}

void StateVector::readPositions(std::span<double> to) const {
  auto free = free_.begin();
  auto joint = joints_.begin();
  for (const Piece& piece : pieces_) {
    if (piece.isFree) {
      putPose(free->pose(), to.subspan(piece.position));
      ++free;
      continue;
    }
    for (std::size_t i = 0; i < piece.positions; ++i) to[piece.position + i] = joint->position(static_cast<int>(i));
    ++joint;
  }
}

void StateVector::readVelocities(std::span<double> to) const {
  auto free = free_.begin();
  auto joint = joints_.begin();
  for (const Piece& piece : pieces_) {
    if (piece.isFree) {
      putTwist(free->velocity(), to.subspan(piece.velocity));
      ++free;
      continue;
    }
    for (std::size_t i = 0; i < piece.velocities; ++i) to[piece.velocity + i] = joint->velocity(static_cast<int>(i));
    ++joint;
  }
}

void StateVector::setJoints(std::span<const double> numbers, std::size_t Piece::*place, double (Joint::*now)(int) const,
                            Outcome<void> (Joint::*set)(double, int)) {
  auto joint = joints_.begin();
  for (const Piece& piece : pieces_) {
    if (piece.isFree) continue;
    for (std::size_t i = 0; i < piece.positions; ++i) {
      const double wanted = numbers[piece.*place + i];
      const auto axis = static_cast<int>(i);
      if (((*joint).*now)(axis) == wanted) continue;
      const Outcome<void> done = ((*joint).*set)(wanted, axis);
      if (!done) raise("Refused", "joint '" + piece.name + "': " + done.error);
    }
    ++joint;
  }
}

template <class Function>
void StateVector::forEachFree(Function function) {
  auto free = free_.begin();
  for (const Piece& piece : pieces_) {
    if (piece.isFree) function(piece, *free++);
  }
}

void StateVector::stopWhatMoves(std::span<const double> positions) {
  std::vector<bool> moves(pieces_.empty() ? 0 : pieces_.back().model + 1, false);
  std::vector<double> now(positionCount_);
  readPositions(now);
  for (const Piece& piece : pieces_) {
    const auto of = [&](std::span<const double> numbers) { return numbers.subspan(piece.position, piece.positions); };
    if (!piece.isFree && !std::ranges::equal(of(positions), of(now))) moves[piece.model] = true;
  }
  auto joint = joints_.begin();
  for (const Piece& piece : pieces_) {
    if (piece.isFree) continue;
    // one in a loop refuses, and goes on
    for (int axis = 0; moves[piece.model] && axis < joint->axisCount(); ++axis) joint->resetVelocity(0, axis);
    ++joint;
  }
  forEachFree([&](const Piece& piece, Free& free) {
    if (moves[piece.model] && free.canBeSet) free.setVelocity({});
  });
}

void StateVector::setPositions(std::span<const double> positions) {
  stopWhatMoves(positions);
  // joints first: they may move the link that a model's pose is that of
  setJoints(positions, &Piece::position, &Joint::position, &Joint::resetPosition);
  forEachFree([&](const Piece& piece, Free& free) {
    const auto wanted = positions.subspan(piece.position, kPoseSize);
    std::array<double, kPoseSize> now;
    putPose(free.pose(), now);
    if (std::ranges::equal(wanted, now)) return;
    free.checkCanBeSet(piece.name);
    const Outcome<void> done = free.setPose(poseIn(wanted, piece.name.c_str()));
    if (!done) raise("Refused", "'" + piece.name + "': " + done.error);
  });
}

void StateVector::setVelocities(std::span<const double> velocities) {
  setJoints(velocities, &Piece::velocity, &Joint::velocity, &Joint::resetVelocity);
  forEachFree([&](const Piece& piece, Free& free) {
    const auto wanted = velocities.subspan(piece.velocity, kTwistSize);
    std::array<double, kTwistSize> now;
    putTwist(free.velocity(), now);
    if (std::ranges::equal(wanted, now)) return;
    free.checkCanBeSet(piece.name);
    free.setVelocity(twistIn(wanted));
  });
}

void StateVector::write(std::optional<std::span<const double>> positions,
                        std::optional<std::span<const double>> velocities) {
  std::vector<double> oldPositions(positionCount_), oldVelocities(velocityCount_);
  readPositions(oldPositions);
  readVelocities(oldVelocities);
  if (positions) {
    checkFinite(*positions, "positions");
    for (const Piece& piece : pieces_) {
      if (piece.isFree) poseIn(positions->subspan(piece.position, kPoseSize), piece.name.c_str());
    }
  }
  if (velocities) checkFinite(*velocities, "velocities");
  try {
    if (positions) setPositions(*positions);
    setVelocities(velocities.value_or(oldVelocities));
  } catch (...) {
    setPositions(oldPositions);
    setVelocities(oldVelocities);
    throw;
  }
}

}  // namespace pongsim::python
