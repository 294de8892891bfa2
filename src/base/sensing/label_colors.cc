#include "pongsim/sensing/label_colors.hh"

#include <map>
#include <string>
#include <utility>

namespace pongsim {

namespace {

constexpr std::uint32_t kInstances = 65'536;

/// "Minimal standard" generator: x = 16807 x mod (2^31 - 1).
class Generator {
 public:
  explicit Generator(std::uint32_t seed) : state_(seed % kModulus == 0 ? 1 : seed % kModulus) {}

  /// @return 0 to 255, evenly: values of the generator that would not be are left out.
  std::uint8_t byte() {
    constexpr std::uint64_t kScale = (kModulus - 2) / 256;
    std::uint64_t value = 0;
    do {
      state_ = 16'807 * state_ % kModulus;
      value = state_ - 1;
    } while (value >= 256 * kScale);
    const auto drawn = static_cast<std::uint8_t>(value / kScale);
    // Fortress's colours are from 0 to 1, and it takes larger numbers for bytes
    return drawn == 1 ? 255 : drawn;
  }

 private:
  static constexpr std::uint64_t kModulus = 2'147'483'647;
  std::uint64_t state_;
};

/// Descending order as Fortress sorts the names of visuals, which begin like this.
struct Later {
  bool operator()(const std::string& a, const std::string& b) const { return a + "::" > b + "::"; }
};

/// The instances of each label, by the names of their owners.
using Instances = std::map<std::uint8_t, std::map<std::string, std::uint32_t, Later>>;

Instances instancesOf(std::span<const SeenVisual> visuals) {
  Instances instances;
  for (const SeenVisual& visual : visuals) {
    if (visual.label.value_or(0) != 0) instances[*visual.label].emplace(visual.owner, 0);
  }
  for (auto& [label, owners] : instances) {
    std::uint32_t count = 0;
    for (auto& [owner, number] : owners) number = ++count % kInstances;
  }
  return instances;
}

}  // namespace

LabelColor LabelPalette::colorOf(std::uint32_t number) {
  Generator generator(number);
  LabelColor color{};
  do {
    for (std::uint8_t& channel : color) channel = generator.byte();
  } while (!taken_.insert(color).second);
  return color;
}

std::vector<LabelLook> labelLooks(std::span<const SeenVisual> visuals, CameraSettings::Segmentation kind) {
  const bool isPanoptic = kind == CameraSettings::Segmentation::kPanoptic;
  const Instances instances = instancesOf(visuals);
  LabelPalette palette;
  std::map<std::uint32_t, LabelColor> colors;
  for (const auto& [label, owners] : instances) {
    if (!isPanoptic) colors.emplace(label, palette.colorOf(label));
    for (const auto& [owner, number] : owners) {
      const std::uint32_t both = label * kInstances + number;
      if (isPanoptic) colors.emplace(both, palette.colorOf(both));
    }
  }
  std::vector<LabelLook> looks;
  looks.reserve(visuals.size());
  for (const SeenVisual& visual : visuals) {
    const std::uint8_t label = visual.label.value_or(0);
    if (label == 0) {
      looks.emplace_back();
    } else if (isPanoptic) {
      const std::uint32_t number = instances.at(label).at(visual.owner);
      looks.push_back({colors.at(label * kInstances + number),
                       {static_cast<std::uint8_t>(number % 256), static_cast<std::uint8_t>(number / 256), label}});
    } else {
      looks.push_back({colors.at(label), {label, label, label}});
    }
  }
  return looks;
}

}  // namespace pongsim
