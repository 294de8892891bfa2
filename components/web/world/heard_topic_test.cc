#include "web/world/heard_topic.hh"

#include <gtest/gtest.h>

#include <cstring>

namespace pongsim::web {
namespace {

std::string textOf(const Payload& payload) {
  return {reinterpret_cast<const char*>(payload.bytes().data()), payload.size()};
}

/// Delivers a text to the topic, and counts how often it was serialized.
int say(HeardTopic& topic, const std::string& text, std::uint64_t timeNs = 5) {
  int written = 0;
  topic.heard(
      text.size(),
      [&](std::span<std::byte> place) {
        std::memcpy(place.data(), text.data(), text.size());
        ++written;
      },
      timeNs);
  return written;
}

std::shared_ptr<const Listener> listener(std::string& heard, bool wants = true) {
  return std::make_shared<const Listener>(Listener{[&heard](const Payload& message, std::uint64_t timeNs) {
                                                     heard += textOf(message) + "@" + std::to_string(timeNs) + " ";
                                                   },
                                                   [wants] { return wants; }});
}

TEST(HeardTopic, WritesAMessageOnceForAllListeners) {
  HeardTopic topic("/t", "T");
  std::string first;
  std::string second;
  topic.add(listener(first));
  topic.add(listener(second));
  EXPECT_EQ(say(topic, "a"), 1);
  EXPECT_EQ(first, "a@5 ");
  EXPECT_EQ(second, "a@5 ");
}

TEST(HeardTopic, WritesNothingWhereNobodyWantsIt) {
  HeardTopic topic("/t", "T");
  EXPECT_EQ(say(topic, "a"), 0);
  std::string heard;
  topic.add(listener(heard, false));
  EXPECT_EQ(say(topic, "a"), 0);
  EXPECT_EQ(heard, "");
}

TEST(HeardTopic, TellsTheLastToWhoComesLaterWhereItIsKept) {
  HeardTopic topic("/t", "T");
  topic.keepLast(true);
  std::string first;
  std::string second;
  topic.add(listener(first, false));
  say(topic, "a", 7);
  topic.add(listener(second));
  EXPECT_EQ(first, "");
  EXPECT_EQ(second, "a@7 ");
}

TEST(HeardTopic, DoesNotCallAListenerThatIsRemoved) {
  HeardTopic topic("/t", "T");
  std::string heard;
  const auto ear = listener(heard);
  topic.add(ear);
  topic.remove(*ear);
  say(topic, "a");
  EXPECT_EQ(heard, "");
}

}  // namespace
}  // namespace pongsim::web
