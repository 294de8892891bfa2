#include "log/mcap/encoded_writer.hh"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/log/mcap_samples.hh"
#include "support/temp_folder.hh"

namespace pongsim::log {
namespace {

using samples::Kept;

/// Encodes "abc" on "/x" as "[abc]" on "/new/x" and on "/all"; refuses "damaged".
class InBrackets final : public TopicEncoder {
 public:
  explicit InBrackets(std::string_view topic)
      : topics_{{"/new" + std::string(topic), "new/Text", "brackets", "words", "[TEXT]", {{"size", "any"}}},
                {"/all", "new/Text", "brackets", "words", "[TEXT]", {}}} {}
  const std::vector<EncodedTopic>& topics() const override { return topics_; }
  void encode(std::span<const std::byte> message, const Take& take) override {
    const std::string text(reinterpret_cast<const char*>(message.data()), message.size());
    if (text == "damaged") throw std::runtime_error("7 bytes are no text");
    const std::string payload = "[" + text + "]";
    for (std::size_t i = 0; i < topics_.size(); ++i) take(i, std::as_bytes(std::span(payload)));
  }

 private:
  std::vector<EncodedTopic> topics_;
};

class TextEncoder final : public MessageEncoder {
 public:
  std::string_view profile() const override { return "brackets"; }
  std::variant<std::unique_ptr<TopicEncoder>, std::string> openTopic(std::string_view topic,
                                                                     std::string_view type) override {
    if (type != "Text") return std::string(type) + " is no text";
    return std::make_unique<InBrackets>(topic);
  }
};

class EncodedWriterTest : public testing::Test {
 protected:
  void write(const Kept& record) { writer_.write(record.record()); }

  test::TempFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
  std::vector<std::string> warnings_;
  EncodedWriter writer_{
      file_, {}, std::make_unique<TextEncoder>(), [this](const std::string& warning) { warnings_.push_back(warning); }};
};

TEST_F(EncodedWriterTest, WritesEachMessageInTheOtherEncoding) {
  write({5, "/x", "Text", "abc"});
  write({6, "/x", "Text", "d"});
  writer_.close();
  EXPECT_EQ(writer_.messages(), 4U);
  EXPECT_EQ(writer_.topics(), 2U);
  EXPECT_FALSE(writer_.hasLeftOut());
  const McapReader reader(file_);
  EXPECT_EQ(reader.profile(), "brackets");
  EXPECT_EQ(samples::readLog(reader), (std::vector<Kept>{{5, "/new/x", "new/Text", "[abc]"},
                                                         {5, "/all", "new/Text", "[abc]"},
                                                         {6, "/new/x", "new/Text", "[d]"},
                                                         {6, "/all", "new/Text", "[d]"}}));
  EXPECT_EQ(reader.definition("/new/x", "new/Text"), (Definition{"words", "[TEXT]", "brackets", {{"size", "any"}}}));
  EXPECT_EQ(reader.definition("/all", "new/Text"), (Definition{"words", "[TEXT]", "brackets", {}}));
}

TEST_F(EncodedWriterTest, LeavesOutATopicAndSaysSoOnce) {
  EXPECT_FALSE(writer_.takes("/n", "Number"));
  EXPECT_TRUE(writer_.takes("/x", "Text"));
  for (int i = 0; i < 3; ++i) write({i, "/n", "Number", "1"});
  write({4, "/m", "Number", "1"});
  writer_.close();
  EXPECT_EQ(warnings_,
            (std::vector<std::string>{"'/n' is left out: Number is no text", "'/m' is left out: Number is no text"}));
  EXPECT_TRUE(writer_.hasLeftOut());
  EXPECT_EQ(writer_.messages(), 0U);
  EXPECT_TRUE(samples::readLog(McapReader(file_)).empty());
}

TEST_F(EncodedWriterTest, LeavesOutWhatIsNoMessageAndGoesOn) {
  for (int i = 0; i < 3; ++i) write({i, "/x", "Text", "damaged"});
  write({4, "/x", "Text", "fine"});
  writer_.close();
  EXPECT_EQ(warnings_, (std::vector<std::string>{"a message of '/x' is left out: 7 bytes are no text"}));
  EXPECT_EQ(samples::readLog(McapReader(file_)).size(), 2U);
}

TEST_F(EncodedWriterTest, FailsWhereTheFileDoes) {
  EXPECT_THROW(write({-1, "/x", "Text", "before 1970"}), Failure);
  EXPECT_TRUE(warnings_.empty());
  writer_.close();
  EXPECT_THROW(write({1, "/x", "Text", "too late"}), Failure);
  EXPECT_THROW(EncodedWriter("/dev/full", {.overwrites = true}, std::make_unique<TextEncoder>(), nullptr).close(),
               Failure);
}

}  // namespace
}  // namespace pongsim::log
