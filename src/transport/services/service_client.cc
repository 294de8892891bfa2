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

// Period of checking whether the service has appeared with other types, which changes no reader.
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
  /// @param here,server The participants between which the call goes; zero for a service of this transport.
  CallScope(ServiceClient& client, const ParticipantId& here, const ParticipantId& server) : client_(client) {
    const Lock lock(client.mutex_);
    number_ = client.nextCall_++;
    call_ = &client.calls_[number_];
    call_->client = here;
    call_->server = server;
  }
  ~CallScope() {
    const Lock lock(client_.mutex_);
    client_.calls_.erase(number_);
  }
  CallScope(const CallScope&) = delete;
  CallScope& operator=(const CallScope&) = delete;

  std::uint64_t number() const { return number_; }

  /// Waits for the answer; `isThere` says whether the service still is.
  template <class IsThere>
  CallResult wait(const std::string& service, Message& reply, TimePoint deadline, IsThere isThere) {
    Lock lock(client_.mutex_);
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
  for (auto& [key, connection] : connections_) {
    network_->end(std::move(connection->reader));
    network_->end(std::move(connection->writer));
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
  // a gateway may have found it meanwhile
  return gateways_.call(name, request, reply, deadline).value_or(std::move(result));
}

CallResult ServiceClient::callOwn(const DispatchQueue& asker, const std::string& service, const Message& request,
                                  Message& reply, TimePoint deadline) {
  CallScope call(*this, {}, {});
  std::vector<std::byte> message(msgs::byteSize(request));
  msgs::writeBytes(request, message);
  if (!own_.post(asker, service, call.number(), std::move(message), false)) {
    if (!own_.typesOf(asker, service)) return {CallOutcome::kNoService, "there is no service '" + service + "'"};
    return failed(CallOutcome::kNoAnswer, service, "has too many requests waiting");
  }
  return call.wait(service, reply, deadline, [] { return true; });
}

CallResult ServiceClient::callOther(const std::string& service, const Message& request, Message& reply,
                                    TimePoint deadline) {
  Connection& connection = connectionTo(service, serviceType(msgs::typeName(request), msgs::typeName(reply)));
  const std::optional<ParticipantId> server = waitForServer(connection, deadline);
  if (!server) {
    const std::string other = otherTypes(connection);
    if (!other.empty()) return failed(CallOutcome::kOtherTypes, service, other);
    return {CallOutcome::kNoService, "there is no service '" + service + "'"};
  }

  CallScope call(*this, connection.reader->participant(), *server);
  const RequestHeader header{*server, call.number()};
  const std::size_t size = msgs::byteSize(request);
  if (size > kMaximumMessage) return failed(CallOutcome::kNoAnswer, service, "can't be sent such a large request");
  connection.writer->write(headerSize(header) + size,
                           [&](std::span<std::byte> place) { msgs::writeBytes(request, writeHeader(header, place)); });
  return call.wait(service, reply, deadline, [&] { return connection.writer->hasReaderOf(*server); });
}

ServiceClient::Connection& ServiceClient::connectionTo(const std::string& service, const std::string& type) {
  const Lock lock(connecting_);
  const std::string key = service + " " + type;
  if (const auto found = connections_.find(key); found != connections_.end()) return *found->second;
  // both before the first endpoint, so that a missing permission leaves nothing
  network_->requirePermission(TopicUse::kSubscribe, replyTopic(service));
  network_->requirePermission(TopicUse::kPublish, requestTopic(service));
  auto connection = std::make_unique<Connection>();
  connection->service = service;
  connection->type = type;
  // the reader of replies first: the service holds a request back until it has found that reader
  connection->reader = network_->makeReader(
      replyTopic(service), type, [this, to = connection.get()](const ParticipantId& sender, const Buffer& sample) {
        receive(*to, sender, sample.bytes);
      });
  try {
    connection->writer = network_->makeWriter(
        requestTopic(service), type, [this] { changed(); }, connection->reader->participant(), Content::kCalls);
    return *connections_.emplace(key, std::move(connection)).first->second;
  } catch (...) {
    network_->end(std::move(connection->reader));
    if (connection->writer) network_->end(std::move(connection->writer));
    throw;
  }
}

/// @return A process that has the service; nothing at `deadline` or where the only ones have it with other types.
std::optional<ParticipantId> ServiceClient::waitForServer(const Connection& connection, TimePoint deadline) {
  for (bool late = false;;) {
    if (const std::optional<ParticipantId> server = connection.writer->newestReader()) return server;
    if (late || !otherTypes(connection).empty()) return std::nullopt;
    Lock lock(mutex_);
    const TimePoint now = std::chrono::steady_clock::now();
    late = now >= deadline;
    changed_.wait_until(lock, std::min(deadline, now + kLookForReaders),
                        [&] { return connection.writer->hasReaders(); });
  }
}

/// @return The types of the service, if it exists only with other types than the connection's. Empty also while a
/// service with the right types is announced but not yet matched.
std::string ServiceClient::otherTypes(const Connection& connection) const {
  const ServiceInfo info = network_->directory().service(connection.service);
  const auto fits = [&connection](const ServiceInfo::Provider& provider) {
    return serviceType(provider.requestType, provider.replyType) == connection.type;
  };
  if (info.providers.empty() || std::ranges::any_of(info.providers, fits)) return {};
  return takes(info.providers.front().requestType, info.providers.front().replyType);
}

// Replies to others may come while the connection is made or ends: its endpoints are not looked at.
void ServiceClient::receive(const Connection& connection, const ParticipantId& sender,
                            std::span<const std::byte> payload) {
  std::optional<std::span<const std::byte>> message = messageInPayload(payload);
  std::optional<ReplyHeader> header = message ? readReplyHeader(*message) : std::nullopt;
  if (!header) {
    static const Logger log("transport");
    log.warning("service '" + connection.service + "': a reply from process " +
                std::to_string(network_->directory().pidOf(sender)) + " is damaged; dropped");
    return;
  }
  {
    const Lock lock(mutex_);
    const auto call = calls_.find(header->call);
    if (call == calls_.end() || call->second.client != header->client || call->second.server != sender) return;
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
    const Lock lock(mutex_);
    if (const auto found = posted_.find(number); found != posted_.end() && found->second.asker != &queue) {
      // called in the asker's dispatch, on its thread
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
  // cleared first: a response that arrives from now on sets it again
  if (!queue.answersWaiting.exchange(false)) return 0;
  std::vector<std::uint64_t> numbers;
  {
    const Lock lock(mutex_);
    numbers.swap(queue.answeredRequests);
  }
  std::size_t called = 0;
  for (const std::uint64_t number : numbers) {
    std::map<std::uint64_t, Posted>::node_type posted;
    {
      const Lock lock(mutex_);
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

bool ServiceClient::isWaitedFor(std::uint64_t call) {
  const Lock lock(mutex_);
  return calls_.contains(call);
}

std::optional<std::uint64_t> ServiceClient::post(DispatchQueue& asker, std::string_view service, const Message& request,
                                                 const std::string& replyType, Answered answered, bool isOwn) {
  const std::string name = absoluteService(service);
  const auto types = own_.typesOf(asker, name);
  if (!types || types->first != msgs::typeName(request) || types->second != replyType) return std::nullopt;
  std::vector<std::byte> message(msgs::byteSize(request));
  msgs::writeBytes(request, message);
  std::uint64_t number = 0;
  {
    const Lock lock(mutex_);
    number = nextCall_++;
    if (answered) posted_[number] = {&asker, name, newMessage(replyType), std::move(answered)};
  }
  try {
    if (own_.post(asker, name, number, std::move(message), isOwn)) return number;
  } catch (...) {
    forget(number);
    throw;
  }
  forget(number);
  return std::nullopt;
}

void ServiceClient::forget(std::uint64_t request) {
  std::map<std::uint64_t, Posted>::node_type posted;
  // declared before the lock: its function is destroyed without the mutex
  const Lock lock(mutex_);
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
  // locked once, so that a thread that is about to wait, and has seen nothing yet, does not miss the notification
  { const Lock lock(mutex_); }
  changed_.notify_all();
}

}  // namespace pongsim::transport
