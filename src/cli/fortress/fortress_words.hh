#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// Why pongsim lacks something, and what to use instead.
struct Advice {
  std::string message;
  std::string hint;
  bool operator==(const Advice&) const = default;
};

/// @return A message about a missing command that exists in Fortress or in one of pongsim's packages; nothing if the
/// name is unknown.
std::optional<Advice> adviceOnCommand(std::string_view name);

/// The same for an option.
/// @param command "run"; packages add options to no other command.
/// @param option With its hyphens.
/// @param known The command's options, with their hyphens, including those of installed packages.
std::optional<Advice> adviceOnOption(std::string_view command, std::string_view option,
                                     std::span<const std::string_view> known);

}  // namespace pongsim::cli
