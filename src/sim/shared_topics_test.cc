#include "sim/shared_topics.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/empty.pb.h>

#include <memory>
#include <string>
#include <vector>

namespace pongsim::sim::shared_topics_test {
namespace {

using ignition::msgs::Empty;
using Texts = std::vector<std::string>;

class SharedTopics : public testing::Test {
 protected:
  SharedTopics() {
    for (const char* name : {"a", "b"}) {
      Diagnostics diagnostics;
      worlds_.push_back(Simulation::fromText("<sdf version='1.9'><world name='" + std::string(name) + "'/></sdf>",
                                             "world.sdf", {.loadSystems = false}, diagnostics));
    }
  }
  Node node(std::size_t world) { return worlds_[world]->transport().node(); }
  Texts warnings() {
    Diagnostics diagnostics;
    warnOfSharedTopics(worlds_, {{}, {}}, diagnostics);
    Texts messages;
    for (const Diagnostic& each : diagnostics.all()) messages.push_back(each.message);
    return messages;
  }

  std::vector<std::unique_ptr<Simulation>> worlds_;
};

TEST_F(SharedTopics, AreNoneWhereEachHasItsOwn) {
  const Publisher one = node(0).advertise<Empty>("/a"), two = node(1).advertise<Empty>("/b");
  // both worlds subscribe, and neither publishes
  const Subscription three = node(0).subscribe<Empty>("/go", [](const Empty&) {});
  const Subscription four = node(1).subscribe<Empty>("/go", [](const Empty&) {});
  EXPECT_EQ(warnings(), Texts{});
}

TEST_F(SharedTopics, AreThoseOnWhichBothPublish) {
  std::vector<Publisher> publishers;
  publishers.push_back(node(0).advertise<Empty>("/x"));
  publishers.push_back(node(1).advertise<Empty>("/x"));
  EXPECT_EQ(warnings(), Texts{"world 'a' and world 'b' publish on the same topic '/x'"});
  for (const char* topic : {"/y", "/z", "/w", "/v"}) {
    for (std::size_t world : {0U, 1U}) publishers.push_back(node(world).advertise<Empty>(topic));
  }
  EXPECT_EQ(warnings(), Texts{"world 'a' and world 'b' publish on the same topics '/v', '/w', '/x' and 2 more"});
}

TEST_F(SharedTopics, AreThoseOnWhichOneHearsTheOther) {
  const Publisher publisher = node(1).advertise<Empty>("/x");
  const Subscription subscription = node(0).subscribe<Empty>("/x", [](const Empty&) {});
  EXPECT_EQ(warnings(), Texts{"world 'a' subscribes to what world 'b' publishes: topic '/x'"});
}

}  // namespace
}  // namespace pongsim::sim::shared_topics_test
