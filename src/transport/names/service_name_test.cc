#include "transport/names/service_name.hh"

#include <gtest/gtest.h>

#include <stdexcept>

namespace pongsim::transport {
namespace {

TEST(ServiceName, IsFoundInItsRequestTopicOnly) {
  EXPECT_EQ(serviceOfRequestTopic(requestTopic("/world/w/control")), "/world/w/control");
  EXPECT_EQ(serviceOfRequestTopic(replyTopic("/world/w/control")), std::nullopt);
  EXPECT_EQ(serviceOfRequestTopic("/world/w/control"), std::nullopt);
  EXPECT_EQ(serviceOfRequestTopic("pongsim/requestless"), std::nullopt);
  EXPECT_EQ(serviceOfRequestTopic(""), std::nullopt);
}

TEST(ServiceName, HasTopicsThatAreNoUsersTopics) {
  EXPECT_FALSE(requestTopic("/a").starts_with('/'));
  EXPECT_FALSE(replyTopic("/a").starts_with('/'));
  EXPECT_NE(requestTopic("/a"), replyTopic("/a"));
}

TEST(ServiceName, TellsBothTypes) {
  const std::string type = serviceType("ignition.msgs.Empty", "ignition.msgs.Boolean");
  ASSERT_TRUE(typesOfService(type));
  EXPECT_EQ(typesOfService(type)->first, "ignition.msgs.Empty");
  EXPECT_EQ(typesOfService(type)->second, "ignition.msgs.Boolean");
  EXPECT_FALSE(typesOfService("ignition.msgs.Empty"));
}

TEST(ServiceName, MustFitDdsWithWhatIsPutBeforeIt) {
  EXPECT_EQ(absoluteService("a/b/"), "/a/b");
  EXPECT_EQ(absoluteService(std::string(230, 'a')).size(), 231U);
  EXPECT_LE(requestTopic(absoluteService(std::string(230, 'a'))).size(), 255U);
  EXPECT_THROW(absoluteService(std::string(231, 'a')), std::invalid_argument);
  EXPECT_THROW(absoluteService("a b"), std::invalid_argument);
  EXPECT_THROW(absoluteService(""), std::invalid_argument);
}

}  // namespace
}  // namespace pongsim::transport
