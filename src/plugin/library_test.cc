#include "plugin/library.hh"

#include <gtest/gtest.h>

#include "support/temp_folder.hh"

namespace pongsim::plugin {
namespace {

std::filesystem::path testLibrary(const std::string& name) {
  return std::filesystem::path(PONGSIM_TEST_PLUGINS) / ("libpongsim-" + name + "-system.so");
}

/// @return Why the library can't be used.
std::string reason(const std::filesystem::path& file) {
  auto opened = Library::open(file);
  const std::string* text = std::get_if<std::string>(&opened);
  return text != nullptr ? *text : "no reason";
}

TEST(Library, OffersItsSystems) {
  auto opened = Library::open(testLibrary("counting"));
  ASSERT_TRUE(std::holds_alternative<std::unique_ptr<Library>>(opened));
  const Library& library = *std::get<std::unique_ptr<Library>>(opened);
  ASSERT_EQ(library.systems().size(), 1U);
  EXPECT_STREQ(library.systems()[0].names[0], "test::Counting");
  const std::unique_ptr<System> system(library.systems()[0].create());
  EXPECT_NE(system, nullptr);
}

// Both need missing functions; the version is reported nevertheless.
TEST(Library, RefusesAnotherVersionOfTheInterfaceAndSaysWhichIsTooOld) {
  const std::string here = " of pongsim's plugin interface, this is version " + std::to_string(kAbiVersion);
  EXPECT_EQ(reason(testLibrary("ancient")), "it is built for version 0" + here + ": rebuild it");
  EXPECT_EQ(reason(testLibrary("future")),
            "it is built for version " + std::to_string(kAbiVersion + 1) + here + ": it needs a newer pongsim");
}

TEST(Library, SaysWhatToDoWhereAFunctionOfPongsimIsMissing) {
  const std::string text = reason(testLibrary("lacking"));
  EXPECT_NE(text.find("functionOfAnotherVersion"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with(": it was built for another version of pongsim; rebuild it")) << text;
}

TEST(Library, RefusesALibraryWithoutSystems) {
  EXPECT_EQ(reason(testLibrary("empty")), "it does not export any pongsim system");
}

TEST(Library, RefusesAFileThatIsNoLibrary) {
  const test::TempFolder folder;
  EXPECT_NE(reason(folder.write("libx.so", "not a library")).find("libx.so"), std::string::npos);
}

}  // namespace
}  // namespace pongsim::plugin
