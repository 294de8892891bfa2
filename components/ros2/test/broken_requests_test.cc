// Invalid requests to a service, from a participant that is not a node.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "ros2/node/service.hh"
#include "ros2/types/cdr.hh"
#include "ros2/types/ros_gz_interfaces.hh"
#include "support/process.hh"
#include "support/test_domain.hh"

namespace pongsim::ros2 {
namespace {

using ros_gz_interfaces::srv::SetEntityPose;

/// @return An invalid payload: truncated, at a point where DDS's padding does not complete it.
std::vector<std::byte> rubbish(std::mt19937& chance) {
  std::vector<std::byte> payload = toCdr(SetEntityPose::Request());
  payload.resize(kEncapsulation + chance() % (payload.size() - kEncapsulation - 3));
  return payload;
}

TEST(BrokenRequests, AreCountedAndTheServiceGoesOn) {
  const int domain = pongsim::test::testDomain();
  Participant participant({.domain = domain}), stranger({.domain = domain}), other({.domain = domain});
  RosNode node(participant, {});
  int handled = 0;
  const auto server = serveAtOnce<SetEntityPose>(node, "/set_pose", [&handled](const SetEntityPose::Request&) {
    ++handled;
    return SetEntityPose::Response();
  });
  const auto writer =
      stranger.makeWriter({requestOnWire("/set_pose"), ddsTypeName(nameOf<SetEntityPose::Request>()), {}, kDefaultQos});
  while (!writer->hasReaders()) std::this_thread::sleep_for(std::chrono::milliseconds(1));

  constexpr std::uint64_t kCount = 300;
  std::mt19937 chance(5);
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const std::vector<std::byte> payload = rubbish(chance);
    writer->write(payload.size(),
                  [&payload](std::span<std::byte> place) { std::ranges::copy(payload, place.begin()); });
    // none is dropped on the way, so that all can be counted
    ASSERT_TRUE(writer->waitForAcknowledgement(pongsim::test::kDeadline));
  }
  while (node.malformed() < kCount) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(node.malformed(), kCount);
  EXPECT_EQ(node.mailbox().dispatch(), 0U);
  EXPECT_EQ(handled, 0);

  RosNode caller(other, {.name = "caller"});
  auto answer = std::async(std::launch::async, [&caller] {
    return RosClient<SetEntityPose>(caller, "/set_pose").call({}, pongsim::test::kDeadline);
  });
  while (answer.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) node.mailbox().dispatch();
  EXPECT_TRUE(answer.get().has_value());
  EXPECT_EQ(handled, 1);
}

}  // namespace
}  // namespace pongsim::ros2
