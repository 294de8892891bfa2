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

/// Which models, links and actors there are, as plain values, and where they are when links and actors are somewhere.
/// For any thread, but for `actors`, which is for the simulation's.
class Roster {
 public:
  /// On the simulation's thread.
  explicit Roster(const World& world);

  /// @return The links, in the order in which `poses` wants them.
  const std::vector<Link>& links() const { return links_; }

  /// @return The actors, in the order in which `poses` wants them.
  const std::vector<Actor>& actors() const { return actors_; }

  /// Replaces `poses` by those of all models, links and actors.
  /// @param X_WorldLinks, X_WorldActors Of the links and the actors, in their order.
  void poses(std::span<const Pose> X_WorldLinks, std::span<const Pose> X_WorldActors,
             std::vector<FramePose>& poses) const;

 private:
  struct ModelPlace {
    std::uint32_t entity = 0;
    /// Which link it moves with; nothing where none, and `X_LinkModel` is in the world.
    std::optional<std::size_t> link;
    Pose X_LinkModel;
  };

  void add(const Model& model);

  std::vector<Link> links_;
  std::vector<ModelPlace> models_;
  std::vector<Actor> actors_;
};

}  // namespace pongsim::web
