#include "ros2/node/service.hh"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "ros2/node/cyclone_header.hh"

namespace pongsim::ros2::detail {

namespace {

// How long a reply waits for the discovery of its reader.
constexpr std::chrono::seconds kDiscoveryTimeout{5};
constexpr std::size_t kMostWaiting = 1000;
// How long the end of a service waits until its last replies have arrived.
constexpr std::chrono::seconds kAcknowledgementTimeout{1};

struct WireEnds {
  Contract request;
  Contract reply;
};

WireEnds wireEnds(const RosNode& node, const std::string& service, const ServerEnds::Types& types) {
  const std::string name = node.resolve(service);
  if (const auto error = rosNameError(name)) throw std::invalid_argument("service '" + name + "' " + *error);
  return {{requestOnWire(name), ddsTypeName(types.request.name), types.request.hash, kDefaultQos},
          {replyOnWire(name), ddsTypeName(types.response.name), types.response.hash, kDefaultQos}};
}

/// @return Whether an endpoint with this hash, which is empty where nodes announce none, has the older version of a
/// type.
bool isOlder(const std::string& hash, const std::string& older, const std::string& newer, const RosNode& node) {
  if (hash == older) return true;
  return hash == newer ? false : node.options().prefersOlder;
}

bool isReader(const Guid& id) {
  // the entity kind distinguishes writers (0x02, 0x03) from readers (0x04, 0x07)
  constexpr std::uint8_t kKind = 0x3f, kWriter = 0x02, kWriterNoKey = 0x03;
  const std::uint8_t kind = id.bytes[15] & kKind;
  return kind != kWriter && kind != kWriterNoKey;
}

}  // namespace

ServerEnds::ServerEnds(RosNode& node, const std::string& service, const Types& types, Reader::Received received)
    : node_(node), service_(node.resolve(service)), types_(types) {
  Types announced = types;
  if (node.options().prefersOlder) {
    announced.request = types.olderRequest;
    announced.response = types.olderResponse;
  }
  for (const TypeInfo& each : {announced.request, announced.response}) node_.use(each);
  const WireEnds ends = wireEnds(node, service, announced);
  replyTopic_ = ends.reply.topic;
  writer_ = node.participant().makeWriter(
      ends.reply, [this] { readersChanged(); },
      [this](const Guid& reader, const SampleId& caller) { return isFor(reader, caller); });
  reader_ = node.participant().makeReader(ends.request, std::move(received));
  node_.addWriter(writer_->id());
  node_.addReader(reader_->id());
}

ServerEnds::~ServerEnds() {
  node_.removeReader(reader_->id());
  reader_.reset();
  {
    std::unique_lock lock(mutex_);
    // waits for undiscovered readers: after the reply to a request to quit, the process ends
    if (!waiting_.empty()) sent_.wait_until(lock, waiting_.back().until, [this] { return waiting_.empty(); });
    // `readersChanged` is still called while the writer is destroyed: without replies it does not use the writer
    waiting_.clear();
  }
  writer_->waitForAcknowledgement(kAcknowledgementTimeout);
  node_.removeWriter(writer_->id());
  writer_.reset();
}

void ServerEnds::reply(const Caller& caller, Reply reply) {
  const std::lock_guard lock(mutex_);
  Waiting waiting{caller, std::move(reply), std::chrono::steady_clock::now() + kDiscoveryTimeout};
  if (send(waiting)) return;
  waiting_.push_back(std::move(waiting));
  if (waiting_.size() > kMostWaiting) waiting_.pop_front();
}

/// Clients that do not name their reader have it in the participant of the request's writer; those of rmw_cyclonedds,
/// of which one participant has many, give both the same id.
bool ServerEnds::isFor(const Guid& reader, const SampleId& caller) const {
  if (isReader(caller.writer)) return reader == caller.writer;
  if (!reader.isOfSameParticipant(caller.writer)) return false;
  const Graph& graph = node_.participant().graph();
  const auto writer = graph.find(caller.writer);
  const auto found = graph.find(reader);
  return (writer ? writer->contract.cycloneId : "") == (found ? found->contract.cycloneId : "");
}

/// @return Whether the caller's reader has been discovered.
bool ServerEnds::send(const Waiting& waiting) {
  const SampleId& caller = waiting.caller.id;
  for (const Graph::Endpoint& each : node_.participant().graph().endpointsOn(replyTopic_, Graph::Role::kReader)) {
    if (!isFor(each.id, caller) || !writer_->hasReader(each.id)) continue;
    std::vector<std::byte> payload = payloadFor(each.contract.typeHash, waiting.reply);
    if (!waiting.caller.header.empty()) payload = cyclonePayload(waiting.caller.header, payload);
    writer_->write(
        payload.size(), [&payload](std::span<std::byte> place) { std::ranges::copy(payload, place.begin()); }, caller);
    return true;
  }
  return false;
}

/// @param hash That of the client's response, or empty.
const std::vector<std::byte>& ServerEnds::payloadFor(const std::string& hash, const Reply& reply) const {
  if (!reply.newer.empty() && hash == types_.newerResponse.hash) return reply.newer;
  if (!reply.older.empty() && isOlder(hash, types_.olderResponse.hash, types_.response.hash, node_)) return reply.older;
  return reply.payload;
}

void ServerEnds::readersChanged() {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  std::erase_if(waiting_, [&](const Waiting& each) { return each.until < now || send(each); });
  if (waiting_.empty()) sent_.notify_all();
}

std::unique_ptr<RosServer> serve(RosNode& node, const std::string& service, const ServerEnds::Types& types,
                                 ReadRequest read) {
  const auto ends = std::make_shared<std::weak_ptr<ServerEnds>>();
  auto owned = std::make_shared<ServerEnds>(
      node, service, types, [&node, service, types, ends, read = std::move(read)](const Sample& sample) {
        const auto writer = node.participant().graph().find(sample.id.writer);
        Caller caller{{sample.related.writer == Guid{} ? sample.id.writer : sample.related.writer, sample.id.number}};
        std::span<const std::byte> payload = sample.payload;
        std::optional<CyclonePayload> split;
        if (writer && !writer->contract.cycloneId.empty()) {
          split = splitCyclonePayload(payload);
          if (!split) return node.complainOf(service, "it is cut off");
          caller.header = split->header;
          payload = split->message;
        }
        std::string error;
        const std::string hash = writer ? writer->contract.typeHash : "";
        Handling handling = read(payload, isOlder(hash, types.olderRequest.hash, types.request.hash, node), error);
        if (!handling) return node.complainOf(service, error);
        node.mailbox().post([ends, caller = std::move(caller), handling = std::move(handling)] {
          if (ends->lock()) handling(*ends, caller);
        });
      });
  *ends = owned;
  return std::make_unique<RosServer>(std::move(owned));
}

ClientEnds::ClientEnds(RosNode& node, const std::string& service, const ServerEnds::Types& types) : node_(node) {
  const WireEnds ends = wireEnds(node, service, types);
  requestTopic_ = ends.request.topic;
  reader_ = node.participant().makeReader(ends.reply, [this](const Sample& sample) { received(sample); });
  writer_ = node.participant().makeWriter(ends.request, [this] { changed_.notify_all(); });
  node_.addReader(reader_->id());
  node_.addWriter(writer_->id());
}

ClientEnds::~ClientEnds() {
  node_.removeReader(reader_->id());
  node_.removeWriter(writer_->id());
  {
    // `received` is still called while the reader is destroyed: with 0 it does not use the reader
    const std::lock_guard lock(mutex_);
    awaited_ = 0;
  }
  writer_.reset();
  reader_.reset();
}

void ClientEnds::received(const Sample& sample) {
  const std::lock_guard lock(mutex_);
  // 0: also before the constructor has set `reader_`; responses are for other clients then
  if (awaited_ == 0) return;
  if (!awaitsHeader_) {
    if (sample.related != SampleId{reader_->id(), awaited_}) return;
    answer_.emplace(sample.payload.begin(), sample.payload.end());
  } else {
    auto split = splitCyclonePayload(sample.payload);
    if (!split || split->header != cycloneHeader()) return;
    answer_ = std::move(split->message);
  }
  changed_.notify_all();
}

bool ClientEnds::servesCyclone() const {
  const auto servers = node_.participant().graph().endpointsOn(requestTopic_, Graph::Role::kReader);
  return std::ranges::any_of(servers, [&](const Graph::Endpoint& each) {
    return !each.contract.cycloneId.empty() && writer_->hasReader(each.id);
  });
}

/// @return That of the awaited reply.
std::vector<std::byte> ClientEnds::cycloneHeader() const {
  std::vector<std::byte> header(kCycloneHeader);
  // an id that no other client has: the end of the writer's prefix, and its entity
  std::memcpy(header.data(), writer_->id().bytes.data() + 8, 8);
  std::memcpy(header.data() + 8, &awaited_, sizeof awaited_);
  return header;
}

std::optional<std::vector<std::byte>> ClientEnds::call(const std::vector<std::byte>& request,
                                                       std::chrono::nanoseconds timeout) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  std::unique_lock lock(mutex_);
  // polls as well: a notification may come between the check and the wait, as it is sent without the lock
  while (!writer_->hasReaders() || reader_->writers() == 0) {
    if (std::chrono::steady_clock::now() >= deadline) return std::nullopt;
    changed_.wait_for(lock, std::chrono::milliseconds(10));
  }
  // DDS numbers a writer's samples from 1 on
  awaited_ = nextNumber_++;
  answer_.reset();
  awaitsHeader_ = servesCyclone();
  const std::vector<std::byte> payload = awaitsHeader_ ? cyclonePayload(cycloneHeader(), request) : request;
  writer_->write(payload.size(), [&payload](std::span<std::byte> place) { std::ranges::copy(payload, place.begin()); },
                 {reader_->id(), awaited_});
  if (!changed_.wait_until(lock, deadline, [this] { return answer_.has_value(); })) return std::nullopt;
  return std::move(answer_);
}

}  // namespace pongsim::ros2::detail
