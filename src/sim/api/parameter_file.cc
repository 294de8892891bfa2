#include "pongsim/files/parameter_file.hh"

#include <filesystem>
#include <optional>
#include <utility>
#include <variant>

#include "assets/finder.hh"
#include "base/regular_file.hh"

namespace pongsim {

std::string parameterFile(const Element& element, std::uint64_t largest) {
  const std::shared_ptr<const std::string>& holder = element.position.file;
  const std::filesystem::path folder = holder ? std::filesystem::path(*holder).parent_path() : std::filesystem::path();
  Diagnostics diagnostics;
  const std::optional<std::filesystem::path> file =
      assets::finderFromEnvironment()(element.text, folder, element.position, diagnostics);
  if (!file) throw Error(diagnostics.all().front());
  auto read = base::readRegularFile(*file, largest);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&read)) {
    throw Error({Severity::kError, element.position, "'" + element.text + "' " + unreadable->reason, {}});
  }
  return std::get<std::string>(std::move(read));
}

}  // namespace pongsim
