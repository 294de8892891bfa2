#include "msgs/definition.hh"

#include <gtest/gtest.h>

namespace pongsim::msgs {
namespace {

TEST(Definition, IsThatOfProtobuf) {
  EXPECT_EQ(definition("gz.msgs.Boolean"),
            "message Boolean {\n  .ignition.msgs.Header header = 1;\n  bool data = 2;\n}\n");
}

TEST(Definition, IsNotThereForAnUnknownType) { EXPECT_EQ(definition("Boolan"), std::nullopt); }

}  // namespace
}  // namespace pongsim::msgs
