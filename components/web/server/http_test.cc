#include "web/server/http.hh"

#include <gtest/gtest.h>

#include <filesystem>
#include <optional>

#include "support/temp_folder.hh"

namespace pongsim::web {
namespace {

TEST(PageFile, IsOneOfTheFoldersFiles) {
  const pongsim::test::TempFolder folder;
  const std::filesystem::path page = folder.path() / "page";
  folder.write("page/index.html", "");
  folder.write("page/deep/main.js", "");
  EXPECT_EQ(pageFile(page, "/"), std::filesystem::canonical(page / "index.html"));
  EXPECT_EQ(pageFile(page, "/deep/main.js"), std::filesystem::canonical(page / "deep/main.js"));
}

TEST(PageFile, IsNeverOutsideOfTheFolder) {
  const pongsim::test::TempFolder folder;
  const std::filesystem::path page = folder.path() / "page";
  folder.write("page/index.html", "");
  folder.write("page/notes", "");
  folder.write("page/deep/a.js", "");
  folder.write("secret.txt", "");
  std::filesystem::create_symlink(folder.path() / "secret.txt", page / "link.txt");
  for (const char* path : {"/../secret.txt", "/deep/../../secret.txt", "//etc/hostname.txt", "/link.txt", "/notes",
                           "/deep", "/none.js", "", "index.html"}) {
    EXPECT_EQ(pageFile(page, path), std::nullopt) << path;
  }
  EXPECT_EQ(pageFile("", "/"), std::nullopt);
  EXPECT_EQ(pageFile(folder.path() / "none", "/"), std::nullopt);
}

}  // namespace
}  // namespace pongsim::web
