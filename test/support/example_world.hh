#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/fortress_worlds.hh"

namespace pongsim::test {

/// @param file A system's example world, relative to the project's folder.
/// @return Its content from the first model on, for a `RunningWorld`.
inline std::string modelsOf(const std::filesystem::path& file) {
  std::ifstream stream(projectFolder() / file);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t begin = text.find("<model");
  const std::size_t end = text.find("</world>");
  EXPECT_NE(begin, std::string::npos) << file;
  if (begin == std::string::npos || end == std::string::npos) return {};
  return text.substr(begin, end - begin);
}

/// @return `text` with the first `from` replaced by `to`; a test fails if it is not there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t position = text.find(from);
  EXPECT_NE(position, std::string::npos) << from;
  if (position != std::string::npos) text.replace(position, from.size(), to);
  return text;
}

}  // namespace pongsim::test
