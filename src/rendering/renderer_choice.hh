#pragma once

#include <optional>
#include <string_view>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// What draws pictures: Mesa on the processor; a graphics card by EGL; or that if there is one that can, else Mesa.
enum class RendererChoice { kSoftware, kEgl, kAuto };

/// The environment variable with the choice; unset or empty: software.
inline constexpr const char* kRendererVariable = "PONGSIM_RENDERER";

/// @param name "software", "egl" or "auto".
/// @return Nothing for other names.
std::optional<RendererChoice> rendererChoice(std::string_view name);

/// Opens what the environment chooses.
/// @throws std::runtime_error with what to install or to choose instead, if it can't be opened.
Contexts openContexts();

}  // namespace pongsim::rendering
