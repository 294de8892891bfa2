#include "transport/services/service_server.hh"

#include <algorithm>
#include <exception>
#include <stdexcept>

#include "msgs/encoding/bytes.hh"
#include "pongsim/log.hh"
#include "transport/dispatch_queue.hh"
#include "transport/names/service_name.hh"
#include "transport/names/type_name.hh"
#include "transport/network/network.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

// Limits of the requests that wait for one service.
constexpr std::size_t kMaximumRequests = 1000;
constexpr std::size_t kMaximumBytes = 32 << 20;

// A caller whose reader has not been found after this time is taken to have ended.
constexpr std::chrono::seconds kPatience{10};

// How long the end of a service waits for its last replies to arrive.
constexpr std::chrono::milliseconds kFarewell{500};

constexpr ParticipantId kOwn{};

const Logger& serverLog() {
  static const Logger logger("transport");
  return logger;
}

/// @return The endpoint by which callers find the service.
Endpoint announced(const Offer& offer) {
  return {requestTopic(offer.name), serviceType(offer.requestType, offer.replyType), Role::kSubscriber};
}

}  // namespace

Offer::Offer(DispatchQueue& place, std::string service, std::string typeOfRequest, std::string typeOfReply,
             ServiceHandler function, bool isWorlds)
    : queue(place),
      name(std::move(service)),
      requestType(std::move(typeOfRequest)),
      replyType(std::move(typeOfReply)),
      handler(std::move(function)),
      isOfWorld(isWorlds),
      request(newMessage(requestType)),
      reply(newMessage(replyType)) {}

Offer::~Offer() = default;

ServiceServer::ServiceServer(Network* network, Arrived arrived, AnswerOwn answerOwn)
    : network_(network), arrived_(std::move(arrived)), answerOwn_(std::move(answerOwn)) {}

ServiceServer::~ServiceServer() = default;

Offer& ServiceServer::add(DispatchQueue& queue, std::string_view service, std::string_view requestType,
                          std::string_view replyType, ServiceHandler handler, bool isOfWorld) {
  auto owned = std::make_unique<Offer>(queue, absoluteService(service), knownType(requestType), knownType(replyType),
                                       std::move(handler), isOfWorld);
  Offer& offer = *owned;
  bool isFirst = false;
  {
    const RequestsLock lock(mutex_);
    const auto found = offers_.find(offer.name);
    isFirst = found == offers_.end();
    if (isFirst) {
      std::vector<std::unique_ptr<Offer>> offers;
      offers.push_back(std::move(owned));
      offers_.emplace(offer.name, std::move(offers));
    } else if (std::ranges::any_of(found->second, [&queue](const auto& other) { return &other->queue == &queue; })) {
      throw std::invalid_argument("service '" + std::string(service) + "' is already offered");
    } else {
      found->second.push_back(std::move(owned));
    }
    ++version_;
  }
  try {
    if (isFirst) {
      open(offer);
    } else {
      serverLog().warning("service '" + offer.name +
                          "' is also offered by another world of this process: callers in other processes get the "
                          "reply of the first");
    }
  } catch (...) {
    close(offer);
    throw;
  }
  return offer;
}

/// Lets other processes find the service.
void ServiceServer::open(Offer& offer) {
  if (network_ == nullptr) return;
  const std::string type = serviceType(offer.requestType, offer.replyType);
  // the writer of replies first: a caller finds the service by its reader
  offer.writer = network_->makeWriter(
      replyTopic(offer.name), type, [this, &offer] { wake(offer.queue); }, std::nullopt, Content::kCalls);
  offer.reader = network_->makeReader(
      requestTopic(offer.name), type,
      [this, &offer](const ParticipantId& sender, const Buffer& sample) { receive(offer, sender, sample.bytes); }, {},
      offer.writer->participant());
  network_->directory().addOwn(announced(offer));
}

/// After the end of one: the next one of that name answers from now on.
void ServiceServer::openNext(const std::string& service) {
  Offer* next = nullptr;
  {
    const RequestsLock lock(mutex_);
    const auto found = offers_.find(service);
    if (found != offers_.end() && !found->second.front()->reader) next = found->second.front().get();
  }
  if (next == nullptr) return;
  try {
    open(*next);
  } catch (const std::exception& error) {
    serverLog().error("service '" + service + "' can't be called from other processes: " + error.what());
  }
}

void ServiceServer::end(Offer& offer, bool inDispatch) {
  std::unique_ptr<Offer> owned = close(offer);
  if (inDispatch) offer.queue.endedOffers.push_back(std::move(owned));
}

/// Ends a service for everybody.
std::unique_ptr<Offer> ServiceServer::close(Offer& offer) {
  std::unique_ptr<Offer> owned;
  std::deque<Offer::Request> unanswered;
  {
    const RequestsLock lock(mutex_);
    const auto offers = offers_.find(offer.name);
    const auto found = std::ranges::find(offers->second, &offer, &std::unique_ptr<Offer>::get);
    owned = std::move(*found);
    offers->second.erase(found);
    if (offers->second.empty()) offers_.erase(offers);
    ++version_;
    offer.ended = true;
    unanswered.swap(offer.waiting);
  }
  for (const Offer::Request& request : unanswered) {
    if (request.client == kOwn) answerOwn_(offer.queue, request.call, std::nullopt, {});
  }
  // last replies must arrive before the reader ends: without it, callers stop waiting
  if (offer.writer) offer.writer->waitForAcknowledgement(kFarewell);
  if (offer.reader) {
    network_->directory().removeOwn(announced(offer));
    network_->end(std::move(offer.reader));
  }
  if (offer.writer) network_->end(std::move(offer.writer));
  if (network_ != nullptr) openNext(offer.name);
  return owned;
}

/// @return The service that answers; null where there is none.
Offer* ServiceServer::find(const DispatchQueue& asker, const std::string& service) const {
  const auto found = offers_.find(service);
  if (found == offers_.end()) return nullptr;
  const auto own = std::ranges::find_if(found->second, [&asker](const auto& each) { return &each->queue == &asker; });
  return own != found->second.end() ? own->get() : found->second.front().get();
}

std::optional<std::pair<std::string, std::string>> ServiceServer::typesOf(const DispatchQueue& asker,
                                                                          const std::string& service) const {
  const RequestsLock lock(mutex_);
  const Offer* offer = find(asker, service);
  if (offer == nullptr) return std::nullopt;
  return std::pair(offer->requestType, offer->replyType);
}

std::vector<OwnService> ServiceServer::services(const DispatchQueue& queue) const {
  const RequestsLock lock(mutex_);
  std::vector<OwnService> services;
  for (const auto& [name, offers] : offers_) {
    for (const auto& offer : offers) {
      if (&offer->queue == &queue) services.push_back({name, offer->requestType, offer->replyType});
    }
  }
  return services;
}

void ServiceServer::wake(DispatchQueue& queue) {
  queue.requestsWaiting = true;
  arrived_(queue);
}

void ServiceServer::receive(Offer& offer, const ParticipantId& sender, std::span<const std::byte> payload) {
  std::optional<std::span<const std::byte>> message = messageInPayload(payload);
  const std::optional<RequestHeader> header = message ? readRequestHeader(*message) : std::nullopt;
  if (!header) {
    complain(offer, sender, "is damaged");
    return;
  }
  if (header->server != offer.writer->participant() || offer.ended) return;
  bool isAppended = false;
  {
    const RequestsLock lock(mutex_);
    isAppended =
        append(offer, {0, sender, header->call, std::chrono::steady_clock::now(), {message->begin(), message->end()}});
  }
  if (!isAppended) {
    complain(offer, sender, "came while too many were waiting");
    return;
  }
  wake(offer.queue);
}

/// @return Whether there is room for it.
bool ServiceServer::append(Offer& offer, Offer::Request request) {
  if (offer.ended || offer.waiting.size() >= kMaximumRequests) return false;
  if (!offer.waiting.empty() && offer.waitingBytes + request.message.size() > kMaximumBytes) return false;
  request.number = nextNumber_++;
  const std::size_t bytes = request.message.size();
  offer.waiting.push_back(std::move(request));
  offer.waitingBytes += bytes;
  return true;
}

bool ServiceServer::post(const DispatchQueue& asker, const std::string& service, std::uint64_t call,
                         std::vector<std::byte> message, bool isOwn) {
  DispatchQueue* queue = nullptr;
  {
    const RequestsLock lock(mutex_);
    Offer* offer = find(asker, service);
    Offer::Request request{
        0, kOwn, call, std::chrono::steady_clock::now(), std::move(message), isOwn ? &asker : nullptr};
    if (offer == nullptr || !append(*offer, std::move(request))) return false;
    queue = &offer->queue;
  }
  wake(*queue);
  return true;
}

/// Moves those whose answers would arrive to `ready`, and drops those that nobody waits for any more.
void ServiceServer::takeReady(Offer& offer, const IsInside& isInside, std::vector<Ready>& ready) {
  const TimePoint tooOld = std::chrono::steady_clock::now() - kPatience;
  const std::uint64_t limit = offer.queue.requestLimit;
  const bool isReplaced = offer.queue.replaces();
  std::erase_if(offer.waiting, [&](Offer::Request& request) REQUIRES(requestsRole) {
    if (isReplaced && request.client != kOwn) return false;
    if (request.number >= limit && !(request.client == kOwn && isInside(request.call))) return false;
    const bool isReady = request.client == kOwn || (offer.writer && offer.writer->hasReaderOf(request.client));
    if (!isReady && request.came >= tooOld) return false;
    offer.waitingBytes -= request.message.size();
    if (isReady) ready.push_back({&offer, std::move(request)});
    return true;
  });
}

std::size_t ServiceServer::dispatch(DispatchQueue& queue, const IsInside& isInside) {
  // cleared first: a request that arrives from now on sets it again
  if (!queue.requestsWaiting.exchange(false)) return 0;
  std::vector<Ready> ready;
  {
    const RequestsLock lock(mutex_);
    for (const auto& [name, offers] : offers_) {
      for (const auto& offer : offers) {
        if (&offer->queue == &queue) takeReady(*offer, isInside, ready);
      }
    }
  }
  std::ranges::sort(ready, {}, [](const Ready& each) { return each.request.number; });
  if (queue.gate != nullptr) queue.replaces() ? replace(queue, ready) : note(queue, ready);
  for (const Ready& each : ready) {
    if (each.offer->ended) {
      if (each.request.client == kOwn) answerOwn_(queue, each.request.call, std::nullopt, {});
    } else {
      handle(*each.offer, each.request);
    }
  }
  queue.endedOffers.clear();
  return ready.size();
}

void ServiceServer::discard(DispatchQueue& queue, const std::function<bool(std::uint64_t call)>& isMeant) {
  std::vector<std::uint64_t> dropped;
  {
    const RequestsLock lock(mutex_);
    for (const auto& [name, offers] : offers_) {
      for (const auto& offer : offers) {
        if (&offer->queue != &queue) continue;
        std::erase_if(offer->waiting, [&](const Offer::Request& request) REQUIRES(requestsRole) {
          if (request.client != kOwn || !isMeant(request.call)) return false;
          offer->waitingBytes -= request.message.size();
          dropped.push_back(request.call);
          return true;
        });
      }
    }
  }
  for (const std::uint64_t call : dropped) answerOwn_(queue, call, std::nullopt, {});
}

void ServiceServer::handle(Offer& offer, const Offer::Request& request) {
  if (!msgs::parseBytes(request.message, *offer.request)) {
    complain(offer, request.client, "is not of type " + offer.requestType);
    answer(offer, request, ServiceAnswer::refused("the request is not of type " + offer.requestType));
    return;
  }
  answer(offer, request, ask(offer));
}

ServiceAnswer ServiceServer::ask(Offer& offer) {
  // clears it; Message::Clear needs the complete class
  msgs::parseBytes({}, *offer.reply);
  try {
    return offer.handler(*offer.request, *offer.reply);
  } catch (const std::exception& error) {
    serverLog().error("service '" + offer.name + "': " + error.what());
    return ServiceAnswer::refused(error.what());
  } catch (...) {
    static constexpr const char* kWhat = "it threw something other than a std::exception";
    serverLog().error("service '" + offer.name + "': " + kWhat);
    return ServiceAnswer::refused(kWhat);
  }
}

void ServiceServer::answer(Offer& offer, const Offer::Request& request, const ServiceAnswer& answer) {
  const ReplyHeader header{request.client, request.call, answer.done, answer.reason};
  std::vector<std::byte> message(answer.done ? msgs::byteSize(*offer.reply) : 0);
  if (message.size() > kMaximumMessage) {
    this->answer(offer, request, ServiceAnswer::refused("the reply is too large to send"));
    return;
  }
  if (answer.done) msgs::writeBytes(*offer.reply, message);
  if (request.client == kOwn) {
    answerOwn_(offer.queue, request.call, header, message);
  } else if (offer.writer) {
    offer.writer->write(headerSize(header) + message.size(), [&](std::span<std::byte> place) {
      std::ranges::copy(message, writeHeader(header, place).begin());
    });
  }
}

void ServiceServer::complain(Offer& offer, const ParticipantId& sender, std::string_view what) {
  std::optional<std::uint64_t> unmentioned;
  {
    const RequestsLock lock(mutex_);
    unmentioned = offer.complaints.pass(std::chrono::steady_clock::now());
  }
  if (!unmentioned) return;
  const int pid = network_ != nullptr ? network_->directory().pidOf(sender) : 0;
  serverLog().warning("service '" + offer.name + "': a request from " +
                      (sender == kOwn ? "this process" : "process " + std::to_string(pid)) + " " + std::string(what) +
                      "; dropped" + (*unmentioned > 0 ? " (and " + std::to_string(*unmentioned) + " before it)" : ""));
}

}  // namespace pongsim::transport
