#include "ign/offered_service.hh"

#include <gtest/gtest.h>
#include <ignition/msgs/stringmsg.pb.h>

#include <algorithm>
#include <future>
#include <string>
#include <vector>

#include "support/wait_until.hh"

namespace pongsim::ign {
namespace {

using ignition::msgs::StringMsg;

class OfferedServiceTest : public testing::Test {
 protected:
  OwnService own(const std::string& name) {
    const std::vector<OwnService> all = node_.ownServices();
    return *std::ranges::find(all, name, &OwnService::name);
  }
  /// Makes a request on another thread, as the library does.
  /// @return The text of the response, or "refused".
  std::string ask(OfferedService& service, const std::string& bytes) {
    std::future<std::string> answer = std::async(std::launch::async, [&] {
      std::string reply;
      StringMsg message;
      return service.RunCallback(bytes, reply) && message.ParseFromString(reply) ? message.data() : "refused";
    });
    EXPECT_TRUE(test::waitUntil([&] {
      transport_.dispatchFor(std::chrono::milliseconds(1));
      return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }));
    return answer.get();
  }
  static std::string bytesOf(const std::string& text) {
    StringMsg message;
    message.set_data(text);
    return message.SerializeAsString();
  }

  Transport transport_{{.network = false}};
  Node node_ = transport_.node();
  Service twice_ = node_.serve<StringMsg, StringMsg>("/twice", [](const StringMsg& request, StringMsg& reply) {
    reply.set_data(request.data() + request.data());
    return request.data() != "no";
  });
};

TEST_F(OfferedServiceTest, AnswersAsTheWorldDoes) {
  OfferedService service(node_, own("/twice"), Generation::kIgn);
  EXPECT_EQ(service.ReqTypeName(), "ignition.msgs.StringMsg");
  EXPECT_EQ(service.RepTypeName(), "ignition.msgs.StringMsg");
  EXPECT_EQ(ask(service, bytesOf("ab")), "abab");
  EXPECT_EQ(ask(service, bytesOf("no")), "refused");
}

TEST_F(OfferedServiceTest, RefusesWhatIsNoRequest) {
  OfferedService service(node_, own("/twice"), Generation::kIgn);
  EXPECT_EQ(ask(service, "\xff\xff\xff"), "refused");
}

TEST_F(OfferedServiceTest, LetsGoOfWhoWaitsWhenItEnds) {
  OfferedService service(node_, own("/twice"), Generation::kIgn);
  std::future<bool> answer = std::async(std::launch::async, [&] {
    std::string reply;
    return service.RunCallback(bytesOf("ab"), reply);
  });
  // the request is never dispatched, so only `end` releases it
  service.end();
  EXPECT_FALSE(answer.get());
  std::string reply;
  EXPECT_FALSE(service.RunCallback(bytesOf("ab"), reply));
}

}  // namespace
}  // namespace pongsim::ign
