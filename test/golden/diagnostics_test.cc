// Compares the messages for the most likely mistakes with those in test/golden/diagnostics. There each case has a
// heading, the file with the mistake, and its messages. With PONGSIM_WRITE_GOLDEN the files are rewritten instead.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "pongsim/diagnostic.hh"
#include "sdf/loader.hh"
#include "support/fortress_worlds.hh"

namespace pongsim::test {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHeading = "=== ";
constexpr std::string_view kEnd = "---";

struct Mistake {
  std::string title;
  std::string file;
  std::string said;
};

std::vector<Mistake> mistakesIn(const fs::path& file) {
  std::ifstream stream(file);
  std::vector<Mistake> mistakes;
  bool isSaid = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with(kHeading)) {
      mistakes.push_back({line.substr(kHeading.size()), {}, {}});
      isSaid = false;
    } else if (line == kEnd) {
      isSaid = true;
    } else if (!mistakes.empty()) {
      (isSaid ? mistakes.back().said : mistakes.back().file) += line + "\n";
    }
  }
  return mistakes;
}

std::string lineOf(const std::string& text, int number) {
  std::istringstream stream(text);
  std::string line;
  for (int i = 0; i < number; ++i) std::getline(stream, line);
  return line;
}

std::string saidOf(const std::string& text) {
  Diagnostics diagnostics;
  // the same paths on every machine
  sdf::loadText(text, "world.sdf", diagnostics, assets::finderIn({.folders = {"/models"}, .fuelCache = "/fuel"}));
  std::string said;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    const std::string line = lineOf(text, diagnostic.position.line);
    said += format(diagnostic, {.text = line}) + "\n";
  }
  return said;
}

void write(const fs::path& file, const std::vector<Mistake>& mistakes) {
  std::ofstream stream(file);
  for (const Mistake& mistake : mistakes) {
    stream << kHeading << mistake.title << "\n" << mistake.file << kEnd << "\n" << saidOf(mistake.file);
  }
}

class DiagnosticsOf : public testing::TestWithParam<const char*> {};

TEST_P(DiagnosticsOf, MistakesAreAsWrittenDown) {
  const fs::path file = projectFolder() / "test/golden/diagnostics" / GetParam();
  const std::vector<Mistake> mistakes = mistakesIn(file);
  if (std::getenv("PONGSIM_WRITE_GOLDEN") != nullptr) return write(file, mistakes);
  EXPECT_GE(mistakes.size(), 4U) << file;
  for (const Mistake& mistake : mistakes) {
    EXPECT_NE(mistake.said, "") << mistake.title;
    EXPECT_EQ(saidOf(mistake.file), mistake.said) << mistake.title;
  }
}

INSTANTIATE_TEST_SUITE_P(Golden, DiagnosticsOf,
                         testing::Values("files.txt", "frames.txt", "joints.txt", "names.txt", "values.txt", "xml.txt"),
                         [](const auto& instance) {
                           const std::string name = instance.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace pongsim::test
