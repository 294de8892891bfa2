// The other process in the tests of topics.
//   listen TOPIC            says "ready", then "got TEXT" for each text that comes, "got N bytes" for a long one
//   say TOPIC COUNT BYTES   waits for a listener, then publishes so many texts "0", "1", ..., filled up to BYTES
//   latch TOPIC TEXT        publishes the text once, latched, says "ready"
//   flood TOPIC TYPE RATE   publishes empty messages, tries so many a second, says "ready" with the first
//   offer COUNT SERVICES    publishes on so many topics /PID/0, /PID/1, ..., and offers so many services of such names,
//                           says "ready"
//   discover                says how many topics it finds
//   serve SERVICE HOW       offers to echo texts ("echo"), to refuse them ("refuse"), to hang ("hang") or to answer the
//                           first and end ("once"); says "ready", then "asked TEXT" for each request
//   ask SERVICE COUNT       calls it with so many texts "0", "1", ..., says "answered TEXT" or "failed ERROR"
// What has no end of its own ends cleanly with SIGTERM.

#include <ignition/msgs/stringmsg.pb.h>
#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <string>
#include <thread>
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
  // what came before the end was asked for
  transport.dispatch();
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

int latch(Transport& transport, const std::string& topic, const std::string& text) {
  Publisher publisher = transport.node().advertise<StringMsg>(topic, {.latched = true});
  StringMsg message;
  message.set_data(text);
  publisher.publish(message);
  std::cout << "ready" << std::endl;
  dispatchUntilStopped(transport);
  return 0;
}

int flood(Transport& transport, const std::string& topic, const std::string& type, int rate) {
  Publisher publisher = transport.node().advertise(topic, type);
  if (!publisher.waitForSubscribers(kDeadline)) return 1;
  const pongsim::MessagePointer message = pongsim::newMessage(type);
  std::cout << "ready" << std::endl;
  for (auto next = std::chrono::steady_clock::now(); !stopped; next += std::chrono::milliseconds(1)) {
    for (int i = 0; i < rate / 1000; ++i) publisher.publish(*message);
    std::this_thread::sleep_until(next);
  }
  return 0;
}

int offer(Transport& transport, int count, int serviceCount) {
  std::vector<Publisher> publishers;
  std::vector<pongsim::Service> services;
  const auto name = [](int i) { return "/" + std::to_string(getpid()) + "/" + std::to_string(i); };
  for (int i = 0; i < count; ++i) publishers.push_back(transport.node().advertise<StringMsg>(name(i)));
  for (int i = 0; i < serviceCount; ++i) {
    services.push_back(
        transport.node().serve<StringMsg, StringMsg>(name(i), [](const StringMsg&, StringMsg&) { return true; }));
  }
  std::cout << "ready" << std::endl;
  dispatchUntilStopped(transport);
  return 0;
}

int serve(Transport& transport, const std::string& name, const std::string& how) {
  pongsim::Service service =
      transport.node().serve<StringMsg, StringMsg>(name, [&how](const StringMsg& request, StringMsg& reply) {
        std::cout << "asked " << request.data() << std::endl;
        if (how == "refuse") return pongsim::ServiceAnswer::refused("not today");
        while (how == "hang" && !stopped) pause();
        reply.set_data(request.data() + "!");
        if (how == "once") stopped = true;
        return pongsim::ServiceAnswer(true);
      });
  std::cout << "ready" << std::endl;
  dispatchUntilStopped(transport);
  return 0;
}

int ask(Transport& transport, const std::string& name, int count) {
  for (int i = 0; i < count; ++i) {
    StringMsg request, reply;
    request.set_data(std::to_string(i));
    const pongsim::CallResult result = transport.node().call(name, request, reply, kDeadline);
    std::cout << (result ? "answered " + reply.data() : "failed " + result.error) << std::endl;
  }
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
  if (arguments.at(0) == "latch") return latch(transport, arguments.at(1), arguments.at(2));
  if (arguments.at(0) == "flood") {
    return flood(transport, arguments.at(1), arguments.at(2), std::stoi(arguments.at(3)));
  }
  if (arguments.at(0) == "offer") return offer(transport, std::stoi(arguments.at(1)), std::stoi(arguments.at(2)));
  if (arguments.at(0) == "serve") return serve(transport, arguments.at(1), arguments.at(2));
  if (arguments.at(0) == "ask") return ask(transport, arguments.at(1), std::stoi(arguments.at(2)));
  std::cout << "found " << transport.discover(kDeadline).size() << std::endl;
  return 0;
}
