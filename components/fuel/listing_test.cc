#include "fuel/listing.hh"

#include <gtest/gtest.h>

namespace pongsim::fuel {
namespace {

TEST(Listing, IsATreeAsIgnFuelPrintsIt) {
  std::vector<Details> all(3);
  all[0].owner = "b", all[0].name = "x";
  all[1].owner = "a", all[1].name = "z";
  all[2].owner = "a", all[2].name = "y y";
  const Listing listing = listingOf(all);
  EXPECT_EQ(treeOf("https://h", listing, "models", false),
            "https://h\n├── a\n│   ├── y y\n│   └── z\n└── b\n    └── x\n2 owners, 3 models\n");
  EXPECT_TRUE(treeOf("https://h", listing, "models", true).starts_with("\x1b[92m\x1b[1mhttps://h\x1b[0m\n"));
  EXPECT_EQ(addressesOf("https://h", listing, true),
            "https://h/1.0/a/worlds/y%20y\nhttps://h/1.0/a/worlds/z\nhttps://h/1.0/b/worlds/x\n");
  EXPECT_EQ(treeOf("https://h", {}, "worlds", false), "https://h\n0 owners, 0 worlds\n");
}

TEST(Listing, DescribesWhatIsKnown) {
  Details details;
  details.name = "m";
  details.owner = "o";
  EXPECT_EQ(descriptionOf(details), "Name: m\nOwner: o\n");
  details.version = 3;
  details.bytes = 1'234'567;
  details.tags = {"a", "b"};
  EXPECT_EQ(descriptionOf(details), "Name: m\nOwner: o\nVersion: 3\nSize: 1.2 MB\nTags: a, b\n");
}

}  // namespace
}  // namespace pongsim::fuel
