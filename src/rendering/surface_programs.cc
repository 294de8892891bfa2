#include "rendering/surface_programs.hh"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <string>
#include <vector>

#include "rendering/shaders.hh"

namespace pongsim::rendering {

namespace {

// sets of lamps whose programs are kept: enough for lamps that are switched on and off
constexpr std::size_t kMostLightSets = 16;

std::string surfaceFragment(bool isLit, bool hasPicture, bool hasMaps, const LightKinds& kinds) {
  const std::vector<LampKind>& lamps = kinds.lamps;
  std::string text = "#version 450 core\n#define LAMPS";
  for (std::size_t i = 0; i < lamps.size(); ++i) {
    const auto word = [](bool is) { return is ? ", true" : ", false"; };
    text += " sum += reflected(spot, " + std::to_string(i) + word(lamps[i].hasPlace) + word(lamps[i].isSpot) + ", " +
            std::to_string(lamps[i].shadow) + ");";
  }
  text += '\n';
  if (isLit) text += "#define LIT\n";
  if (hasPicture) text += "#define TEXTURED\n";
  if (hasMaps) text += "#define MAPPED\n";
  using enum description::Fog::Type;
  if (kinds.fog == kConstant) text += "#define FOG exp(-fog.w * far)\n";
  if (kinds.fog == kLinear) text += "#define FOG 1.0 - fog.w * clamp((far - fogPlace.x) * fogPlace.y, 0.0, 1.0)\n";
  if (kinds.fog == kQuadratic) text += "#define FOG exp(-fog.w * fog.w * far * far)\n";
  return text + shaders::kSurfaceFragment;
}

}  // namespace

bool isMapped(const Item& item) {
  return std::any_of(item.pictures.begin() + kNormalMap, item.pictures.end(),
                     [](const auto& picture) { return picture != nullptr; });
}

void SurfacePrograms::setLight(const LightKinds& kinds) {
  inUse_ = programs_.find(kinds);
  if (inUse_ != programs_.end()) return;
  if (programs_.size() >= kMostLightSets) programs_.clear();
  inUse_ = programs_.try_emplace(kinds).first;
}

const Program& SurfacePrograms::of(const Item& item) {
  assert(inUse_ != programs_.end());
  const bool isLit = item.paint.isLit, hasPicture = item.pictures[kColorMap] != nullptr, hasMaps = isMapped(item);
  auto& program = inUse_->second[(isLit ? 1U : 0U) + (hasPicture ? 2U : 0U) + (hasMaps ? 4U : 0U)];
  if (program == nullptr) {
    const std::string fragment = surfaceFragment(isLit, hasPicture, hasMaps, inUse_->first);
    program = std::make_unique<const Program>(gl_, shaders::kSurfaceVertex, fragment.c_str());
  }
  return *program;
}

}  // namespace pongsim::rendering
