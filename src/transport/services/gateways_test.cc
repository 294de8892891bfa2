#include "transport/services/gateways.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <chrono>
#include <optional>
#include <string>

#include "pongsim/node.hh"
#include "transport/deadline.hh"

namespace pongsim::transport {
namespace {

using ignition::msgs::StringMsg;

TEST(Gateways, AreAskedInTheirOrderUntilOneKnowsTheService) {
  Gateways gateways;
  StringMsg request, reply;
  const auto call = [&] { return gateways.call("/s", request, reply, deadlineAfter(std::chrono::seconds(1))); };
  EXPECT_FALSE(call());
  std::string asked;
  const auto first = gateways.add([&asked](const std::string& service, const Message&, Message&, auto) {
    asked += "1" + service;
    return std::optional<CallResult>();
  });
  const auto second = gateways.add([&asked](const std::string&, const Message&, Message& answer, auto timeout) {
    asked += "2";
    EXPECT_LE(timeout, std::chrono::seconds(1));
    static_cast<StringMsg&>(answer).set_data("yes");
    return std::optional(CallResult{CallOutcome::kDone, {}});
  });
  const std::optional<CallResult> result = call();
  ASSERT_TRUE(result);
  EXPECT_TRUE(*result);
  EXPECT_EQ(asked, "1/s2");
  EXPECT_EQ(reply.data(), "yes");
  gateways.end(second);
  EXPECT_FALSE(call());
  gateways.end(first);
  asked.clear();
  EXPECT_FALSE(call());
  EXPECT_EQ(asked, "");
}

TEST(Gateways, AreForServicesThatTheTransportDoesNotOfferItself) {
  Transport transport({.network = false});
  Node node = transport.node();
  StringMsg request, reply;
  const auto call = [&](const char* service) {
    return node.call(service, request, reply, std::chrono::milliseconds(1)).outcome;
  };
  Gateway gateway = node.openGateway([](const std::string& service, const Message&, Message&, auto) {
    return service == "/there" ? std::optional(CallResult{CallOutcome::kDone, {}}) : std::nullopt;
  });
  const Service own = node.serve<StringMsg, StringMsg>("/here", [](const StringMsg&, StringMsg&) { return true; });
  EXPECT_EQ(call("/there"), CallOutcome::kDone);
  // its own is not asked elsewhere: nobody dispatches, so that it does not answer
  EXPECT_EQ(call("/here"), CallOutcome::kNoAnswer);
  EXPECT_EQ(call("/nowhere"), CallOutcome::kNoService);
  gateway = {};
  EXPECT_EQ(call("/there"), CallOutcome::kNoService);
}

}  // namespace
}  // namespace pongsim::transport
