#include "base/regular_file.hh"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>

#include "support/temp_folder.hh"

namespace pongsim::base {
namespace {

std::string contentOf(const std::filesystem::path& file, std::uint64_t largest = 1U << 20U) {
  auto read = readRegularFile(file, largest);
  if (const auto* unreadable = std::get_if<Unreadable>(&read)) return "(" + unreadable->reason + ")";
  return std::get<std::string>(read);
}

class RegularFileTest : public ::testing::Test {
 protected:
  test::TempFolder folder_;
};

TEST_F(RegularFileTest, IsReadWhole) {
  EXPECT_EQ(contentOf(folder_.write("empty", "")), "");
  EXPECT_EQ(contentOf(folder_.write("text", "some text")), "some text");
  const std::string long_(200'000, 'x');
  EXPECT_EQ(contentOf(folder_.write("long", long_)), long_);
  std::filesystem::create_symlink("text", folder_.path() / "link");
  EXPECT_EQ(contentOf(folder_.path() / "link"), "some text");
}

TEST_F(RegularFileTest, WithoutASizeIsReadToItsEnd) {
  EXPECT_NE(contentOf("/proc/self/status").find("Name:"), std::string::npos);
}

TEST_F(RegularFileTest, ThatIsTooLargeIsRefused) {
  const std::filesystem::path file = folder_.write("large", std::string((1U << 20U) + 1, 'x'));
  EXPECT_EQ(contentOf(file), "(is larger than 1 MiB, which is the limit)");
  EXPECT_EQ(contentOf(file, (1U << 20U) + 1).size(), (1U << 20U) + 1);
}

TEST_F(RegularFileTest, IsNothingElse) {
  EXPECT_EQ(contentOf(folder_.path() / "gone"), "(no such file)");
  EXPECT_EQ(contentOf(folder_.write("text", "") / "below"), "(no such file)");
  EXPECT_EQ(contentOf(folder_.path()), "(is a folder, not a file)");
  EXPECT_EQ(contentOf("/dev/zero"), "(is a device, not a file)");
  // a reader of a pipe that nobody writes would wait for ever
  const std::filesystem::path pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(contentOf(pipe), "(is a named pipe, not a file)");
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = (folder_.path() / "socket").string();
  ASSERT_LT(name.size(), sizeof address.sun_path);
  std::memcpy(address.sun_path, name.c_str(), name.size() + 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(contentOf(name), "(is a socket, not a file)");
  ::close(socket);
}

TEST_F(RegularFileTest, IsReadInParts) {
  const auto opened = RegularFile::open(folder_.write("text", "0123456789"));
  const auto& file = std::get<RegularFile>(opened);
  EXPECT_EQ(file.size(), 10U);
  std::string bytes(4, '.');
  EXPECT_EQ(file.readAt(3, bytes), 4U);
  EXPECT_EQ(bytes, "3456");
  EXPECT_EQ(file.readAt(8, bytes), 2U);
  EXPECT_EQ(bytes, "8956");
  EXPECT_EQ(file.readAt(20, bytes), 0U);
}

}  // namespace
}  // namespace pongsim::base
