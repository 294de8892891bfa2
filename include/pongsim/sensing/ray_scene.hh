#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>

#include "pongsim/diagnostic.hh"
#include "pongsim/export.hh"
#include "pongsim/handles.hh"
#include "pongsim/types.hh"

namespace pongsim {

/// A ray from any place, in the world frame.
struct Ray {
  Vector3 origin = Vector3::Zero();
  /// A unit vector.
  Vector3 direction = Vector3::UnitX();
};

/// What a ray hits first.
struct RayHit {
  /// [m]; infinite without a hit.
  double distance = std::numeric_limits<double>::infinity();
  /// The link that is hit; unset without a hit, and for an actor.
  std::optional<LinkId> link = std::nullopt;
};

/// The visuals of a world, for rays that belong to no sensor. Surfaces are hit as lidars hit them (`BeamScene`): from
/// outside, and from inside too where a material is double-sided.
class PONGSIM_API RayScene {
 public:
  /// @throws std::runtime_error if Embree is not installed; the message names the package.
  explicit RayScene(const World& world);
  ~RayScene();

  /// Finds what each ray hits where everything is now. Reads the visuals anew after models were added or removed.
  /// @param farthest Longest distance [m].
  /// @param visibilityMask A visual is visible if it shares a bit with its `<visibility_flags>`.
  /// @param hits One for each ray.
  /// @param diagnostics Warnings about files that can't be read; their visuals are left out.
  void cast(std::span<const Ray> rays, double farthest, std::uint32_t visibilityMask, std::span<RayHit> hits,
            Diagnostics& diagnostics);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace pongsim
