#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "pongsim/export.hh"
#include "pongsim/sensing/camera_settings.hh"
#include "pongsim/sensing/seen_visual.hh"

namespace pongsim {

/// Red, green, blue.
using LabelColor = std::array<std::uint8_t, 3>;

/// Draws colours for numbers, the same as Fortress: evenly from 0 to 255 with a generator of Park and Miller (1988)
/// that the number seeds.
class PONGSIM_API LabelPalette {
 public:
  /// @param number Below 2^31 - 1.
  /// @return A colour that no earlier number has, and not black, which is the background's.
  LabelColor colorOf(std::uint32_t number);

 private:
  std::set<LabelColor> taken_{LabelColor()};
};

/// What the maps of a segmentation camera show of a visual.
struct LabelLook {
  /// In the coloured map.
  LabelColor color{};
  /// In the map of labels: of a semantic camera three times the label; of a panoptic one the count of instances modulo
  /// 256, divided by 256, and the label.
  LabelColor code{};
};

/// Numbers the instances of labels: of each label, the top-level models and actors with it, from 1, in descending order
/// of their names, as in Fortress. Its numbers do not depend on what a camera sees.
/// @return For each visual; that of an unlabelled one, or with the label 0, is black.
PONGSIM_API std::vector<LabelLook> labelLooks(std::span<const SeenVisual> visuals, CameraSettings::Segmentation kind);

}  // namespace pongsim
