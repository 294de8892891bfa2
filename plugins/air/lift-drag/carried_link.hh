#pragma once

#include <optional>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A link whose velocity is computed from its joints, at its current position.
/// Within a step, a link on a joint moves straight along the chord of its arc. Its velocity afterwards is that of the
/// chord, which is half a step behind the tangent: by 10 degrees if a step turns it by 20. Here the velocity is
/// composed of that of the link at the other end of the chain of joints and of the rotations in between, as in engines
/// whose coordinates are those of the joints, such as Fortress's.
class CarriedLink {
 public:
  /// Finds the rotational joints between the link and its root, in its model and the outer models.
  explicit CarriedLink(const Link& link);

  /// @return Velocity of the link frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;

 private:
  /// A joint of the chain.
  struct Hold {
    Link child;
    /// Origin of the joint in the frame of the child.
    Vector3 origin;
  };

  Link link_;
  /// From the link towards the root.
  std::vector<Hold> chain_;
  /// The parent of the last joint; nothing for the world.
  std::optional<Link> carrier_;
};

}  // namespace pongsim
