#include "ign/offered_service.hh"

#include <google/protobuf/message.h>

#include <chrono>
#include <exception>
#include <utility>

#include "ign/replies.hh"
#include "pongsim/log.hh"

namespace pongsim::ign {

namespace {

// Time limit for an answer: a system that is switched off never answers, and the library's thread reads nothing
// meanwhile.
constexpr std::chrono::seconds kPatience{10};

/// The result of a request. Guarded by the service's mutex; shared, because the requester may give up before it is set.
struct Answer {
  bool isThere = false;
  bool isDone = false;
  std::string reply;
};

}  // namespace

OfferedService::OfferedService(const Node& simulation, OwnService service, Generation generation)
    : simulation_(simulation), service_(std::move(service)), generation_(generation) {}

void OfferedService::end() {
  std::unique_lock lock(mutex_);
  hasEnded_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this] { return asking_ == 0; });
}

bool OfferedService::RunLocalCallback(const ignition::transport::ProtoMsg& request,
                                      ignition::transport::ProtoMsg& reply) {
  std::string bytes;
  return RunCallback(request.SerializeAsString(), bytes) && reply.ParseFromString(bytes);
}

bool OfferedService::RunCallback(const std::string& request, std::string& reply) {
  const MessagePointer message = newMessage(service_.requestType);
  if (!message || !message->ParseFromString(request)) {
    static const Logger log("ign");
    log.warning("service '" + service_.name + "': a request by ign-transport is not of type " + service_.requestType +
                "; refused");
    return false;
  }
  {
    const std::lock_guard lock(mutex_);
    if (hasEnded_) return false;
    ++asking_;
  }
  const bool isDone = ask(*message, reply);
  replyGiven();
  const std::lock_guard lock(mutex_);
  --asking_;
  changed_.notify_all();
  return isDone;
}

bool OfferedService::ask(const Message& request, std::string& reply) {
  const auto answer = std::make_shared<Answer>();
  PendingRequest pending;
  try {
    pending = simulation_.request(service_.name, request, service_.replyType,
                                  [this, answer](const CallResult& result, const Message& message) {
                                    const std::lock_guard lock(mutex_);
                                    answer->isDone = result && message.SerializeToString(&answer->reply);
                                    answer->isThere = true;
                                    changed_.notify_all();
                                  });
  } catch (const std::exception&) {
    return false;
  }
  if (!pending) return false;
  if (service_.replyType == kNoReply) return true;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, kPatience, [&] { return answer->isThere || hasEnded_; });
  if (answer->isDone) reply = std::move(answer->reply);
  return answer->isDone;
}

}  // namespace pongsim::ign
