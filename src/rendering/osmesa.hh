#pragma once

#include <memory>

#include "rendering/context.hh"

namespace pongsim::rendering {

/// Opens Mesa's off-screen library, which renders on the processor.
/// @throws std::runtime_error if it is not installed, with the package to install.
std::unique_ptr<Context> openOsmesa();

}  // namespace pongsim::rendering
