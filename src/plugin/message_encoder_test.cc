#include "pongsim/messages/message_encoder.hh"

#include <gtest/gtest.h>

#include <cstdlib>

namespace pongsim {
namespace {

class MessageEncoderTest : public testing::Test {
 protected:
  MessageEncoderTest() { setenv("PONGSIM_PLUGIN_PATH", PONGSIM_TEST_PLUGINS, 1); }

  /// @return The only error, and its hint in a second line: why the encoder can't be used.
  std::string reason(const std::string& name, const EncoderSettings& settings = {}) {
    Diagnostics diagnostics;
    EXPECT_EQ(makeMessageEncoder(name, settings, diagnostics), nullptr);
    if (diagnostics.all().size() != 1 || !diagnostics.hasErrors()) return "no reason";
    return diagnostics.all()[0].message + "\n" + diagnostics.all()[0].hint;
  }
};

TEST_F(MessageEncoderTest, ComesFromTheLibraryOfItsNameAndGetsItsSettings) {
  Diagnostics diagnostics;
  const auto encoder = makeMessageEncoder("encoding", {{"prefix", "/x"}}, diagnostics);
  ASSERT_NE(encoder, nullptr);
  EXPECT_TRUE(diagnostics.all().empty());
  EXPECT_EQ(encoder->profile(), "test");
  auto opened = encoder->openTopic("/a", "Text");
  ASSERT_TRUE(std::holds_alternative<std::unique_ptr<TopicEncoder>>(opened));
  TopicEncoder& topic = *std::get<std::unique_ptr<TopicEncoder>>(opened);
  EXPECT_EQ(topic.topics()[0].name, "/x/a");
  std::string taken;
  topic.encode(std::as_bytes(std::span(std::string_view("abc"))), [&taken](std::size_t, auto payload) {
    taken.assign(reinterpret_cast<const char*>(payload.data()), payload.size());
  });
  EXPECT_EQ(taken, "cba");
  EXPECT_EQ(std::get<std::string>(encoder->openTopic("/a", "Number")), "it is no text");
}

TEST_F(MessageEncoderTest, SaysItselfWhatIsWrongWithItsSettings) { EXPECT_EQ(reason("encoding"), "no prefix\n"); }

TEST_F(MessageEncoderTest, IsNamedWithItsPackageWhereItIsNotInstalled) {
  EXPECT_EQ(reason("ros2"),
            "the message encoder of 'ros2' is not installed\n"
            "the package pongsim-ros2 has it: apt-get install pongsim-ros2");
  EXPECT_EQ(reason("ros9"), "the message encoder of 'ros9' is not installed\n");
}

TEST_F(MessageEncoderTest, IsMissedInALibraryOfSystemsOrOfAnotherVersion) {
  EXPECT_NE(reason("counting").find("libpongsim-counting-system.so is not a message encoder"), std::string::npos);
  EXPECT_NE(reason("future").find("it needs a newer pongsim"), std::string::npos);
}

}  // namespace
}  // namespace pongsim
