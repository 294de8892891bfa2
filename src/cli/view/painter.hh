#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/view/sight.hh"
#include "cli/view/view_command.hh"

namespace pongsim::cli {

/// Makes colours of what cameras of other kinds see. Those of the first picture hold for all.
class Painter {
 public:
  explicit Painter(PictureKind kind) : kind_(kind) {}

  /// @param pixels Red, green, blue, row by row from the top.
  void draw(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels);

  /// @return What the colours of the first picture mean: "white is 0.52 m away"; empty for colours.
  std::string legend() const;

 private:
  void drawDepths(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels);
  void drawTemperatures(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels);
  void drawLabels(Sight& sight, const PictureView& view, std::span<std::uint8_t> pixels);

  PictureKind kind_;
  std::vector<float> values_;
  std::vector<std::uint32_t> numbers_;
  /// What is nearest [m].
  std::optional<float> nearest_;
  struct Range {
    /// [K]
    float coldest;
    float hottest;
  };
  std::optional<Range> temperatures_;
};

}  // namespace pongsim::cli
