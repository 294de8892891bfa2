#pragma once

#include <memory>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// Opens Mesa's off-screen library, which draws with the processor alone.
/// @throws std::runtime_error where it is not installed, saying which package to install.
std::unique_ptr<Context> openOsmesa();

}  // namespace pongsim::rendering
