#include "ros2/node/service.hh"

#include <algorithm>
#include <stdexcept>

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

}  // namespace

ServerEnds::ServerEnds(RosNode& node, const std::string& service, const Types& types, Reader::Received received)
    : node_(node), service_(node.resolve(service)) {
  const WireEnds ends = wireEnds(node, service, types);
  writer_ = node.participant().makeWriter(ends.reply, [this] { readersChanged(); });
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

SampleId ServerEnds::callerOf(const Sample& request) {
  // rmw_fastrtps gives the reader of the reply; other clients are identified by their writer
  return {request.related.writer == Guid{} ? request.id.writer : request.related.writer, request.id.number};
}

void ServerEnds::reply(const SampleId& caller, std::vector<std::byte> payload) {
  const std::lock_guard lock(mutex_);
  Waiting reply{caller, std::move(payload), std::chrono::steady_clock::now() + kDiscoveryTimeout};
  if (send(reply)) return;
  waiting_.push_back(std::move(reply));
  if (waiting_.size() > kMostWaiting) waiting_.pop_front();
}

/// @return Whether the caller's reader has been discovered.
bool ServerEnds::send(const Waiting& reply) {
  // the entity kind distinguishes writers (0x02, 0x03) from readers (0x04, 0x07)
  constexpr std::uint8_t kKind = 0x3f, kWriter = 0x02, kWriterNoKey = 0x03;
  const std::uint8_t kind = reply.caller.writer.bytes[15] & kKind;
  const bool namesReader = kind != kWriter && kind != kWriterNoKey;
  if (namesReader ? !writer_->hasReader(reply.caller.writer) : !writer_->hasReaders()) return false;
  const auto& payload = reply.payload;
  writer_->write(
      payload.size(), [&payload](std::span<std::byte> place) { std::ranges::copy(payload, place.begin()); },
      reply.caller);
  return true;
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
      node, service, types, [&node, service, ends, read = std::move(read)](const Sample& sample) {
        std::string error;
        Handling handling = read(sample.payload, error);
        if (!handling) {
          node.complainOf(service, error);
          return;
        }
        node.mailbox().post([ends, caller = ServerEnds::callerOf(sample), handling = std::move(handling)] {
          if (ends->lock()) handling(*ends, caller);
        });
      });
  *ends = owned;
  return std::make_unique<RosServer>(std::move(owned));
}

ClientEnds::ClientEnds(RosNode& node, const std::string& service, const ServerEnds::Types& types) : node_(node) {
  const WireEnds ends = wireEnds(node, service, types);
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
  if (awaited_ == 0 || sample.related != SampleId{reader_->id(), awaited_}) return;
  answer_.emplace(sample.payload.begin(), sample.payload.end());
  changed_.notify_all();
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
  writer_->write(request.size(), [&request](std::span<std::byte> place) { std::ranges::copy(request, place.begin()); },
                 {reader_->id(), awaited_});
  if (!changed_.wait_until(lock, deadline, [this] { return answer_.has_value(); })) return std::nullopt;
  return std::move(answer_);
}

}  // namespace pongsim::ros2::detail
