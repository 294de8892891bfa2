#pragma once

#include <optional>
#include <vector>

#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A link whose velocity is that which its joints let it have where it is now.
///
/// Within a step a link on a joint goes straight on, along the chord of its arc, and that is the velocity which it has
/// afterwards: half a step behind the tangent, by 10 degrees where a step turns it by 20. Here the velocity is made of
/// that of the link at the other end of the chain of joints and of how all between them turn, as engines have it whose
/// coordinates are the joints', such as Fortress's.
class CarriedLink {
 public:
  /// Finds the joints that carry the link and only turn, in its model and in those which that is nested in.
  explicit CarriedLink(const Link& link);

  /// @return Velocity of the link frame's origin, world frame [m/s].
  Vector3 linearVelocity() const;

 private:
  /// A joint of the chain.
  struct Hold {
    Link child;
    /// Its origin in the frame of the child.
    Vector3 origin;
  };

  Link link_;
  /// From the link up.
  std::vector<Hold> chain_;
  /// What carries the last of them; nothing: the world.
  std::optional<Link> carrier_;
};

}  // namespace pongsim
