#include "transport/services/service_server.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "transport/dispatch_queue.hh"

namespace pongsim::transport {
namespace {

using ignition::msgs::StringMsg;

class ServiceServerTest : public testing::Test {
 protected:
  static std::vector<std::byte> bytes(const std::string& text) {
    StringMsg message;
    message.set_data(text);
    const std::string all = message.SerializeAsString();
    const auto view = std::as_bytes(std::span(all));
    return {view.begin(), view.end()};
  }

  Offer& offer(ServiceHandler handler) {
    return server_.add(queue_, "/s", "StringMsg", "ignition.msgs.StringMsg", std::move(handler));
  }

  void take(std::uint64_t call, const std::optional<ReplyHeader>& header, std::span<const std::byte> message) {
    StringMsg reply;
    reply.ParseFromArray(message.data(), static_cast<int>(message.size()));
    answers_.push_back(std::to_string(call) + " " +
                       (!header        ? "gone"
                        : header->done ? "done " + reply.data()
                                       : "refused " + header->reason));
  }

  int arrivals_ = 0;
  std::vector<std::string> answers_;
  DispatchQueue queue_;
  ServiceServer server_{
      nullptr, [this](DispatchQueue&) { ++arrivals_; },
      [this](const auto&, auto call, const auto& header, auto message) { take(call, header, message); }};
};

using Answers = std::vector<std::string>;

TEST_F(ServiceServerTest, AnswersInTheOrderOfTheRequestsWhenDispatched) {
  offer([](const Message& request, Message& reply) {
    reply.CopyFrom(request);
    return true;
  });
  EXPECT_TRUE(server_.post(queue_, "/s", 1, bytes("a")));
  EXPECT_TRUE(server_.post(queue_, "/s", 2, bytes("b")));
  EXPECT_EQ(arrivals_, 2);
  EXPECT_TRUE(queue_.requestsWaiting);
  EXPECT_EQ(answers_, Answers{});
  EXPECT_EQ(server_.dispatch(queue_, {}), 2U);
  EXPECT_EQ(answers_, (Answers{"1 done a", "2 done b"}));
  EXPECT_FALSE(queue_.requestsWaiting);
  EXPECT_EQ(server_.dispatch(queue_, {}), 0U);
}

TEST_F(ServiceServerTest, GivesEachRequestAnEmptyReplyToFillIn) {
  offer([](const Message& request, Message& reply) {
    if (static_cast<const StringMsg&>(request).data() == "first") reply.CopyFrom(request);
    return true;
  });
  server_.post(queue_, "/s", 1, bytes("first"));
  server_.post(queue_, "/s", 2, bytes("second"));
  server_.dispatch(queue_, {});
  EXPECT_EQ(answers_, (Answers{"1 done first", "2 done "}));
}

TEST_F(ServiceServerTest, TellsWhyARequestIsRefused) {
  offer([](const Message& request, Message&) -> ServiceAnswer {
    if (static_cast<const StringMsg&>(request).data() == "throw") throw std::runtime_error("broken");
    return ServiceAnswer::refused("full");
  });
  server_.post(queue_, "/s", 1, bytes(""));
  server_.post(queue_, "/s", 2, bytes("throw"));
  server_.post(queue_, "/s", 3, {std::byte{0xff}});
  server_.dispatch(queue_, {});
  EXPECT_EQ(answers_, (Answers{"1 refused full", "2 refused broken",
                               "3 refused the request is not of type ignition.msgs.StringMsg"}));
}

TEST_F(ServiceServerTest, HasRoomForAThousandRequests) {
  offer([](const Message&, Message&) { return true; });
  for (std::uint64_t i = 0; i < 1000; ++i) EXPECT_TRUE(server_.post(queue_, "/s", i, {}));
  EXPECT_FALSE(server_.post(queue_, "/s", 1000, {}));
  EXPECT_EQ(server_.dispatch(queue_, {}), 1000U);
  EXPECT_TRUE(server_.post(queue_, "/s", 1001, {}));
}

TEST_F(ServiceServerTest, HasRoomForSoManyBytesButOneRequest) {
  offer([](const Message&, Message&) { return true; });
  constexpr std::size_t kLarge = 20 << 20;
  EXPECT_TRUE(server_.post(queue_, "/s", 1, std::vector<std::byte>(2 * kLarge)));
  EXPECT_FALSE(server_.post(queue_, "/s", 2, {std::byte{0}}));
  EXPECT_EQ(server_.dispatch(queue_, {}), 1U);
  EXPECT_TRUE(server_.post(queue_, "/s", 3, std::vector<std::byte>(kLarge)));
  EXPECT_FALSE(server_.post(queue_, "/s", 4, std::vector<std::byte>(kLarge)));
}

TEST_F(ServiceServerTest, TakesWhateverAHandlerThrowsAsARefusal) {
  offer([](const Message&, Message&) -> ServiceAnswer { throw 7; });
  server_.post(queue_, "/s", 1, {});
  server_.dispatch(queue_, {});
  EXPECT_EQ(answers_, Answers{"1 refused it threw something other than a std::exception"});
}

TEST_F(ServiceServerTest, TellsWaitingCallersThatItHasGone) {
  Offer& gone = offer([](const Message&, Message&) { return true; });
  server_.post(queue_, "/s", 5, {});
  server_.end(gone, false);
  EXPECT_EQ(answers_, (Answers{"5 gone"}));
  EXPECT_FALSE(server_.post(queue_, "/s", 6, {}));
  EXPECT_EQ(server_.dispatch(queue_, {}), 0U);
}

TEST_F(ServiceServerTest, MayEndInItsOwnHandler) {
  Offer* self = nullptr;
  self = &offer([&](const Message&, Message&) {
    server_.end(*self, true);
    return true;
  });
  server_.post(queue_, "/s", 1, {});
  server_.post(queue_, "/s", 2, {});
  server_.dispatch(queue_, {});
  EXPECT_EQ(answers_, (Answers{"1 done ", "2 gone"}));
}

TEST_F(ServiceServerTest, RefusesTakenNamesAndUnknownTypes) {
  const ServiceHandler handler = [](const Message&, Message&) { return true; };
  offer(handler);
  EXPECT_EQ(server_.typesOf(queue_, "/s"),
            std::pair(std::string("ignition.msgs.StringMsg"), std::string("ignition.msgs.StringMsg")));
  EXPECT_EQ(server_.typesOf(queue_, "/t"), std::nullopt);
  EXPECT_THROW(server_.add(queue_, "s", "Int32", "Int32", handler), std::invalid_argument);
  EXPECT_THROW(server_.add(queue_, "/t", "Int33", "Int32", handler), std::invalid_argument);
  EXPECT_THROW(server_.add(queue_, "/t u", "Int32", "Int32", handler), std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::transport
