#include "web/server/media_type.hh"

#include <gtest/gtest.h>

namespace pongsim::web {
namespace {

TEST(MediaType, GoesByTheExtensionInAnyCase) {
  EXPECT_EQ(mediaType("/a/arm.DAE"), "model/vnd.collada+xml");
  EXPECT_EQ(mediaType("page.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(mediaType("a.b.png"), "image/png");
}

TEST(MediaType, IsNoneOfWhatNeitherPagesNorWorldsConsistOf) {
  for (const char* name : {"/etc/passwd", "id_rsa", ".png", "key.pem", "world.sdf", "a.js.gz", ""})
    EXPECT_EQ(mediaType(name), "") << name;
}

}  // namespace
}  // namespace pongsim::web
