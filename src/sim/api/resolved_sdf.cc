#include "pongsim/files/resolved_sdf.hh"

#include "pongsim/element.hh"
#include "sdf/includes/addresses.hh"
#include "sdf/loader.hh"
#include "sdf/text/print.hh"

namespace pongsim {

std::optional<std::string> resolvedSdf(const std::filesystem::path& file, Diagnostics& diagnostics) {
  std::optional<Element> root = sdf::resolveFile(file, diagnostics);
  if (!root) return std::nullopt;
  sdf::makeAddressesAbsolute(*root, file.parent_path());
  return sdf::printDocument(*root);
}

}  // namespace pongsim
