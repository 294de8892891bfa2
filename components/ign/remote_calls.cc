#include "ign/remote_calls.hh"

#include <google/protobuf/message.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "ign/library.hh"
#include "ign/names.hh"

namespace pongsim::ign {

namespace {

using ignition::transport::ServicePublisher;
using ignition::transport::Uuid;

/// @return The services with this name that other processes offer.
std::vector<ServicePublisher> offersOf(const std::string& wireName) {
  std::map<std::string, std::vector<ServicePublisher>> byProcess;
  std::vector<ServicePublisher> offers;
  auto& shared = library();
  if (!shared.TopicPublishers(wireName, byProcess)) return offers;
  for (const auto& [process, publishers] : byProcess) {
    if (process != shared.pUuid) offers.insert(offers.end(), publishers.begin(), publishers.end());
  }
  return offers;
}

}  // namespace

/// A request of any type, as an object of the library's interface.
class RemoteCalls::Request final : public ignition::transport::IReqHandler {
 public:
  struct Answer {
    bool isThere = false;
    bool isDone = false;
    std::string reply;
  };

  Request(const RemoteCalls& calls, const Message& request, std::string replyType)
      : IReqHandler(calls.nodeUuid_),
        shared_(calls.shared_),
        bytes_(request.SerializeAsString()),
        requestType_(wireType(request.GetTypeName(), calls.generation_)),
        replyType_(wireType(std::move(replyType), calls.generation_)) {}

  void NotifyResult(const std::string& reply, const bool isDone) override {
    const std::lock_guard lock(shared_->mutex);
    answer_ = {true, isDone, reply};
    shared_->changed.notify_all();
  }
  bool Serialize(std::string& bytes) const override {
    bytes = bytes_;
    return true;
  }
  std::string ReqTypeName() const override { return requestType_; }
  std::string RepTypeName() const override { return replyType_; }

  /// Waits for the response, until the timeout or until the calls end.
  Answer wait(std::chrono::nanoseconds timeout) {
    std::unique_lock lock(shared_->mutex);
    shared_->changed.wait_for(lock, timeout, [this] { return answer_.isThere || shared_->hasEnded; });
    return answer_;
  }

 private:
  const std::shared_ptr<Shared> shared_;
  Answer answer_;
  const std::string bytes_;
  const std::string requestType_;
  const std::string replyType_;
};

RemoteCalls::RemoteCalls(Generation generation) : generation_(generation), nodeUuid_(Uuid().ToString()) {}

void RemoteCalls::end() {
  const std::lock_guard lock(shared_->mutex);
  shared_->hasEnded = true;
  shared_->changed.notify_all();
}

std::optional<CallResult> RemoteCalls::call(const std::string& service, const Message& request, Message& reply,
                                            std::chrono::nanoseconds timeout) {
  const std::optional<std::string> name = wireName(service);
  if (!name) return std::nullopt;
  auto& shared = library();
  const std::vector<ServicePublisher> offers = offersOf(*name);
  if (offers.empty()) {
    // starts a discovery, so that a later call may find the service
    shared.DiscoverService(*name);
    return std::nullopt;
  }
  const auto pending = std::make_shared<Request>(*this, request, reply.GetTypeName());
  const auto fits = [&](const ServicePublisher& offer) {
    return offer.ReqTypeName() == pending->ReqTypeName() && offer.RepTypeName() == pending->RepTypeName();
  };
  const std::string quoted = "service '" + service + "' ";
  if (std::ranges::none_of(offers, fits)) {
    return CallResult{CallOutcome::kOtherTypes, quoted + "takes " + ownType(offers.front().ReqTypeName()) +
                                                    " and returns " + ownType(offers.front().RepTypeName())};
  }
  const std::string number = pending->HandlerUuid();
  {
    const std::lock_guard lock(shared.mutex);
    shared.requests.AddHandler(*name, nodeUuid_, pending);
  }
  shared.SendPendingRemoteReqs(*name, pending->ReqTypeName(), pending->RepTypeName());
  const bool isAnswered = reply.GetTypeName() != kNoReply;
  const Request::Answer answer = isAnswered ? pending->wait(timeout) : Request::Answer();
  {
    // the library itself removes only requests without a reply, if they have Fortress's names
    const std::lock_guard lock(shared.mutex);
    shared.requests.RemoveHandler(*name, nodeUuid_, number);
  }
  if (!isAnswered) return CallResult{CallOutcome::kDone, {}};
  if (!answer.isThere) return CallResult{CallOutcome::kNoAnswer, quoted + "did not answer in time"};
  if (!answer.isDone) return CallResult{CallOutcome::kRefused, quoted + "refused"};
  if (reply.ParseFromString(answer.reply)) return CallResult{CallOutcome::kDone, {}};
  return CallResult{CallOutcome::kNoAnswer, quoted + "sent a reply that is not of type " + reply.GetTypeName()};
}

}  // namespace pongsim::ign
