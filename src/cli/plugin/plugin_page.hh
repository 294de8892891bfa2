#pragma once

#include <string>

#include "plugin/core_systems.hh"
#include "plugin/inspection.hh"

namespace pongsim::cli {

/// @return The descriptions of a library's classes, for a terminal.
std::string pluginText(const plugin::Inspection& inspection);

std::string pluginText(const plugin::CoreSystem& system);

/// @return The same as Markdown, one section for each class.
std::string pluginMarkdown(const plugin::Inspection& inspection);
std::string pluginMarkdown(const plugin::CoreSystem& system);

}  // namespace pongsim::cli
