// The other process in the tests of topics.
//   listen TOPIC            says "ready", then "got TEXT" for each text that comes, "got N bytes" for a long one
//   say TOPIC COUNT BYTES   waits for a listener, then publishes so many texts "0", "1", ..., filled up to BYTES
//   offer COUNT             publishes on so many topics /PID/0, /PID/1, ..., says "ready"
//   discover                says how many topics it finds
// What has no end of its own ends cleanly with SIGTERM.

#include <ignition/msgs/stringmsg.pb.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "pongsim/node.hh"

using ignition::msgs::StringMsg;
using pongsim::Node;
using pongsim::Publisher;
using pongsim::Subscription;
using pongsim::Transport;

namespace {

constexpr std::chrono::seconds kDeadline{60};
std::atomic<bool> stopped = false;

void dispatchUntilStopped(Transport& transport) {
  while (!stopped) transport.dispatchFor(std::chrono::milliseconds(20));
}

int listen(Transport& transport, const std::string& topic) {
  const Subscription subscription = transport.node().subscribe<StringMsg>(topic, [](const StringMsg& message) {
    if (message.data().size() > 20) {
      std::cout << "got " << message.data().size() << " bytes" << std::endl;
    } else {
      std::cout << "got " << message.data() << std::endl;
    }
  });
  std::cout << "ready" << std::endl;
  dispatchUntilStopped(transport);
  return 0;
}

int say(Transport& transport, const std::string& topic, int count, std::size_t bytes) {
  Publisher publisher = transport.node().advertise<StringMsg>(topic);
  if (!publisher.waitForSubscribers(kDeadline)) return 1;
  for (int i = 0; i < count; ++i) {
    StringMsg message;
    message.set_data(std::to_string(i));
    if (message.data().size() < bytes) message.mutable_data()->resize(bytes, ' ');
    publisher.publish(message);
  }
  return publisher.waitForDelivery(kDeadline) ? 0 : 1;
}

int offer(Transport& transport, int count) {
  std::vector<Publisher> publishers;
  for (int i = 0; i < count; ++i) {
    const std::string topic = "/" + std::to_string(getpid()) + "/" + std::to_string(i);
    publishers.push_back(transport.node().advertise<StringMsg>(topic));
  }
  std::cout << "ready" << std::endl;
  dispatchUntilStopped(transport);
  return 0;
}

}  // namespace

int main(int count, char** texts) {
  const std::vector<std::string> arguments(texts + 1, texts + count);
  signal(SIGTERM, [](int) { stopped = true; });
  Transport transport;
  if (arguments.at(0) == "listen") return listen(transport, arguments.at(1));
  if (arguments.at(0) == "say") {
    return say(transport, arguments.at(1), std::stoi(arguments.at(2)), std::stoul(arguments.at(3)));
  }
  if (arguments.at(0) == "offer") return offer(transport, std::stoi(arguments.at(1)));
  std::cout << "found " << transport.discover(kDeadline).size() << std::endl;
  return 0;
}
