#include "web/world/client_endpoints.hh"

#include <exception>
#include <utility>

namespace pongsim::web {

namespace {

// A system that is switched off never replies.
constexpr std::chrono::seconds kReplyTimeout{10};
constexpr std::size_t kMostRequests = 1000;

}  // namespace

ClientEndpoints::ClientEndpoints(const Node& node, const Logger& log) : node_(node), log_(log) {}

ClientEndpoints::~ClientEndpoints() {
  while (!waiting_.empty()) {
    answer(waiting_.begin(), {CallOutcome::kGone, "the world ended before '" + waiting_.front().service + "' answered"},
           nullptr);
  }
}

void ClientEndpoints::open(std::uint64_t publisher, const std::string& topic, const std::string& type) {
  try {
    publishers_.emplace(publisher, node_.advertiseBytes(topic, type));
  } catch (const std::exception& error) {
    log_.warning("a client can't publish on '" + topic + "': " + error.what());
  }
}

void ClientEndpoints::publish(std::uint64_t publisher, std::span<const std::byte> message) {
  if (const auto found = publishers_.find(publisher); found != publishers_.end()) found->second.publishBytes(message);
}

void ClientEndpoints::close(std::uint64_t publisher) { publishers_.erase(publisher); }

void ClientEndpoints::request(const OwnService& service, const Message& request, Answered answered) {
  answered_.clear();
  waiting_.push_back({service.name, Clock::now() + kReplyTimeout, std::move(answered), {}});
  const auto waiting = std::prev(waiting_.end());
  if (waiting_.size() > kMostRequests) {
    answer(waiting, {CallOutcome::kNoAnswer, "too many requests are waiting for responses"}, nullptr);
    return;
  }
  CallResult refusal{CallOutcome::kNoService, "there is no service '" + service.name + "'"};
  try {
    waiting->pending = node_.request(
        service.name, request, service.replyType,
        [this, waiting](const CallResult& result, const Message& reply) { answer(waiting, result, &reply); });
  } catch (const std::exception& error) {
    refusal.error = error.what();
  }
  if (!waiting->pending) answer(waiting, refusal, nullptr);
}

void ClientEndpoints::failOverdue() {
  answered_.clear();
  if (waiting_.empty()) return;
  const Clock::time_point now = Clock::now();
  while (!waiting_.empty() && waiting_.front().until <= now) {
    answer(waiting_.begin(),
           {CallOutcome::kNoAnswer, "service '" + waiting_.front().service + "' did not answer in time"}, nullptr);
  }
}

void ClientEndpoints::answer(std::list<Waiting>::iterator waiting, const CallResult& result, const Message* reply) {
  answered_.splice(answered_.end(), waiting_, waiting);
  const Answered answered = std::move(waiting->answered);
  if (reply != nullptr) {
    answered(result, *reply);
  } else {
    answered(result, *newMessage("Empty"));
  }
}

}  // namespace pongsim::web
