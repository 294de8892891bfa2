// Measures messages to clients of Fortress, compared with those between two ign-transport nodes, and their cost in the
// simulation.
//   pongsim_ign_bench                   runs everything
//   pongsim_ign_bench hear KIND         the other process: receives one kind, and prints the median age [us]
//   pongsim_ign_bench say KIND WAY      publishes it, stamped: natively, or through pongsim

#include <ignition/msgs/image.pb.h>
#include <ignition/msgs/twist.pb.h>
#include <unistd.h>

#include <ignition/transport/Node.hh>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "ign/bridge.hh"
#include "ign/place.hh"
#include "pongsim/log.hh"
#include "pongsim/node.hh"
#include "support/message_ages.hh"
#include "support/process.hh"

namespace pongsim::ign {
namespace {

using Clock = std::chrono::steady_clock;
using ignition::msgs::Image;
using ignition::msgs::Twist;
using test::callAtRate;
using test::median;
using test::MessageAges;
using test::Process;
using test::secondsNow;
using test::waitFor;

struct Kind {
  const char* name;
  const char* topic;
  double rate;
  int count;
};
constexpr Kind kKinds[] = {{"Twist", "/measured_twist", 500, 1000}, {"Image", "/measured_image", 30, 120}};
enum { kTwist, kImage };
constexpr int kRounds = 5;
constexpr unsigned kWidth = 640, kHeight = 480;
constexpr int kIdleTopics = 50;
constexpr int kIdleSteps = 1'000'000;

Twist stampedTwist() {
  Twist message;
  message.mutable_linear()->set_x(secondsNow());
  return message;
}

Image stampedImage() {
  Image message;
  message.set_width(kWidth);
  message.set_height(kHeight);
  message.set_step(3 * kWidth);
  const double at = secondsNow();
  message.mutable_header()->mutable_stamp()->set_sec(static_cast<std::int64_t>(at));
  message.mutable_header()->mutable_stamp()->set_nsec(
      static_cast<std::int32_t>((at - static_cast<double>(static_cast<std::int64_t>(at))) * 1e9));
  return message;
}

/// An image like that of a camera: rendered once, in its own memory.
const std::vector<char>& picture() {
  static const std::vector<char> pixels(3 * kWidth * kHeight, 'x');
  return pixels;
}

int hear(int kind) {
  ignition::transport::Node node;
  MessageAges ages;
  std::function<void(const Twist&)> twist = [&ages](const Twist& message) {
    ages.add(1e6 * (secondsNow() - message.linear().x()));
  };
  std::function<void(const Image&)> image = [&ages](const Image& message) {
    const auto& stamp = message.header().stamp();
    ages.add(1e6 * (secondsNow() - (static_cast<double>(stamp.sec()) + stamp.nsec() * 1e-9)));
  };
  if (kind == kTwist ? !node.Subscribe(kKinds[kind].topic, twist) : !node.Subscribe(kKinds[kind].topic, image)) {
    return 1;
  }
  const std::vector<double> all = ages.wait(kKinds[kind].count);
  std::printf("%.1f %zu\n", median(all), all.size());
  return 0;
}

// After discovery, ZeroMQ takes a moment to connect.
void settleDown() { std::this_thread::sleep_for(std::chrono::milliseconds(500)); }

int sayNatively(int kind) {
  ignition::transport::Node node;
  auto publisher =
      kind == kTwist ? node.Advertise<Twist>(kKinds[kind].topic) : node.Advertise<Image>(kKinds[kind].topic);
  waitFor([&] { return publisher.HasConnections(); });
  settleDown();
  callAtRate(kKinds[kind].count, kKinds[kind].rate, [&] {
    if (kind == kTwist) {
      publisher.Publish(stampedTwist());
    } else {
      Image message = stampedImage();
      message.set_data(picture().data(), picture().size());
      publisher.Publish(message);
    }
  });
  settleDown();
  return 0;
}

/// A transport without DDS, with a bridge to ign-transport.
struct Bridged {
  Bridged() { bridge.update(); }
  Transport transport{{.network = false}};
  Node node = transport.node();
  Logger log{"bench"};
  Bridge bridge{node, log, "127.0.0.1", Generation::kIgn};
};

int sayByPongsim(int kind) {
  settle(placeOfEnvironment(Generation::kIgn), 1000, Generation::kIgn);
  Bridged bridged;
  Publisher publisher = bridged.node.advertise(kKinds[kind].topic, kind == kTwist ? "Twist" : "Image");
  waitFor([&] {
    bridged.bridge.update();
    return publisher.hasSubscribers();
  });
  settleDown();
  callAtRate(kKinds[kind].count, kKinds[kind].rate, [&] {
    if (kind == kTwist) {
      publisher.publish(stampedTwist());
    } else {
      const Bulk bulk{.size = picture().size(), .write = [](std::span<std::byte> place) {
                        std::memcpy(place.data(), picture().data(), picture().size());
                      }};
      publisher.publish(stampedImage(), bulk);
    }
  });
  settleDown();
  return 0;
}

/// @return The median age that the other process measured [us].
double measure(const std::string& self, int kind, const char* way) {
  Process listener({self, "hear", kKinds[kind].name});
  Process speaker({self, "say", kKinds[kind].name, way});
  speaker.wait(std::chrono::seconds(60));
  listener.wait(std::chrono::seconds(60));
  double age = 0;
  int count = 0;
  if (std::sscanf(listener.output().c_str(), "%lf %d", &age, &count) != 2 || count < kKinds[kind].count) {
    std::printf("%s, %s: %d of %d came\n", kKinds[kind].name, way, count, kKinds[kind].count);
  }
  return age;
}

void compareWays(const std::string& self) {
  std::printf("median age at a node of ign-transport [us], %d rounds in turn\n", kRounds);
  std::printf("%-8s %10s %10s %8s\n", "", "native", "pongsim", "ratio");
  for (int kind : {kTwist, kImage}) {
    std::map<std::string, std::vector<double>> ages;
    for (int i = 0; i < kRounds; ++i) {
      for (const char* way : {"native", "pongsim"}) ages[way].push_back(measure(self, kind, way));
    }
    const double native = median(ages["native"]), ours = median(ages["pongsim"]);
    std::printf("%-8s %10.1f %10.1f %8.2f\n", kKinds[kind].name, native, ours, ours / native);
  }
}

double nanosecondsOf(const std::function<void()>& call) {
  const auto start = Clock::now();
  for (int i = 0; i < kIdleSteps; ++i) call();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / kIdleSteps;
}

/// Measures the cost of a step without ign-transport subscribers.
void measureIdle() {
  Transport plain({.network = false});
  Node plainNode = plain.node();
  Publisher unbridged = plainNode.advertise("/idle", "Twist");
  Bridged bridged;
  std::vector<Publisher> publishers;
  for (int i = 0; i < kIdleTopics; ++i) {
    publishers.push_back(bridged.node.advertise("/idle" + std::to_string(i), "Twist"));
  }
  bridged.bridge.update();
  settleDown();
  const Twist message;
  std::printf("a step without listeners, %d topics [ns]: bridge %.1f; publishing %.1f, without the bridge %.1f\n",
              kIdleTopics, nanosecondsOf([&] { bridged.bridge.update(); }),
              nanosecondsOf([&] { publishers.front().publish(message); }),
              nanosecondsOf([&] { unbridged.publish(message); }));
}

int run(int count, char** words) {
  const std::vector<std::string> arguments(words + 1, words + count);
  if (std::getenv("IGN_PARTITION") == nullptr) {
    setenv("IGN_PARTITION", ("pongsim_bench_" + std::to_string(getpid())).c_str(), 1);
  }
  setenv("IGN_IP", "127.0.0.1", 0);
  const auto kindOf = [&] { return arguments[1] == kKinds[kTwist].name ? kTwist : kImage; };
  if (arguments.size() == 2 && arguments[0] == "hear") return hear(kindOf());
  if (arguments.size() == 3 && arguments[0] == "say") {
    return arguments[2] == "native" ? sayNatively(kindOf()) : sayByPongsim(kindOf());
  }
  if (!arguments.empty()) {
    std::fprintf(stderr, "pongsim_ign_bench: error: takes no options\n");
    return 2;
  }
  compareWays(words[0]);
  measureIdle();
  return 0;
}

}  // namespace
}  // namespace pongsim::ign

int main(int count, char** words) { return pongsim::ign::run(count, words); }
