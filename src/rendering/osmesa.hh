#pragma once

#include <memory>
#include <variant>

#include "assets/problem.hh"
#include "rendering/context.hh"

namespace pongsim::rendering {

/// @return A context that draws with the processor alone, by Mesa's off-screen library, which is opened here; or why
/// there is none, with what to install.
std::variant<std::unique_ptr<Context>, assets::Problem> openOsmesa();

}  // namespace pongsim::rendering
