#include "transport/network/endpoint.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/ReaderAttributes.h>
#include <fastdds/rtps/attributes/WriterAttributes.h>
#include <fastdds/rtps/reader/RTPSReader.h>
#include <fastdds/rtps/writer/RTPSWriter.h>
#include <fastrtps/attributes/TopicAttributes.h>
#include <fastdds/dds/publisher/qos/WriterQos.hpp>
#include <fastdds/dds/subscriber/qos/ReaderQos.hpp>

#include <algorithm>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "transport/payload.hh"

namespace pongsim::transport {

namespace {

namespace dds = eprosima::fastdds::dds;
using eprosima::fastrtps::TopicAttributes;

// Limits of what a writer keeps for slow readers; a single message may be larger.
constexpr std::size_t kKeptMessages = 1000;
constexpr std::size_t kHistoryBytes = 32 << 20;

// Short, since the round trip is: loopback loses packets only when a receiver's buffer is full, and a resend is cheap.
const eprosima::fastrtps::Duration_t kHeartbeatPeriod{0, 5'000'000};
const eprosima::fastrtps::Duration_t kAtOnce{0, 0};

// Period of a reader's requests for missed samples until its writer first answers.
const eprosima::fastrtps::Duration_t kAskingPeriod{0, 5'000'000};

// Most writers whose last sample number a reader remembers.
constexpr std::size_t kMostSources = 10'000;

rtps::HistoryAttributes historyAttributes() {
  // starts small and grows to the size of the messages
  return {rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE, 256, 4, 0};
}

TopicAttributes topicAttributes(const Contract& contract) {
  TopicAttributes attributes(contract.topic.c_str(), contract.type.c_str(), rtps::NO_KEY);
  attributes.auto_fill_type_object = false;
  attributes.auto_fill_type_information = false;
  return attributes;
}

/// What access control asks an endpoint that is being made, when it has not been announced yet.
rtps::PropertyPolicy accessProperties(const Contract& contract) {
  rtps::PropertyPolicy policy;
  policy.properties().emplace_back("topic_name", contract.topic);
  if (!contract.partition.empty()) policy.properties().emplace_back("partitions", contract.partition);
  return policy;
}

template <class Qos>
Qos qosFor(const Contract& contract) {
  Qos qos;
  qos.m_reliability.kind = dds::RELIABLE_RELIABILITY_QOS;
  qos.m_durability.kind = contract.keepsLast ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
  if (!contract.partition.empty()) qos.m_partition.push_back(contract.partition.c_str());
  return qos;
}

rtps::DurabilityKind_t durability(const Contract& contract) {
  return contract.keepsLast ? rtps::TRANSIENT_LOCAL : rtps::VOLATILE;
}

}  // namespace

ParticipantId participantId(const rtps::GuidPrefix_t& prefix) {
  ParticipantId id{};
  std::copy_n(std::begin(prefix.value), id.size(), id.begin());
  return id;
}

Writer::Writer(rtps::RTPSParticipant& participant, shared::Outbox& outbox, const Contract& contract,
               std::function<void()> readersChanged)
    : own_(participantId(participant.getGuid().guidPrefix)),
      outbox_(outbox),
      topic_(contract.topic),
      keepsLast_(contract.keepsLast),
      content_(contract.content),
      readersChanged_(std::move(readersChanged)),
      samples_(std::make_shared<SentSamples>(outbox)),
      history_(historyAttributes()) {
  rtps::WriterAttributes attributes;
  attributes.endpoint.topicKind = rtps::NO_KEY;
  attributes.endpoint.reliabilityKind = rtps::RELIABLE;
  attributes.endpoint.durabilityKind = durability(contract);
  attributes.endpoint.properties = accessProperties(contract);
  // sends on the outbox's thread
  attributes.mode = rtps::SYNCHRONOUS_WRITER;
  attributes.times.initialHeartbeatDelay = kAtOnce;
  attributes.times.heartbeatPeriod = kHeartbeatPeriod;
  attributes.times.nackResponseDelay = kAtOnce;
  attributes.times.nackSupressionDuration = kAtOnce;
  writer_ = rtps::RTPSDomain::createRTPSWriter(&participant, attributes, samples_, &history_, this);
  if (writer_ == nullptr) throw std::runtime_error("DDS can't create a writer for topic '" + contract.topic + "'");
  if (!participant.registerWriter(writer_, topicAttributes(contract), qosFor<dds::WriterQos>(contract))) {
    rtps::RTPSDomain::removeRTPSWriter(writer_);
    throw std::runtime_error("DDS can't announce the writer for topic '" + contract.topic + "'");
  }
}

Writer::~Writer() {
  outbox_.flush(*this);
  removeAll();
  rtps::RTPSDomain::removeRTPSWriter(writer_);
}

bool Writer::hasReaderOf(const ParticipantId& participant) const {
  const Lock lock(readersMutex_);
  return std::ranges::find(readersOf_, participant) != readersOf_.end();
}

std::optional<ParticipantId> Writer::newestReader() const {
  const Lock lock(readersMutex_);
  return readersOf_.empty() ? std::nullopt : std::optional(readersOf_.back());
}

void Writer::write(std::size_t messageSize, const std::function<void(std::span<std::byte>)>& fill, Keeping keeping) {
  // before the message is in the outbox: whoever matches from now on has it sent again, whoever did before gets it
  if (keeping == Keeping::kKept) keeping_ = true;
  outbox_.add(*this, payloadSize(messageSize),
              [&](std::span<std::byte> sample) { fill(framePayload(sample, messageSize, keeping)); });
}

/// Sends a sample, or the one that is kept where it is empty.
bool Writer::send(Buffer* sample) {
  if (sample->bytes.empty()) return sendKeptAgain();
  if (keepingOf(sample->bytes) == Keeping::kKept) {
    kept_.assign(sample->bytes.begin(), sample->bytes.end());
    markAsAgain(kept_);
  }
  return sendToAll(sample);
}

/// @return False, for the empty sample that asked for it is not kept.
bool Writer::sendKeptAgain() {
  if (kept_.empty()) return false;
  Buffer* sample = outbox_.take(kept_.size());
  std::ranges::copy(kept_, sample->bytes.begin());
  if (!sendToAll(sample)) outbox_.giveBack(sample);
  return false;
}

bool Writer::sendToAll(Buffer* sample) {
  const std::size_t size = sample->bytes.size();
  const std::lock_guard lock(writer_->getMutex());
  removeDelivered();
  makeRoomFor(size);
  samples_->setNext(sample);
  rtps::CacheChange_t* change = writer_->new_change([size] { return static_cast<std::uint32_t>(size); }, rtps::ALIVE);
  samples_->setNext(nullptr);
  if (change == nullptr) return false;
  change->serializedPayload.encapsulation = CDR_LE;
  change->serializedPayload.length = static_cast<std::uint32_t>(size);
  keptBytes_ += size;
  history_.add_change(change);
  return true;
}

// Not in the callback that all readers have a sample: Fast DDS 2.9 may call it while it removes a reader, with locks
// held that the sending thread locks in the opposite order (Fast-DDS pull request 3468).
void Writer::removeDelivered() {
  if (keepsLast_) return;
  rtps::CacheChange_t* oldest = nullptr;
  while (history_.get_min_change(&oldest) && writer_->is_acked_by_all(oldest)) removeOldest(*oldest);
}

void Writer::makeRoomFor(std::size_t bytes) {
  const std::size_t limit = keepsLast_ ? 1 : kKeptMessages;
  rtps::CacheChange_t* oldest = nullptr;
  while (history_.getHistorySize() >= limit || (keptBytes_ + bytes > kHistoryBytes && history_.getHistorySize() > 1)) {
    if (!history_.get_min_change(&oldest)) return;
    if (!keepsLast_ && !writer_->is_acked_by_all(oldest)) ++dropped_;
    removeOldest(*oldest);
  }
}

void Writer::removeOldest(const rtps::CacheChange_t& oldest) {
  keptBytes_ -= oldest.serializedPayload.length;
  history_.remove_min_change();
}

// Before the writer is deleted: Fast DDS 2.9 releases its samples before it stops the heartbeats, and a heartbeat in
// between loops forever over a history whose samples have lost their numbers.
void Writer::removeAll() {
  const std::lock_guard lock(writer_->getMutex());
  history_.remove_all_changes();
}

bool Writer::waitForAcknowledgement(std::chrono::nanoseconds timeout) {
  outbox_.flush(*this);
  const auto bounded = std::min<std::chrono::nanoseconds>(timeout, std::chrono::hours(24 * 365));
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(bounded);
  const std::chrono::nanoseconds rest = bounded - seconds;
  return writer_->wait_for_all_acked(eprosima::fastrtps::Duration_t(static_cast<std::int32_t>(seconds.count()),
                                                                    static_cast<std::uint32_t>(rest.count())));
}

void Writer::onWriterMatched(rtps::RTPSWriter*, rtps::MatchingInfo& info) {
  const ParticipantId participant = participantId(info.remoteEndpointGuid.guidPrefix);
  if (participant == own_) return;
  {
    const Lock lock(readersMutex_);
    if (info.status == rtps::MATCHED_MATCHING) {
      readersOf_.push_back(participant);
      ++readersSoFar_;
    } else if (const auto gone = std::ranges::find(readersOf_, participant); gone != readersOf_.end()) {
      readersOf_.erase(gone);
    }
    readers_ = static_cast<int>(readersOf_.size());
  }
  // through the outbox, to be sent after earlier messages
  if (info.status == rtps::MATCHED_MATCHING && keeping_) outbox_.add(*this, 0, [](std::span<std::byte>) {});
  if (readersChanged_) readersChanged_();
}

Reader::Reader(rtps::RTPSParticipant& participant, const Contract& contract, Received received, WriterGone writerGone)
    : own_(participantId(participant.getGuid().guidPrefix)),
      received_(std::move(received)),
      writerGone_(std::move(writerGone)),
      history_(historyAttributes()) {
  rtps::ReaderAttributes attributes;
  attributes.endpoint.topicKind = rtps::NO_KEY;
  attributes.endpoint.reliabilityKind = rtps::RELIABLE;
  attributes.endpoint.durabilityKind = durability(contract);
  attributes.endpoint.properties = accessProperties(contract);
  attributes.times.initialAcknackDelay = kAskingPeriod;
  attributes.times.heartbeatResponseDelay = kAtOnce;
  reader_ = rtps::RTPSDomain::createRTPSReader(&participant, attributes, samples_, &history_, this);
  if (reader_ == nullptr) throw std::runtime_error("DDS can't create a reader for topic '" + contract.topic + "'");
  if (!participant.registerReader(reader_, topicAttributes(contract), qosFor<dds::ReaderQos>(contract))) {
    rtps::RTPSDomain::removeRTPSReader(reader_);
    throw std::runtime_error("DDS can't announce the reader for topic '" + contract.topic + "'");
  }
}

Reader::~Reader() { rtps::RTPSDomain::removeRTPSReader(reader_); }

void Reader::onNewCacheChangeAdded(rtps::RTPSReader* reader, const rtps::CacheChange_t* change) {
  const ParticipantId sender = participantId(change->writerGUID.guidPrefix);
  if (change->kind == rtps::ALIVE && sender != own_) {
    Buffer* sample = samples_->bufferOf(*change);
    if (sample != nullptr && isNews(*change, *sample)) received_(sender, *sample);
  }
  reader->getHistory()->remove_change(const_cast<rtps::CacheChange_t*>(change));
}

/// Counts what was lost before it.
/// @return False where it is a kept one that came already.
bool Reader::isNews(const rtps::CacheChange_t& change, const Buffer& sample) {
  const std::uint64_t number = change.sequenceNumber.to64long();
  const Lock lock(sourcesMutex_);
  if (sources_.size() >= kMostSources) sources_.clear();
  const auto [entry, isNew] = sources_.try_emplace(change.writerGUID, Source{number, true});
  if (isNew) return true;
  Source& source = entry->second;
  // a gap is a loss: writers drop the oldest first, and DDS delivers in order
  if (number > source.last + 1) lost_ += number - source.last - 1;
  source.last = number;
  return !std::exchange(source.isCurrent, true) || keepingOf(sample.bytes) != Keeping::kAgain;
}

void Reader::onReaderMatched(rtps::RTPSReader*, rtps::MatchingInfo& info) {
  if (info.status == rtps::MATCHED_MATCHING) return;
  {
    const Lock lock(sourcesMutex_);
    const auto source = sources_.find(info.remoteEndpointGuid);
    if (source != sources_.end()) source->second.isCurrent = false;
  }
  const ParticipantId participant = participantId(info.remoteEndpointGuid.guidPrefix);
  if (participant != own_ && writerGone_) writerGone_(participant);
}

}  // namespace pongsim::transport
