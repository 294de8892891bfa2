#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "integration/program.hh"

namespace pongsim::test {
namespace {

TEST(Msg, ListsTheTypesSorted) {
  const Outcome list = runToEnd({"msg", "-l"});
  EXPECT_EQ(list.exitCode, 0) << list.error;
  const std::vector<std::string> types = lines(list.output);
  EXPECT_TRUE(std::is_sorted(types.begin(), types.end()));
  EXPECT_TRUE(std::binary_search(types.begin(), types.end(), "ignition.msgs.Twist")) << list.output;
}

TEST(Msg, PrintsADefinition) {
  const Outcome info = runToEnd({"msg", "-i", "Boolean"});
  EXPECT_EQ(info.exitCode, 0) << info.error;
  EXPECT_EQ(info.output,
            "// ignition.msgs.Boolean\n// Boolean message\nmessage Boolean {\n  // Optional header data\n"
            "  .ignition.msgs.Header header = 1;\n  // Boolean data\n  bool data = 2;\n}\n");
}

TEST(Msg, PrintsATemplate) {
  const Outcome text = runToEnd({"msg", "-t", "Boolean"});
  EXPECT_EQ(text.exitCode, 0) << text.error;
  EXPECT_TRUE(text.output.ends_with("\ndata: false\n")) << text.output;
}

TEST(Msg, GuessesTheTypeThatWasMeant) {
  const Outcome wrong = runToEnd({"msg", "-i", "ignition.msgs.Twst"});
  EXPECT_EQ(wrong.exitCode, 2);
  EXPECT_NE(wrong.error.find("did you mean 'ignition.msgs.Twist'?"), std::string::npos) << wrong.error;
  EXPECT_EQ(runToEnd({"msg"}).exitCode, 2);
}

TEST(Msg, PrintsJsonToo) {
  EXPECT_TRUE(runToEnd({"msg", "-l", "--json"}).output.starts_with("[\"ignition.msgs."));
  const Outcome info = runToEnd({"msg", "-i", "Int32", "--json"});
  EXPECT_TRUE(info.output.starts_with("{\"type\":\"ignition.msgs.Int32\",\"definition\":\"")) << info.output;
}

}  // namespace
}  // namespace pongsim::test
