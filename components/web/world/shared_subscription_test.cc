#include "web/world/shared_subscription.hh"

#include <gtest/gtest.h>

#include <cstring>

namespace pongsim::web {
namespace {

std::string textOf(const Payload& payload) {
  return {reinterpret_cast<const char*>(payload.bytes().data()), payload.size()};
}

/// Delivers a text to the topic, and counts how often it was serialized.
int say(SharedSubscription& topic, const std::string& text, std::uint64_t timeNs = 5) {
  int written = 0;
  topic.receive(
      text.size(),
      [&](std::span<std::byte> place) {
        std::memcpy(place.data(), text.data(), text.size());
        ++written;
      },
      timeNs);
  return written;
}

std::shared_ptr<const Listener> listener(std::string& received, bool wants = true) {
  return std::make_shared<const Listener>(Listener{[&received](const Payload& message, std::uint64_t timeNs) {
                                                     received += textOf(message) + "@" + std::to_string(timeNs) + " ";
                                                   },
                                                   [wants] { return wants; }});
}

TEST(SharedSubscription, WritesAMessageOnceForAllListeners) {
  SharedSubscription topic("/t", "T");
  std::string first;
  std::string second;
  topic.add(listener(first));
  topic.add(listener(second));
  EXPECT_EQ(say(topic, "a"), 1);
  EXPECT_EQ(first, "a@5 ");
  EXPECT_EQ(second, "a@5 ");
}

TEST(SharedSubscription, WritesNothingWhereNobodyWantsIt) {
  SharedSubscription topic("/t", "T");
  EXPECT_EQ(say(topic, "a"), 0);
  std::string received;
  topic.add(listener(received, false));
  EXPECT_EQ(say(topic, "a"), 0);
  EXPECT_EQ(received, "");
}

TEST(SharedSubscription, TellsTheLastToWhoComesLaterWhereItIsKept) {
  SharedSubscription topic("/t", "T");
  topic.keepLast(true);
  std::string first;
  std::string second;
  topic.add(listener(first, false));
  say(topic, "a", 7);
  topic.add(listener(second));
  EXPECT_EQ(first, "");
  EXPECT_EQ(second, "a@7 ");
}

TEST(SharedSubscription, DoesNotCallAListenerThatIsRemoved) {
  SharedSubscription topic("/t", "T");
  std::string received;
  const auto first = listener(received);
  topic.add(first);
  topic.remove(*first);
  say(topic, "a");
  EXPECT_EQ(received, "");
}

}  // namespace
}  // namespace pongsim::web
