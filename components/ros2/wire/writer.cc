#include "ros2/wire/writer.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/WriterAttributes.h>
#include <fastdds/rtps/writer/RTPSWriter.h>
#include <fastdds/dds/publisher/qos/WriterQos.hpp>

#include <algorithm>
#include <cstring>
#include <span>
#include <stdexcept>
#include <utility>

#include "ros2/wire/fast_dds.hh"

namespace pongsim::ros2 {

/// Keeps a writer's payloads in the outbox's buffers. Guarded by the writer's lock.
class Writer::Payloads final : public rtps::IPayloadPool {
 public:
  explicit Payloads(shared::Outbox& outbox) : outbox_(outbox) {}

  /// Sets the buffer of the next change, which is returned to the outbox with the change.
  void setNext(shared::Buffer* buffer) { next_ = buffer; }

  bool get_payload(std::uint32_t, rtps::CacheChange_t& change) override {
    if (next_ == nullptr) return false;
    change.serializedPayload.data = reinterpret_cast<rtps::octet*>(next_->bytes.data());
    change.serializedPayload.max_size = static_cast<std::uint32_t>(next_->bytes.size());
    change.serializedPayload.pos = 0;
    change.payload_owner(this);
    kept_.push_back(std::exchange(next_, nullptr));
    return true;
  }
  /// Only readers share payloads.
  bool get_payload(rtps::SerializedPayload_t&, IPayloadPool*&, rtps::CacheChange_t&) override { return false; }

  bool release_payload(rtps::CacheChange_t& change) override {
    const auto* data = reinterpret_cast<const std::byte*>(change.serializedPayload.data);
    const auto found = std::ranges::find(kept_, data, [](const shared::Buffer* each) { return each->bytes.data(); });
    if (found == kept_.end()) return false;
    outbox_.giveBack(*found);
    kept_.erase(found);
    // the library would free it
    change.serializedPayload.data = nullptr;
    change.serializedPayload.length = 0;
    change.serializedPayload.max_size = 0;
    change.payload_owner(nullptr);
    return true;
  }

 private:
  shared::Outbox& outbox_;
  shared::Buffer* next_ = nullptr;
  std::deque<shared::Buffer*> kept_;
};

namespace {

rtps::HistoryAttributes writerHistory() { return {rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE, 256, 4, 0}; }

}  // namespace

Writer::Writer(rtps::RTPSParticipant& participant, shared::Outbox& outbox, const Contract& contract,
               std::function<void()> readersChanged, IsFor isFor)
    : outbox_(outbox),
      topic_(contract.topic),
      keeps_(contract.qos.isTransientLocal),
      depth_(std::max<std::size_t>(contract.qos.depth, 1)),
      lifespan_(contract.qos.lifespan),
      readersChanged_(std::move(readersChanged)),
      isFor_(std::move(isFor)),
      payloads_(std::make_shared<Payloads>(outbox)),
      history_(writerHistory()) {
  rtps::WriterAttributes attributes;
  attributes.endpoint.topicKind = rtps::NO_KEY;
  attributes.endpoint.reliabilityKind = reliabilityOf(contract);
  attributes.endpoint.durabilityKind = durabilityOf(contract);
  // for access control, before it is announced
  attributes.endpoint.properties.properties().emplace_back("topic_name", contract.topic);
  // it sends on the outbox's thread
  attributes.mode = rtps::SYNCHRONOUS_WRITER;
  attributes.times.initialHeartbeatDelay = kAtOnce;
  attributes.times.heartbeatPeriod = kHeartbeatPeriod;
  attributes.times.nackResponseDelay = kAtOnce;
  attributes.times.nackSupressionDuration = kAtOnce;
  writer_ = rtps::RTPSDomain::createRTPSWriter(&participant, attributes, payloads_, &history_, this);
  if (writer_ == nullptr) throw std::runtime_error("DDS can't create a writer for '" + contract.topic + "'");
  id_ = guidOf(writer_->getGuid());
  if (isFor_) writer_->reader_data_filter(this);
  namespace dds = eprosima::fastdds::dds;
  if (!participant.registerWriter(writer_, topicAttributesOf(contract), endpointQosOf<dds::WriterQos>(contract))) {
    rtps::RTPSDomain::removeRTPSWriter(writer_);
    throw std::runtime_error("DDS can't announce the writer of '" + contract.topic + "'");
  }
}

Writer::~Writer() {
  outbox_.flush(*this);
  {
    // Before the writer is destroyed: Fast DDS 2.9 releases the samples before it stops the heartbeats, and a heartbeat
    // in between searches forever for the end of a history whose samples have lost their numbers.
    const std::lock_guard lock(writer_->getMutex());
    history_.remove_all_changes();
  }
  rtps::RTPSDomain::removeRTPSWriter(writer_);
}

bool Writer::hasReader(const Guid& reader) const {
  const std::lock_guard lock(readersMutex_);
  return std::ranges::find(readers_, reader) != readers_.end();
}

void Writer::write(std::size_t size, const Fill& fill, const SampleId& related) {
  ++sent_;
  // what it is related to stands before the payload
  outbox_.add(*this, sizeof related + size, [&](std::span<std::byte> place) {
    std::memcpy(place.data(), &related, sizeof related);
    fill(place.subspan(sizeof related));
  });
}

bool Writer::send(shared::Buffer* sample) {
  SampleId related;
  std::memcpy(&related, sample->bytes.data(), sizeof related);
  sample->bytes = sample->bytes.subspan(sizeof related);
  const std::lock_guard lock(writer_->getMutex());
  makeRoom();
  const auto size = static_cast<std::uint32_t>(sample->bytes.size());
  payloads_->setNext(sample);
  rtps::CacheChange_t* change = writer_->new_change([size] { return size; }, rtps::ALIVE);
  payloads_->setNext(nullptr);
  if (change == nullptr) return false;
  change->serializedPayload.encapsulation = CDR_LE;
  change->serializedPayload.length = size;
  rtps::WriteParams params;
  if (related != SampleId{}) {
    params.related_sample_identity().writer_guid(guidOf(related.writer));
    params.related_sample_identity().sequence_number(
        {static_cast<std::int32_t>(related.number >> 32), static_cast<std::uint32_t>(related.number)});
  }
  history_.add_change(change, params);
  return true;
}

bool Writer::is_relevant(const rtps::CacheChange_t& change, const rtps::GUID_t& reader) const {
  return isFor_(guidOf(reader), sampleIdOf(change.write_params.related_sample_identity()));
}

// Not in DDS's callback for acknowledged samples: in Fast DDS 2.9 it may run while a reader is being removed, with
// locks that the sending thread takes in the opposite order (Fast-DDS pull request 3468).
void Writer::makeRoom() {
  rtps::CacheChange_t* oldest = nullptr;
  while (history_.get_min_change(&oldest)) {
    const bool isDelivered = writer_->is_acked_by_all(oldest);
    const bool isFull = history_.getHistorySize() >= depth_;
    if (!isFull && (keeps_ || !isDelivered)) return;
    if (!keeps_ && !isDelivered) ++dropped_;
    history_.remove_min_change();
  }
}

/// Called before a late reader requests samples: DDS announces expired ones to it, and then reports them as gone.
void Writer::dropOutlived() {
  const std::lock_guard lock(writer_->getMutex());
  rtps::Time_t now;
  rtps::Time_t::now(now);
  const rtps::Time_t lifespan(static_cast<std::int32_t>(lifespan_->count()), 0u);
  rtps::CacheChange_t* oldest = nullptr;
  while (history_.get_min_change(&oldest) && oldest->sourceTimestamp + lifespan < now) history_.remove_min_change();
}

bool Writer::waitForAcknowledgement(std::chrono::nanoseconds timeout) {
  outbox_.flush(*this);
  const auto bounded = std::min<std::chrono::nanoseconds>(timeout, std::chrono::hours(24));
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(bounded);
  return writer_->wait_for_all_acked(
      {static_cast<std::int32_t>(seconds.count()), static_cast<std::uint32_t>((bounded - seconds).count())});
}

void Writer::onWriterMatched(rtps::RTPSWriter*, rtps::MatchingInfo& info) {
  const Guid reader = guidOf(info.remoteEndpointGuid);
  if (reader.isOfSameParticipant(id_)) return;
  if (lifespan_ && info.status == rtps::MATCHED_MATCHING) dropOutlived();
  {
    const std::lock_guard lock(readersMutex_);
    std::erase(readers_, reader);
    if (info.status == rtps::MATCHED_MATCHING) readers_.push_back(reader);
    readerCount_ = readers_.size();
  }
  if (readersChanged_) readersChanged_();
}

}  // namespace pongsim::ros2
