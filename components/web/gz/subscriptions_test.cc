#include "web/gz/subscriptions.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/stringmsg.pb.h>

#include "support/web/recorded_client.hh"
#include "support/web/stepped_world.hh"

namespace pongsim::web::gz {
namespace {

namespace im = ignition::msgs;

class ListeningTest : public testing::Test {
 protected:
  ListeningTest() { settings_.publicationHz = 1e9; }

  /// Publishes until the client has received something.
  std::string received(Publisher& publisher, const Message& message) {
    std::vector<std::string> got;
    world_.stepUntil([&] {
      subscriptions_.follow();
      publisher.publish(message);
      client_->free();
      got = client_->takeBinaries();
      return !got.empty();
    });
    return got.empty() ? "" : got.front();
  }

  std::shared_ptr<Worlds> worlds_ = std::make_shared<Worlds>();
  SteppedWorld world_{worlds_};
  std::shared_ptr<void> watch_ = worlds_->watch({.changed = [] {}});
  std::shared_ptr<RecordedClient> client_ = std::make_shared<RecordedClient>();
  GzSettings settings_;
  Subscriptions subscriptions_{client_, worlds_, settings_};
};

TEST_F(ListeningTest, HearsATopicThatComesLater) {
  EXPECT_EQ(subscriptions_.add("/t", false), "");
  auto publisher = world_.node().advertise<im::StringMsg>("/t");
  im::StringMsg message;
  message.set_data("x");
  EXPECT_EQ(received(publisher, message), "pub,/t,ignition.msgs.StringMsg," + message.SerializeAsString());
}

TEST_F(ListeningTest, MakesPicturesOfImages) {
  EXPECT_EQ(subscriptions_.add("/t", true), "");
  auto publisher = world_.node().advertise<im::Image>("/t");
  im::Image image;
  image.set_width(1);
  image.set_height(1);
  image.set_pixel_format_type(im::L_INT8);
  image.set_data("x");
  EXPECT_TRUE(received(publisher, image).starts_with("pub,/t,ignition.msgs.Image,\x89PNG"));
}

TEST_F(ListeningTest, RefusesWhatItCannotHear) {
  auto publisher = world_.node().advertise<im::StringMsg>("/t");
  ASSERT_TRUE(world_.stepUntil([&] { return !worlds_->topics().empty(); }));
  EXPECT_EQ(subscriptions_.add("/t", true), "topic '/t' has messages of type ignition.msgs.StringMsg, not images");
  EXPECT_NE(subscriptions_.add("a b", false), "");
  EXPECT_NE(subscriptions_.limit("/t", 0), "");
  EXPECT_NE(subscriptions_.limit("/t", -3), "");
  EXPECT_NE(subscriptions_.limit("/" + std::string(1000, 'a'), 1), "");
  for (int i = 0; i < 10'000; ++i) subscriptions_.add("/many" + std::to_string(i), false);
  EXPECT_EQ(subscriptions_.add("/more", false), "a client can subscribe to at most 1000 topics; '/more' is one more");
}

TEST_F(ListeningTest, LimitsTopicsOfAType) {
  settings_.subscriptionLimits["ignition.msgs.StringMsg"] = 1;
  auto first = world_.node().advertise<im::StringMsg>("/a");
  auto second = world_.node().advertise<im::StringMsg>("/b");
  ASSERT_TRUE(world_.stepUntil([&] { return worlds_->topics().size() == 2; }));
  EXPECT_EQ(subscriptions_.add("/a", false), "");
  EXPECT_EQ(subscriptions_.add("/b", false), "a client can subscribe to at most 1 topics with ignition.msgs.StringMsg");
  subscriptions_.remove("/a");
  EXPECT_EQ(subscriptions_.add("/b", false), "");
}

TEST_F(ListeningTest, LetsThroughAsManyAsTheClientWants) {
  auto publisher = world_.node().advertise<im::StringMsg>("/t");
  EXPECT_EQ(subscriptions_.limit("/t", 1e-6), "");
  EXPECT_EQ(subscriptions_.add("/t", false), "");
  im::StringMsg message;
  EXPECT_NE(received(publisher, message), "");
  for (int i = 0; i < 5; ++i) publisher.publish(message);
  client_->free();
  EXPECT_TRUE(client_->takeBinaries().empty());
}

}  // namespace
}  // namespace pongsim::web::gz
