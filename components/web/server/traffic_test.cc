#include "web/server/traffic.hh"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace pongsim::web {
namespace {

using Counts = std::map<std::string, ClientTraffic::Count>;

TEST(Traffic, CountsByTheTopicOfAKey) {
  ClientTraffic traffic(1, "127.0.0.1", "p");
  traffic.name(1, "/a");
  traffic.name(2, "/b");
  traffic.add(1, 100);
  traffic.add(1, 50);
  traffic.add(2, 7);
  traffic.add(3, 5);
  traffic.add(std::nullopt, 1);
  EXPECT_EQ(traffic.counts(), (Counts{{"", {2, 6}}, {"/a", {2, 150}}, {"/b", {1, 7}}}));
  // the key has another topic now
  traffic.name(1, "/b");
  traffic.add(1, 3);
  EXPECT_EQ(traffic.counts()["/b"], (ClientTraffic::Count{2, 10}));
}

TEST(Traffic, OfEverNewTopicsIsCountedTogether) {
  ClientTraffic traffic(1, "127.0.0.1", "p");
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    traffic.name(i, "/t" + std::to_string(i));
    traffic.add(i, 1);
  }
  EXPECT_LT(traffic.counts().size(), 5000U);
  EXPECT_GT(traffic.counts()[""].bytes, 5000U);
}

TEST(Traffic, ListsTheClientsThatThereAre) {
  TrafficBook book;
  const auto one = book.add("127.0.0.1", "p");
  auto two = book.add("192.0.2.7", "q");
  ASSERT_EQ(book.all().size(), 2U);
  EXPECT_EQ(book.all()[1]->address(), "192.0.2.7");
  EXPECT_EQ(book.all()[1]->protocol(), "q");
  EXPECT_NE(book.all()[1]->number(), one->number());
  two.reset();
  ASSERT_EQ(book.all().size(), 1U);
  EXPECT_EQ(book.all()[0]->address(), "127.0.0.1");
}

}  // namespace
}  // namespace pongsim::web
