#include "cli/fortress/gz_types.hh"

#include <cstddef>
#include <string_view>
#include <utility>

namespace pongsim::cli {

std::string withTypeNames(std::string text, bool asGz) {
  if (!asGz) return text;
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {{"ignition.msgs.", "gz.msgs."},
                                                                      {"ignition/msgs/", "gz/msgs/"}};
  for (const auto& [fortress, later] : kNames) {
    for (std::size_t at = text.find(fortress); at != std::string::npos; at = text.find(fortress, at + later.size())) {
      text.replace(at, fortress.size(), later);
    }
  }
  return text;
}

}  // namespace pongsim::cli
