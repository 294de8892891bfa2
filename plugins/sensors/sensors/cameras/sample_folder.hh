#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pongsim {

/// Folder of the images of samples.
inline constexpr const char* kSampleImages = "images";

/// @return A file of a sample, as Fortress names it: FOLDER/KIND_0000012.png.
/// @param folder Of this kind of file; it is created.
inline std::filesystem::path sampleFile(const std::filesystem::path& folder, const std::string& kind,
                                        std::uint64_t number, const std::string& extension) {
  std::filesystem::create_directories(folder);
  std::string digits = std::to_string(number);
  constexpr std::size_t kDigits = 7;
  if (digits.size() < kDigits) digits.insert(0, kDigits - digits.size(), '0');
  return folder / (kind + "_" + digits + extension);
}

/// @return The number of files in a folder, so that a new run goes on behind the samples of earlier ones; 0 without
/// the folder.
inline std::uint64_t filesIn(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::uint64_t count = 0;
  for (auto entry = std::filesystem::directory_iterator(folder, ignored);
       entry != std::filesystem::directory_iterator(); entry.increment(ignored)) {
    ++count;
  }
  return count;
}

}  // namespace pongsim
