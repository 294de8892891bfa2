#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pongsim::cli {

/// Why pongsim has not what somebody asks for, and what to use instead.
struct Advice {
  std::string message;
  std::string hint;
  bool operator==(const Advice&) const = default;
};

/// @return What to say of a command that Fortress has, or one of pongsim's packages, and that is not there; nothing
/// where the name is unknown.
std::optional<Advice> adviceOnCommand(std::string_view name);

/// Likewise of an option.
/// @param command "run"; others have none of packages.
/// @param option With its hyphens.
/// @param known The command's options, with their hyphens: those of packages that are installed are among them.
std::optional<Advice> adviceOnOption(std::string_view command, std::string_view option,
                                     std::span<const std::string_view> known);

}  // namespace pongsim::cli
