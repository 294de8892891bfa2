#include "transport/interceptor.hh"

#include <google/protobuf/message.h>
#include <gtest/gtest.h>
#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/int32.pb.h>

#include <cstddef>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/bulk.hh"

namespace pongsim::transport {

namespace {

using ignition::msgs::Image;
using ignition::msgs::Int32;
using Words = std::vector<std::string>;

std::vector<std::byte> bytesOf(const google::protobuf::Message& message) {
  std::vector<std::byte> bytes(message.ByteSizeLong());
  message.SerializeToArray(bytes.data(), static_cast<int>(bytes.size()));
  return bytes;
}

Int32 number(int value) {
  Int32 message;
  message.set_data(value);
  return message;
}

/// A transport whose topic /a is intercepted, and one outside.
class InterceptorTest : public testing::Test {
 protected:
  void take(const std::function<void(int, const Interception::Crossing&)>& taken) {
    interception_.emplace(inside_.node(), "a", [taken](const Interception::Crossing& crossing) {
      Int32 message;
      EXPECT_EQ(crossing.type, "ignition.msgs.Int32");
      EXPECT_TRUE(message.ParseFromArray(crossing.bytes.data(), static_cast<int>(crossing.bytes.size())));
      taken(message.data(), crossing);
    });
  }
  std::function<void(const Int32&)> note(const std::string& who) {
    return [this, who](const Int32& message) { heard_.push_back(who + std::to_string(message.data())); };
  }
  Words takeHeard() {
    inside_.dispatch();
    outside_.dispatch();
    return std::exchange(heard_, {});
  }

  Transport inside_{{.network = false, .domain = {}}};
  Transport outside_{inside_, Transport::Sharing()};
  Words heard_;
  Subscription here_ = inside_.node().subscribe<Int32>("/a", note("here"));
  Subscription hereToo_ = inside_.node().subscribe<Int32>("/a", note("too"));
  Subscription there_ = outside_.node().subscribe<Int32>("/a", note("there"));
  Publisher own_ = inside_.node().advertise<Int32>("/a");
  Publisher foreign_ = outside_.node().advertise<Int32>("/a", {.ownOnly = false});
  std::optional<Interception> interception_;
};

TEST_F(InterceptorTest, TakesWhatItsTransportPublishesForAllReceivers) {
  take([](int value, const Interception::Crossing& crossing) {
    EXPECT_FALSE(crossing.isIncoming);
    if (value != 2) crossing.pass(bytesOf(number(10 * value)));
    if (value == 3) crossing.pass(crossing.bytes);
  });
  for (const int value : {1, 2, 3}) own_.publish(number(value));
  EXPECT_EQ(takeHeard(),
            (Words{"here10", "too10", "here30", "too30", "here3", "too3", "there10", "there30", "there3"}));
  interception_.reset();
  own_.publish(number(4));
  EXPECT_EQ(takeHeard(), (Words{"here4", "too4", "there4"}));
}

TEST_F(InterceptorTest, TakesWhatComesOnceForAllSubscriptions) {
  int count = 0;
  take([&](int value, const Interception::Crossing& crossing) {
    ++count;
    EXPECT_TRUE(crossing.isIncoming);
    if (value == 1) crossing.pass(bytesOf(number(7)));
  });
  foreign_.publish(number(1));
  foreign_.publish(number(2));
  EXPECT_EQ(takeHeard(), (Words{"here7", "too7", "there1", "there2"}));
  EXPECT_EQ(count, 2);
}

TEST_F(InterceptorTest, LeavesOtherTopicsAlone) {
  take([](int, const Interception::Crossing&) {});
  const Subscription other = inside_.node().subscribe<Int32>("/b", note("other"));
  Publisher publisher = outside_.node().advertise<Int32>("/b");
  publisher.publish(number(1));
  foreign_.publish(number(2));
  EXPECT_EQ(takeHeard(), (Words{"other1", "there2"}));
}

TEST_F(InterceptorTest, SendsLater) {
  std::vector<std::pair<std::vector<std::byte>, bool>> kept;
  take([&](int, const Interception::Crossing& crossing) {
    kept.emplace_back(std::vector(crossing.bytes.begin(), crossing.bytes.end()), crossing.isIncoming);
  });
  own_.publish(number(1));
  foreign_.publish(number(2));
  EXPECT_EQ(takeHeard(), Words{"there2"});
  ASSERT_EQ(kept.size(), 2U);
  for (const auto& [bytes, isIncoming] : kept) interception_->send("ignition.msgs.Int32", bytes, isIncoming, false);
  EXPECT_EQ(takeHeard(), (Words{"here1", "too1", "here2", "too2", "there1"}));
}

TEST_F(InterceptorTest, TakesWhatCarriersBringAndSendsItToNoCarrier) {
  Publisher carrier = inside_.node().advertise("/a", "ignition.msgs.Int32", {.relays = true, .ownOnly = true});
  int carriedOut = 0;
  const Subscription relay = inside_.node().subscribeAtOnce(
      "/a", "ignition.msgs.Int32", [&](const Message&, const Bulk*) { ++carriedOut; }, {.relays = true});
  std::vector<std::byte> kept;
  take([&](int, const Interception::Crossing& crossing) {
    EXPECT_TRUE(crossing.isIncoming && crossing.isCarried);
    kept.assign(crossing.bytes.begin(), crossing.bytes.end());
  });
  carrier.publish(number(1));
  EXPECT_EQ(takeHeard(), Words{});
  interception_->send("ignition.msgs.Int32", kept, true, true);
  EXPECT_EQ(takeHeard(), (Words{"here1", "too1"}));
  EXPECT_EQ(carriedOut, 0);
}

TEST_F(InterceptorTest, CompletesMessagesWhosePixelsAreOutside) {
  std::string seen;
  const Interception interception(inside_.node(), "/image", [&](const Interception::Crossing& crossing) {
    Image image;
    ASSERT_TRUE(image.ParseFromArray(crossing.bytes.data(), static_cast<int>(crossing.bytes.size())));
    seen = image.data();
    crossing.pass(crossing.bytes);
  });
  Publisher publisher = inside_.node().advertise<Image>("/image");
  std::string heard;
  const Subscription images =
      inside_.node().subscribe<Image>("/image", [&](const Image& image) { heard = image.data(); });
  publisher.publish(Image(), Bulk{"data", 3, [](std::span<std::byte> place) { std::memcpy(place.data(), "abc", 3); }});
  inside_.dispatch();
  EXPECT_EQ(seen, "abc");
  EXPECT_EQ(heard, "abc");
}

TEST_F(InterceptorTest, IsAloneOnATopic) {
  take([](int, const Interception::Crossing&) {});
  EXPECT_THROW(Interception(inside_.node(), "/a", {}), std::invalid_argument);
  EXPECT_THROW(Interception(inside_.node(), "/a b", {}), std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::transport
