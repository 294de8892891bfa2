#include "transport/names/type_name.hh"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pongsim::transport {

TEST(TypeName, IsTheFullOneOfAKnownType) {
  EXPECT_EQ(knownType("gz.msgs.Twist"), "ignition.msgs.Twist");
  EXPECT_EQ(anyType("Twist"), "ignition.msgs.Twist");
  EXPECT_EQ(anyType("acme.Rocket"), "acme.Rocket");
}

TEST(TypeName, IsRefusedWhereItIsUnknownOrNone) {
  EXPECT_THROW(knownType("acme.Rocket"), std::invalid_argument);
  EXPECT_THROW(anyType(""), std::invalid_argument);
  EXPECT_THROW(anyType(std::string(256, 'x')), std::invalid_argument);
  try {
    knownType("ignition.msgs.Twits");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean 'ignition.msgs.Twist'?"), std::string::npos);
  }
}

}  // namespace pongsim::transport
