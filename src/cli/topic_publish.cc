#include <algorithm>
#include <iterator>
#include <vector>

#include "cli/console.hh"
#include "cli/topic_command.hh"
#include "cli/topic_name.hh"
#include "pongsim/node.hh"

namespace pongsim::cli {

namespace {

/// @return The exit code after saying why nobody listens.
int failWithoutSubscriber(Transport& transport, const PublishOptions& options) {
  const std::vector<TopicInfo> topics = transport.discover(kDiscoveryTime);
  for (const TopicInfo& topic : topics) {
    if (topic.name != options.topic || topic.subscribers.empty()) continue;
    const std::string& theirs = topic.subscribers.front().type;
    if (theirs == options.type) break;
    return fail("the subscriber of " + options.topic + " takes " + theirs + ", not " + options.type);
  }
  std::vector<TopicInfo> heard;
  std::copy_if(topics.begin(), topics.end(), std::back_inserter(heard),
               [](const TopicInfo& topic) { return !topic.subscribers.empty(); });
  return fail("no subscriber on " + options.topic, nearestTopic(options.topic, heard));
}

}  // namespace

int publishOnce(const PublishOptions& options) {
  Transport transport;
  Publisher publisher = transport.node().advertise(options.topic, options.type);
  if (!publisher.waitForSubscribers(options.timeout)) return failWithoutSubscriber(transport, options);
  publisher.publish(*options.message);
  if (publisher.waitForDelivery(options.timeout)) return kDone;
  return fail("no subscriber on " + options.topic + " confirmed the message in time");
}

}  // namespace pongsim::cli
