// A program for the tests that uses ign-transport, and nothing of pongsim: ign_peer, and with GZ_NAMES gz_peer, whose
// messages have the names since Garden.
//   ign_peer listen TOPIC TYPE        prints "heard" at the first message, and their number when it is interrupted
//   ign_peer statistics TOPIC TYPE    prints "numbered" when it receives messages that are numbered and stamped
//   ign_peer raw TOPIC                prints the type of each message
//   ign_peer texts TOPIC              prints each StringMsg
//   ign_peer flood TOPIC              publishes Int32 as fast as possible, until it is killed
//   ign_peer serve NAME               responds to a StringMsg with its text twice; refuses "no"; prints "ready"
//   ign_peer serve-one-way NAME       prints each request
//   ign_peer call NAME TEXT           calls such a service, and prints the response, "refused" or "no answer"
//   ign_peer call-one-way NAME TEXT   sends the text to such a service, once it exists, and prints "told"
//   ign_peer publish TOPIC TEXT...    publishes each text as a StringMsg once there is a subscriber
//   ign_peer answer TOPIC DELAY       says "ready" when it hears /clock and TOPIC has a subscriber; then publishes an
//                                     arrow key on it, as an Int32, at each tenth millisecond, after up to DELAY ms;
//                                     not with GZ_NAMES

#ifdef GZ_NAMES
#include "gz_messages.pb.h"
#else
#include <ignition/msgs/clock.pb.h>
#include <ignition/msgs/empty.pb.h>
#include <ignition/msgs/int32.pb.h>
#include <ignition/msgs/stringmsg.pb.h>
#endif

#include <ignition/transport/Node.hh>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <thread>
#include <vector>

namespace {

#ifdef GZ_NAMES
namespace messages = gz::msgs;
#else
namespace messages = ignition::msgs;
#endif
using ignition::transport::Node;
using messages::Int32;
using messages::StringMsg;

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

int listen(Node& node, const std::string& topic, const std::string& type) {
  // static, because the library's threads run until the process ends
  static std::atomic<int> count = 0;
  node.SubscribeRaw(
      topic,
      [](const char*, std::size_t, const ignition::transport::MessageInfo&) {
        if (count++ == 0) say("heard");
      },
      type);
  say("ready");
  ignition::transport::waitForShutdown();
  say(std::to_string(count));
  return 0;
}

int statistics(Node& node, const std::string& topic, const std::string& type) {
  node.EnableStats(topic, true);
  node.SubscribeRaw(
      topic, [](const char*, std::size_t, const ignition::transport::MessageInfo&) {}, type);
  const auto isNumbered = [&] {
    const auto found = node.TopicStats(topic);
    return found && found->PublicationStatistics().Count() > 0;
  };
  while (!isNumbered()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  say("numbered");
  ignition::transport::waitForShutdown();
  return 0;
}

int raw(Node& node, const std::string& topic) {
  node.SubscribeRaw(topic,
                    [](const char*, std::size_t, const ignition::transport::MessageInfo& info) { say(info.Type()); });
  say("ready");
  ignition::transport::waitForShutdown();
  return 0;
}

int texts(Node& node, const std::string& topic) {
  std::function<void(const StringMsg&)> heard = [](const StringMsg& message) { say(message.data()); };
  if (!node.Subscribe(topic, heard)) return 1;
  ignition::transport::waitForShutdown();
  return 0;
}

[[noreturn]] void flood(Node& node, const std::string& topic) {
  Node::Publisher publisher = node.Advertise<Int32>(topic);
  Int32 message;
  say("ready");
  for (int i = 0;; ++i) {
    message.set_data(i);
    publisher.Publish(message);
  }
}

int serve(Node& node, const std::string& name) {
  std::function<bool(const StringMsg&, StringMsg&)> twice = [](const StringMsg& request, StringMsg& reply) {
    reply.set_data(request.data() + request.data());
    return request.data() != "no";
  };
  if (!node.Advertise(name, twice)) return 1;
  say("ready");
  ignition::transport::waitForShutdown();
  return 0;
}

int serveOneWay(Node& node, const std::string& name) {
  // with Fortress's names, the library takes this for a service without a response
  std::function<bool(const StringMsg&, messages::Empty&)> heard = [](const StringMsg& request, messages::Empty&) {
    say(request.data());
    return true;
  };
  if (!node.Advertise(name, heard)) return 1;
  say("ready");
  ignition::transport::waitForShutdown();
  return 0;
}

int call(Node& node, const std::string& name, const std::string& text) {
  StringMsg request, reply;
  request.set_data(text);
  bool isDone = false;
  // The library waits 0.1 s for its connection to a new client, and loses the reply if a busy machine takes longer.
  for (int attempt = 0; attempt < 5; ++attempt) {
    if (!node.Request(name, request, 10'000, reply, isDone)) continue;
    say(isDone ? reply.data() : "refused");
    return 0;
  }
  say("no answer");
  return 0;
}

int callOneWay(Node& node, const std::string& name, const std::string& text) {
  std::vector<ignition::transport::ServicePublisher> there;
  while (!node.ServiceInfo(name, there) || there.empty()) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  StringMsg request;
  request.set_data(text);
#ifdef GZ_NAMES
  // the library's own one-way request has Fortress's name of Empty
  messages::Empty none;
  bool isDone = false;
  node.Request(name, request, 10'000, none, isDone);
  say(isDone ? "told" : "not told");
#else
  say(node.Request(name, request) ? "told" : "not told");
#endif
  ignition::transport::waitForShutdown();
  return 0;
}

int publish(Node& node, const std::string& topic, const std::vector<std::string>& texts) {
  Node::Publisher publisher = node.Advertise<StringMsg>(topic);
  while (!publisher.HasConnections()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  // after discovery, ZeroMQ takes a moment to connect; to further subscribers a little longer
  std::this_thread::sleep_for(std::chrono::seconds(1));
  for (const std::string& text : texts) {
    StringMsg message;
    message.set_data(text);
    publisher.Publish(message);
  }
  say("published");
  ignition::transport::waitForShutdown();
  return 0;
}

#ifndef GZ_NAMES
int answer(Node& node, const std::string& topic, unsigned delay) {
  static Node::Publisher publisher = node.Advertise<Int32>(topic);
  static std::atomic<bool> isHeard = false;
  static std::minstd_rand random(delay);
  std::function<void(const ignition::msgs::Clock&)> heard = [delay](const ignition::msgs::Clock& clock) {
    isHeard = true;
    const auto step = clock.sim().sec() * 1000 + clock.sim().nsec() / 1000000;
    if (step == 0 || step % 10 != 0) return;
    if (delay > 0) std::this_thread::sleep_for(std::chrono::microseconds(random() % (1000 * delay)));
    Int32 key;
    key.set_data(step % 50 < 30 ? 16777235 : 16777234);
    publisher.Publish(key);
  };
  if (!node.Subscribe("/clock", heard)) return 1;
  while (!isHeard || !publisher.HasConnections()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  // as in `publish`
  std::this_thread::sleep_for(std::chrono::seconds(1));
  say("ready");
  ignition::transport::waitForShutdown();
  return 0;
}
#endif

int act(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) return 2;
  Node node;
  const std::string& action = arguments[0];
  if (action == "listen" && arguments.size() == 3) return listen(node, arguments[1], arguments[2]);
  if (action == "statistics" && arguments.size() == 3) return statistics(node, arguments[1], arguments[2]);
  if (action == "raw") return raw(node, arguments[1]);
  if (action == "texts") return texts(node, arguments[1]);
  if (action == "flood") flood(node, arguments[1]);
  if (action == "serve") return serve(node, arguments[1]);
  if (action == "serve-one-way") return serveOneWay(node, arguments[1]);
  if (action == "call" && arguments.size() == 3) return call(node, arguments[1], arguments[2]);
  if (action == "call-one-way" && arguments.size() == 3) return callOneWay(node, arguments[1], arguments[2]);
  if (action == "publish") return publish(node, arguments[1], {arguments.begin() + 2, arguments.end()});
#ifndef GZ_NAMES
  if (action == "answer" && arguments.size() == 3) {
    return answer(node, arguments[1], static_cast<unsigned>(std::stoul(arguments[2])));
  }
#endif
  return 2;
}

}  // namespace

int main(int count, char** words) {
  const int code = act({words + 1, words + count});
  // not exit, which destroys what the library's threads still use
  std::fflush(nullptr);
  std::_Exit(code);
}
