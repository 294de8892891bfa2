#include "sdf/text/file_text.hh"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>
#include <thread>

#include "support/temp_folder.hh"

namespace pongsim::sdf {
namespace {

class FileText : public ::testing::Test {
 protected:
  std::optional<std::string> read(const std::filesystem::path& file, NamedBy by = NamedBy::kUser) {
    return readFileText(file, std::make_shared<const std::string>("name"), by, diagnostics_);
  }

  std::string message() const { return diagnostics_.all().size() == 1 ? format(diagnostics_.all()[0]) : ""; }

  pongsim::test::TempFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(FileText, IsTheWholeFile) {
  const std::string content = std::string(200'000, 'x') + std::string("\0\n", 2);
  EXPECT_EQ(read(folder_.write("a.sdf", content)), content);
  EXPECT_EQ(message(), "");
}

TEST_F(FileText, NamesTheNearestFileForAMissingOne) {
  folder_.write("moving_robot.sdf", "x");
  EXPECT_FALSE(read(folder_.path() / "moving_robt.sdf"));
  EXPECT_EQ(message(), "name: error: no such file\n  hint: did you mean '" +
                           (folder_.path() / "moving_robot.sdf").string() + "'?");
}

TEST_F(FileText, SaysThatTheFolderIsMissingToo) {
  EXPECT_FALSE(read(folder_.path() / "nosuch/a.sdf"));
  EXPECT_EQ(message(), "name: error: no such file\n  hint: there is no folder '" +
                           (folder_.path() / "nosuch").string() + "' either");
}

TEST_F(FileText, IsNotAFolder) {
  EXPECT_FALSE(read(folder_.path()));
  EXPECT_EQ(message(), "name: error: is a folder, not a file\n  hint: name a world file in it");
}

TEST_F(FileText, IsNotEmpty) {
  EXPECT_FALSE(read(folder_.write("a.sdf", "")));
  EXPECT_EQ(message(), "name: error: the file is empty");
}

TEST_F(FileText, HasALargestSize) {
  EXPECT_FALSE(read("/dev/zero"));
  EXPECT_EQ(message(), "name: error: is larger than 256 MiB, which is the limit");
}

TEST_F(FileText, ThatContentNamesIsARegularFile) {
  EXPECT_EQ(read(folder_.write("a.sdf", "x"), NamedBy::kContent), "x");
  EXPECT_FALSE(read("/dev/zero", NamedBy::kContent));
  EXPECT_EQ(message(), "name: error: is a device, not a file");
  // without a writer: reading it would not end
  const std::filesystem::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  diagnostics_ = Diagnostics();
  EXPECT_FALSE(read(pipe, NamedBy::kContent));
  EXPECT_EQ(message(), "name: error: is a named pipe, not a file");
}

TEST_F(FileText, MayBeAPipeOfTheUser) {
  const std::filesystem::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "some text"; });
  EXPECT_EQ(read(pipe), "some text");
  writer.join();
}

}  // namespace
}  // namespace pongsim::sdf
