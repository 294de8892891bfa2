#include "fuel/server.hh"

#include <gtest/gtest.h>

namespace pongsim::fuel {
namespace {

// Requests are tested by test/test_download.py and test/test_command.py.

TEST(FuelServer, HasCollections) {
  const auto collection = parseCollection("https://fuel.gazebosim.org/1.0/Open%20Robotics/collections/My Set");
  ASSERT_TRUE(collection);
  EXPECT_EQ(collection->owner, "Open Robotics");
  EXPECT_EQ(collection->name, "My Set");
  EXPECT_EQ(collection->server.host, "fuel.gazebosim.org");
  for (const char* text :
       {"https://h/1.0/o/models/m", "https://h/1.0/o/collections", "https://h/1.0/o/collections/",
        "https://h/1.0/o/collections/c/2", "https://h/1.0/../collections/c", "ftp://h/o/collections/c"}) {
    EXPECT_FALSE(parseCollection(text)) << text;
  }
}

}  // namespace
}  // namespace pongsim::fuel
