#include "cli/dataset/label_map.hh"

#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>

namespace pongsim::cli {

namespace {

/// Label, and number of the instance divided by and modulo 256.
using Instance = std::tuple<std::uint8_t, std::uint8_t, std::uint8_t>;

/// Collects the pixels of an instance, column by column.
struct Outline {
  Eigen::AlignedBox2d box;
  Mask mask;
  /// Up to which pixel the runs say what shows it.
  std::uint64_t told = 0;

  void add(std::size_t column, std::size_t row, std::size_t height) {
    const std::uint64_t pixel = column * height + row;
    if (told < pixel || mask.runs.empty()) {
      mask.runs.push_back(pixel - told);
      mask.runs.push_back(0);
    }
    ++mask.runs.back();
    told = pixel + 1;
    ++mask.area;
    const Eigen::Vector2d corner(static_cast<double>(column), static_cast<double>(row));
    box.extend(corner);
    box.extend(corner + Eigen::Vector2d::Ones());
  }
};

}  // namespace

std::vector<LabelledThing> thingsIn(const assets::Picture& map) {
  std::map<Instance, Outline> outlines;
  // of a panoptic camera the first 256 instances differ in this from all labels, and there are never more without them
  bool isSemantic = true;
  for (std::size_t column = 0; column < map.width; ++column) {
    for (std::size_t row = 0; row < map.height; ++row) {
      const std::uint8_t* const pixel = &map.pixels[4 * (row * map.width + column)];
      if (pixel[0] == 0 && pixel[1] == 0 && pixel[2] == 0) continue;
      isSemantic = isSemantic && pixel[0] == pixel[1] && pixel[1] == pixel[2];
      outlines[{pixel[2], pixel[1], pixel[0]}].add(column, row, map.height);
    }
  }
  const std::uint64_t size = map.width * map.height;
  std::vector<LabelledThing> things;
  for (auto& [instance, outline] : outlines) {
    if (outline.told < size) outline.mask.runs.push_back(size - outline.told);
    things.push_back(
        {.label = std::get<0>(instance), .box = outline.box, .mask = std::move(outline.mask), .isCrowd = isSemantic});
  }
  return things;
}

}  // namespace pongsim::cli
