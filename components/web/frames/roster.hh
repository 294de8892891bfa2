#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "pongsim/actor.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"
#include "web/frames/frame.hh"

namespace pongsim::web {

/// The models, links and actors of a world as plain values, for computing all poses from those of links and actors. For
/// any thread, except `actors`, which is for the simulation's.
class Roster {
 public:
  /// On the simulation's thread.
  explicit Roster(const World& world);

  /// @return The links, in the order that `poses` expects.
  const std::vector<Link>& links() const { return links_; }

  /// @return The actors, in the order that `poses` expects.
  const std::vector<Actor>& actors() const { return actors_; }

  /// Replaces `poses` by those of all models, links and actors.
  /// @param X_WorldLinks, X_WorldActors Poses of the links and actors, in their order.
  void poses(std::span<const Pose> X_WorldLinks, std::span<const Pose> X_WorldActors,
             std::vector<FramePose>& poses) const;

 private:
  struct ModelPlace {
    std::uint32_t entity = 0;
    /// The link it moves with; if there is none, `X_LinkModel` is relative to the world.
    std::optional<std::size_t> link;
    Pose X_LinkModel;
  };

  void add(const Model& model);

  std::vector<Link> links_;
  std::vector<ModelPlace> models_;
  std::vector<Actor> actors_;
};

}  // namespace pongsim::web
