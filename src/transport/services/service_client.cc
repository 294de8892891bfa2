#include "transport/services/service_client.hh"

#include <algorithm>
#include <utility>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/dispatch_queue.hh"
#include "transport/names/service_name.hh"
#include "transport/network/network.hh"
#include "transport/payload.hh"
#include "transport/services/service_server.hh"

namespace pongsim::transport {

namespace {

// How soon it is seen that the service that has come has other types.
constexpr std::chrono::milliseconds kLookForReaders{20};

CallResult failed(CallOutcome outcome, const std::string& service, const std::string& what) {
  return {outcome, "service '" + service + "' " + what};
}

std::string takes(std::string_view requestType, std::string_view replyType) {
  return "takes " + std::string(requestType) + " and returns " + std::string(replyType);
}

}  // namespace

/// Notes down a call for as long as somebody waits for it.
class ServiceClient::CallScope {
 public:
  CallScope(ServiceClient& client, const ParticipantId& server) : client_(client) {
    const std::lock_guard lock(client.mutex_);
    number_ = client.nextCall_++;
    call_ = &client.calls_[number_];
    call_->server = server;
  }
  ~CallScope() {
    const std::lock_guard lock(client_.mutex_);
    client_.calls_.erase(number_);
  }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

  std::uint64_t number() const { return number_; }

  /// Waits for the answer; `isThere` says whether the service still is.
  template <class IsThere>
  CallResult wait(const std::string& service, Message& reply, TimePoint deadline, IsThere isThere) {
    std::unique_lock lock(client_.mutex_);
    client_.changed_.wait_until(lock, deadline, [&] { return call_->header || call_->gone || !isThere(); });
    if (!call_->header && !call_->gone && isThere()) {
      return failed(CallOutcome::kNoAnswer, service, "did not answer in time");
    }
    return read(service, call_->header, call_->message, reply);
  }

 private:
  ServiceClient& client_;
  std::uint64_t number_ = 0;
  Call* call_ = nullptr;
};

ServiceClient::ServiceClient(Network* network, ServiceServer& own, std::function<void(DispatchQueue&)> arrived)
    : network_(network), own_(own), arrived_(std::move(arrived)) {}

ServiceClient::~ServiceClient() {
  for (auto& [key, line] : lines_) {
    network_->end(std::move(line->reader));
    network_->end(std::move(line->writer));
  }
}

CallResult ServiceClient::call(const DispatchQueue& asker, std::string_view service, const Message& request,
                               Message& reply, TimePoint deadline) {
  const std::string name = absoluteService(service);
  if (const auto types = own_.typesOf(asker, name)) {
    if (types->first == msgs::typeName(request) && types->second == msgs::typeName(reply)) {
      return callOwn(asker, name, request, reply, deadline);
    }
    return failed(CallOutcome::kOtherTypes, name, takes(types->first, types->second));
  }
  if (std::optional<CallResult> result = gateways_.call(name, request, reply, deadline)) return *result;
  CallResult result{CallOutcome::kNoService, "there is no service '" + name + "'"};
  if (network_ != nullptr) {
    network_->announce();
    result = callOther(name, request, reply, deadline);
  }
  if (result.outcome != CallOutcome::kNoService) return result;
  // it may have come meanwhile
  return gateways_.call(name, request, reply, deadline).value_or(std::move(result));
}

CallResult ServiceClient::callOwn(const DispatchQueue& asker, const std::string& service, const Message& request,
                                  Message& reply, TimePoint deadline) {
  CallScope call(*this, {});
  std::vector<std::byte> message(msgs::byteSize(request));
  msgs::writeBytes(request, message);
  if (!own_.post(asker, service, call.number(), std::move(message))) {
    if (!own_.typesOf(asker, service)) return {CallOutcome::kNoService, "there is no service '" + service + "'"};
    return failed(CallOutcome::kNoAnswer, service, "has too many requests waiting");
  }
  return call.wait(service, reply, deadline, [] { return true; });
}

CallResult ServiceClient::callOther(const std::string& service, const Message& request, Message& reply,
                                    TimePoint deadline) {
  Line& line = lineTo(service, serviceType(msgs::typeName(request), msgs::typeName(reply)));
  const std::optional<ParticipantId> server = waitForServer(line, deadline);
  if (!server) {
    const std::string other = otherTypes(line);
    if (!other.empty()) return failed(CallOutcome::kOtherTypes, service, other);
    return {CallOutcome::kNoService, "there is no service '" + service + "'"};
  }

  CallScope call(*this, *server);
  const RequestHeader header{*server, call.number()};
  const std::size_t size = msgs::byteSize(request);
  if (size > kMaximumMessage) return failed(CallOutcome::kNoAnswer, service, "can't be sent such a large request");
  line.writer->write(headerSize(header) + size,
                     [&](std::span<std::byte> place) { msgs::writeBytes(request, writeHeader(header, place)); });
  return call.wait(service, reply, deadline, [&] { return line.writer->hasReaderOf(*server); });
}

ServiceClient::Line& ServiceClient::lineTo(const std::string& service, const std::string& type) {
  const std::lock_guard lock(setUp_);
  const std::string key = service + " " + type;
  if (const auto found = lines_.find(key); found != lines_.end()) return *found->second;
  // both ways or none
  network_->requirePermission(TopicUse::kSubscribe, replyTopic(service));
  network_->requirePermission(TopicUse::kPublish, requestTopic(service));
  auto line = std::make_unique<Line>();
  line->service = service;
  line->type = type;
  // the way back first: a request waits at the service until that is known
  line->reader = network_->makeReader(replyTopic(service), type,
                                      [this, to = line.get()](const ParticipantId& sender, const Buffer& sample) {
                                        receive(*to, sender, sample.bytes);
                                      });
  try {
    line->writer = network_->makeWriter(
        requestTopic(service), type, [this] { changed(); }, line->reader->participant(), Content::kCalls);
    return *lines_.emplace(key, std::move(line)).first->second;
  } catch (...) {
    network_->end(std::move(line->reader));
    if (line->writer) network_->end(std::move(line->writer));
    throw;
  }
}

/// @return A process that has the service; nothing at `deadline` or where the only ones have it with other types.
std::optional<ParticipantId> ServiceClient::waitForServer(const Line& line, TimePoint deadline) {
  for (bool late = false;;) {
    if (const std::optional<ParticipantId> server = line.writer->newestReader()) return server;
    if (late || !otherTypes(line).empty()) return std::nullopt;
    std::unique_lock lock(mutex_);
    const TimePoint now = std::chrono::steady_clock::now();
    late = now >= deadline;
    changed_.wait_until(lock, std::min(deadline, now + kLookForReaders), [&] { return line.writer->hasReaders(); });
  }
}

/// @return What the service that is there takes, or nothing where there is none or one of the line's types, which may
/// be known before there is a way to it.
std::string ServiceClient::otherTypes(const Line& line) const {
  const ServiceInfo info = network_->directory().service(line.service);
  const auto fits = [&line](const ServiceInfo::Provider& provider) {
    return serviceType(provider.requestType, provider.replyType) == line.type;
  };
  if (info.providers.empty() || std::ranges::any_of(info.providers, fits)) return {};
  return takes(info.providers.front().requestType, info.providers.front().replyType);
}

void ServiceClient::receive(const Line& line, const ParticipantId& sender, std::span<const std::byte> payload) {
  std::optional<std::span<const std::byte>> message = messageInPayload(payload);
  std::optional<ReplyHeader> header = message ? readReplyHeader(*message) : std::nullopt;
  if (!header) {
    static const Logger log("transport");
    log.warning("service '" + line.service + "': a reply from process " +
                std::to_string(network_->directory().pidOf(sender)) + " is damaged; dropped");
    return;
  }
  if (header->client != line.reader->participant()) return;
  {
    const std::lock_guard lock(mutex_);
    const auto call = calls_.find(header->call);
    if (call == calls_.end() || call->second.server != sender) return;
    call->second.message.assign(message->begin(), message->end());
    call->second.header = std::move(header);
  }
  changed_.notify_all();
}

void ServiceClient::answerOwn(const DispatchQueue& queue, std::uint64_t number,
                              const std::optional<ReplyHeader>& header, std::span<const std::byte> message) {
  std::map<std::uint64_t, Posted>::node_type posted;
  DispatchQueue* other = nullptr;
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = posted_.find(number); found != posted_.end() && found->second.asker != &queue) {
      // its function is for the thread of who asked
      other = found->second.asker;
      found->second.header = header;
      found->second.message.assign(message.begin(), message.end());
      other->answeredRequests.push_back(number);
    } else {
      posted = posted_.extract(number);
    }
    const auto call = calls_.find(number);
    if (call != calls_.end()) {
      call->second.gone = !header;
      call->second.header = header;
      call->second.message.assign(message.begin(), message.end());
    }
  }
  changed_.notify_all();
  if (other != nullptr) {
    other->answersWaiting = true;
    arrived_(*other);
  }
  if (!posted) return;
  const Posted& request = posted.mapped();
  request.asker->attempt(
      [&] { request.answered(read(request.service, header, message, *request.reply), *request.reply); });
}

std::size_t ServiceClient::dispatch(DispatchQueue& queue) {
  // before it is looked at: what comes from now on sets it again
  if (!queue.answersWaiting.exchange(false)) return 0;
  std::vector<std::uint64_t> numbers;
  {
    const std::lock_guard lock(mutex_);
    numbers.swap(queue.answeredRequests);
  }
  std::size_t called = 0;
  for (const std::uint64_t number : numbers) {
    std::map<std::uint64_t, Posted>::node_type posted;
    {
      const std::lock_guard lock(mutex_);
      posted = posted_.extract(number);
    }
    if (!posted) continue;
    const Posted& request = posted.mapped();
    queue.attempt([&] {
      request.answered(read(request.service, request.header, request.message, *request.reply), *request.reply);
    });
    ++called;
  }
  return called;
}

std::optional<std::uint64_t> ServiceClient::post(DispatchQueue& asker, std::string_view service, const Message& request,
                                                 const std::string& replyType, Answered answered) {
  const std::string name = absoluteService(service);
  const auto types = own_.typesOf(asker, name);
  if (!types || types->first != msgs::typeName(request) || types->second != replyType) return std::nullopt;
  std::vector<std::byte> message(msgs::byteSize(request));
  msgs::writeBytes(request, message);
  std::uint64_t number = 0;
  {
    const std::lock_guard lock(mutex_);
    number = nextCall_++;
    if (answered) posted_[number] = {&asker, name, newMessage(replyType), std::move(answered)};
  }
  try {
    if (own_.post(asker, name, number, std::move(message))) return number;
  } catch (...) {
    forget(number);
    throw;
  }
  forget(number);
  return std::nullopt;
}

void ServiceClient::forget(std::uint64_t request) {
  std::map<std::uint64_t, Posted>::node_type posted;
  // its function ends without the mutex
  const std::lock_guard lock(mutex_);
  posted = posted_.extract(request);
}

/// Reads an answer; there is no header where the service has gone.
CallResult ServiceClient::read(const std::string& service, const std::optional<ReplyHeader>& header,
                               std::span<const std::byte> message, Message& reply) {
  if (!header) return failed(CallOutcome::kGone, service, "ended before it answered");
  if (!header->done) {
    return failed(CallOutcome::kRefused, service, "refused" + (header->reason.empty() ? "" : ": " + header->reason));
  }
  if (msgs::parseBytes(message, reply)) return {CallOutcome::kDone, {}};
  return failed(CallOutcome::kNoAnswer, service, "sent a reply that is not of type " + msgs::typeName(reply));
}

void ServiceClient::changed() {
  // whoever is about to wait has looked either before, and waits by now, or afterwards
  { const std::lock_guard lock(mutex_); }
  changed_.notify_all();
}

}  // namespace pongsim::transport
