#pragma once

#include <string>

#include "plugin/core_systems.hh"
#include "plugin/inspection.hh"

namespace pongsim::cli {

/// @return What a library's classes say of themselves, to read in a terminal.
std::string pluginText(const plugin::Inspection& inspection);

std::string pluginText(const plugin::CoreSystem& system);

/// @return The same as Markdown, a section each class.
std::string pluginMarkdown(const plugin::Inspection& inspection);
std::string pluginMarkdown(const plugin::CoreSystem& system);

}  // namespace pongsim::cli
