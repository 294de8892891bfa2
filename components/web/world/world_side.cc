#include "web/world/world_side.hh"

#include <exception>
#include <utility>

namespace pongsim::web {

namespace {

// A system that is switched off does not respond.
constexpr std::chrono::seconds kPatience{10};
constexpr std::size_t kMostRequests = 1000;

}  // namespace

WorldSide::WorldSide(const Node& node, const Logger& log) : node_(node), log_(log) {}

WorldSide::~WorldSide() {
  while (!waiting_.empty()) {
    answer(waiting_.begin(), {CallOutcome::kGone, "the world ended before '" + waiting_.front().service + "' answered"},
           nullptr);
  }
}

void WorldSide::open(std::uint64_t voice, const std::string& topic, const std::string& type) {
  try {
    voices_.emplace(voice, node_.advertiseBytes(topic, type));
  } catch (const std::exception& error) {
    log_.warning("a client can't publish on '" + topic + "': " + error.what());
  }
}

void WorldSide::publish(std::uint64_t voice, std::span<const std::byte> message) {
  if (const auto found = voices_.find(voice); found != voices_.end()) found->second.publishBytes(message);
}

void WorldSide::close(std::uint64_t voice) { voices_.erase(voice); }

void WorldSide::request(const OwnService& service, const Message& request, Answered answered) {
  answered_.clear();
  waiting_.push_back({service.name, Clock::now() + kPatience, std::move(answered), {}});
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

void WorldSide::giveUpOld() {
  answered_.clear();
  if (waiting_.empty()) return;
  const Clock::time_point now = Clock::now();
  while (!waiting_.empty() && waiting_.front().until <= now) {
    answer(waiting_.begin(),
           {CallOutcome::kNoAnswer, "service '" + waiting_.front().service + "' did not answer in time"}, nullptr);
  }
}

void WorldSide::answer(std::list<Waiting>::iterator waiting, const CallResult& result, const Message* reply) {
  answered_.splice(answered_.end(), waiting_, waiting);
  const Answered answered = std::move(waiting->answered);
  if (reply != nullptr) {
    answered(result, *reply);
  } else {
    answered(result, *newMessage("Empty"));
  }
}

}  // namespace pongsim::web
