#include "fuel/details.hh"

#include <gtest/gtest.h>

#include "fuel/failure.hh"

namespace pongsim::fuel {
namespace {

TEST(Details, HasWhatTheServerTells) {
  const Details details = parseDetails(
      R"({"owner": "o", "name": "n\u001b[2J", "version": 3, "filesize": 5000000000, "private": true, "tags": ["a", 1]})");
  EXPECT_EQ(details.owner, "o");
  EXPECT_EQ(details.name, "n [2J");
  EXPECT_EQ(details.version, 3);
  EXPECT_EQ(details.bytes, 5'000'000'000U);
  EXPECT_TRUE(details.isPrivate);
  EXPECT_EQ(details.tags, std::vector<std::string>{"a"});
}

TEST(Details, TakesAbsurdValuesForUnknownOnes) {
  const Details details = parseDetails(R"({"name": "n", "version": 99999999999, "filesize": -1, "owner": 7})");
  EXPECT_EQ(details.version, 0);
  EXPECT_EQ(details.bytes, 0U);
  EXPECT_EQ(details.owner, "");
}

TEST(Details, RefusesWhatIsNoneOrNoList) {
  EXPECT_THROW(parseDetails("<html>"), PassingFailure);
  EXPECT_THROW(parseDetails("[]"), Failure);
  EXPECT_THROW(parseDetails("{}"), Failure);
  EXPECT_THROW(parseDetailsList("{}"), Failure);
  EXPECT_THROW(parseDetailsList("[1]"), Failure);
  EXPECT_TRUE(parseDetailsList("null").empty());
  EXPECT_EQ(parseDetailsList(R"([{"name": "a"}, {"name": "b"}])").size(), 2U);
}

}  // namespace
}  // namespace pongsim::fuel
