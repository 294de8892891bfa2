#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pongsim::fuel {

/// A server's information about a model or world.
struct Details {
  std::string owner;
  std::string name;
  /// The newest version; 0: unknown.
  int version = 0;
  std::uint64_t bytes = 0;
  bool isPrivate = false;
  std::string description, license, created, updated;
  std::vector<std::string> tags;
};

/// Text that is safe to print on a terminal: without control characters.
std::string plain(std::string text);

/// @param json A server's answer.
/// @throws Failure if it does not describe a model or world, PassingFailure if it is not JSON; the same below.
Details parseDetails(std::string_view json);
/// @param json A list of models or worlds, or null.
std::vector<Details> parseDetailsList(std::string_view json);

}  // namespace pongsim::fuel
