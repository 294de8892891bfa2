#include "ros2/services/offers.hh"

#include <gtest/gtest.h>

#include <future>

#include "ros2/types/simulation_entity_services.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2::offers_test {
namespace {

using simulation_interfaces::srv::DeleteEntity;

class OffersTest : public testing::Test {
 protected:
  DeleteEntity::Response call(const std::string& entity) {
    auto answer = std::async(std::launch::async,
                             [&] { return RosClient<DeleteEntity>(peer_, "/delete").call({entity}, test::kDeadline); });
    while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) node_.mailbox().dispatch();
    return answer.get().value();
  }

  const int domain_ = test::testDomain();
  Participant participant_{{.domain = domain_}};
  RosNode node_{participant_, {}};
  Participant peerParticipant_{{.domain = domain_}};
  RosNode peer_{peerParticipant_, {.name = "peer"}};
};

TEST_F(OffersTest, AHandlerThatThrowsHasFailedAndIsCalledAgain) {
  Offers offers(node_);
  offers.addAtOnce<DeleteEntity>("/delete", [](const DeleteEntity::Request& request) {
    if (request.entity == "bad") throw std::runtime_error("it is bad");
    return DeleteEntity::Response{succeeded()};
  });
  EXPECT_EQ(call("bad").result, failed("it is bad"));
  EXPECT_EQ(call("good").result, succeeded());
}

TEST_F(OffersTest, ANameThatRosDoesNotAllowIsWarnedOf) {
  Offers offers(node_);
  testing::internal::CaptureStderr();
  offers.addAtOnce<DeleteEntity>("/a-b", [](const DeleteEntity::Request&) { return DeleteEntity::Response(); });
  EXPECT_NE(testing::internal::GetCapturedStderr().find("not offered: service '/a-b' "), std::string::npos);
}

}  // namespace
}  // namespace pongsim::ros2::offers_test
