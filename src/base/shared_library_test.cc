#include "base/shared_library.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <variant>

namespace pongsim::base {
namespace {

TEST(SharedLibrary, GivesTheFunctionsOfALibraryThatTheSystemKnows) {
  const auto opened = SharedLibrary::open("libm.so.6");
  const auto& library = std::get<SharedLibrary>(opened);
  auto* cosine = library.find<double(double)>("cos");
  ASSERT_NE(cosine, nullptr);
  EXPECT_EQ(cosine(0), 1);
  EXPECT_EQ(library.find<double(double)>("no_such_function"), nullptr);
}

TEST(SharedLibrary, SaysWhyItCanNotBeOpened) {
  const auto opened = SharedLibrary::open("libno-such-library.so.1");
  EXPECT_NE(std::get<std::string>(opened).find("libno-such-library.so.1"), std::string::npos);
}

TEST(SharedLibrary, SaysWhatToInstallWhereItIsRequired) {
  try {
    SharedLibrary::require("libno-such-library.so.1", "no-such-package");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("apt-get install no-such-package"), std::string::npos) << error.what();
  }
}

TEST(SharedLibrary, ThrowsWhereAFunctionToBindIsMissing) {
  const SharedLibrary library = SharedLibrary::require("libm.so.6", "libc6");
  double (*function)(double) = nullptr;
  library.bind(function, "sin");
  EXPECT_EQ(function(0), 0);
  EXPECT_THROW(library.bind(function, "no_such_function"), std::runtime_error);
}

TEST(SharedLibrary, KnowsTheFileThatItsCodeCameFrom) {
  EXPECT_EQ(ownLibraryFile(), std::filesystem::read_symlink("/proc/self/exe"));
}

}  // namespace
}  // namespace pongsim::base
