#include "msgs/fields/field_reader.hh"

#include <gtest/gtest.h>

#include <vector>

namespace pongsim::msgs {
namespace {

TEST(FieldReader, ReadsNumbersWholeNumbersListsAndWhatIsWithin) {
  const MessagePointer scan = newMessage("LaserScan");
  ASSERT_FALSE(
      parseMessage("angle_min: -1.5, count: 4000000000, ranges: [1, inf], header {stamp {sec: -3 nsec: 5}}", *scan));
  const FieldReader reader(*scan);
  EXPECT_EQ(reader.number("angle_min"), -1.5);
  EXPECT_EQ(reader.whole("count"), 4'000'000'000) << "an uint32";
  EXPECT_EQ(reader.numbers("ranges").size(), 2U);
  EXPECT_EQ(reader.numbers("intensities"), std::vector<double>());
  const FieldReader stamp = reader.inside("header").inside("stamp");
  EXPECT_EQ(stamp.whole("sec"), -3) << "an int64";
  EXPECT_EQ(stamp.whole("nsec"), 5) << "an int32";
}

TEST(FieldReader, ReadsDefaultsWhereNothingIsSet) {
  const MessagePointer image = newMessage("Image");
  const FieldReader reader(*image);
  EXPECT_EQ(reader.whole("pixel_format_type"), 0) << "an enumeration";
  EXPECT_EQ(reader.inside("header").inside("stamp").whole("sec"), 0);
  const MessagePointer point = newMessage("Float");
  ASSERT_FALSE(parseMessage("data: 0.25", *point));
  EXPECT_EQ(FieldReader(*point).number("data"), 0.25) << "a float";
}

}  // namespace
}  // namespace pongsim::msgs
