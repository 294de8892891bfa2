#include "sdf/text/file_text.hh"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <variant>
#include <vector>

#include "base/nearest_word.hh"
#include "base/regular_file.hh"

namespace pongsim::sdf {

namespace fs = std::filesystem;

namespace {

// Enough to find a misspelt name; in folders with more entries the search stops here.
constexpr std::size_t kMostNeighbours = 10'000;

std::string hintForMissing(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error)) return "there is no folder '" + folder.string() + "' either";
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end && names.size() < kMostNeighbours;
       entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  const std::vector<std::string_view> known(names.begin(), names.end());
  const std::string_view nearest = base::nearestWord(file.filename().string(), known);
  if (nearest.empty()) return {};
  return "did you mean '" + (file.parent_path() / nearest).string() + "'?";
}

/// @return The content of what is no regular file: a pipe, or a device.
std::variant<std::string, base::Unreadable> readStream(const fs::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return base::Unreadable{std::string("can't be read: ") + std::strerror(errno)};
  std::string text;
  std::vector<char> chunk(std::size_t{1} << 16U);
  while (stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), stream.gcount() > 0) {
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kLargestFile) {
      return base::Unreadable{"is larger than " + std::to_string(kLargestFile >> 20U) + " MiB, which is the limit"};
    }
  }
  if (stream.bad()) return base::Unreadable{"can't be read completely"};
  return text;
}

}  // namespace

std::optional<std::string> readFileText(const fs::path& file, std::shared_ptr<const std::string> name, NamedBy by,
                                        Diagnostics& diagnostics) {
  const auto fail = [&](std::string message, std::string hint = {}) {
    diagnostics.error({name}, std::move(message), std::move(hint));
    return std::nullopt;
  };
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) return fail("is a folder, not a file", "name a world file in it");
  const bool isStream = by == NamedBy::kUser && fs::exists(status) && !fs::is_regular_file(status);
  auto read = isStream ? readStream(file) : base::readRegularFile(file, kLargestFile);
  if (const auto* unreadable = std::get_if<base::Unreadable>(&read)) {
    return fail(unreadable->reason, status.type() == fs::file_type::not_found ? hintForMissing(file) : "");
  }
  auto& text = std::get<std::string>(read);
  if (text.empty()) return fail("the file is empty");
  return std::move(text);
}

}  // namespace pongsim::sdf
