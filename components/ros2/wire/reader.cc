#include "ros2/wire/reader.hh"

#include <fastdds/rtps/RTPSDomain.h>
#include <fastdds/rtps/attributes/ReaderAttributes.h>
#include <fastdds/rtps/reader/RTPSReader.h>
#include <fastdds/dds/subscriber/qos/ReaderQos.hpp>

#include <stdexcept>
#include <utility>

#include "ros2/wire/fast_dds.hh"

namespace pongsim::ros2 {

namespace {

rtps::HistoryAttributes readerHistory() { return {rtps::PREALLOCATED_WITH_REALLOC_MEMORY_MODE, 256, 4, 0}; }

}  // namespace

Reader::Reader(rtps::RTPSParticipant& participant, const Contract& contract, Received received)
    : received_(std::move(received)), history_(readerHistory()), id_(guidOf(participant.getGuid())) {
  rtps::ReaderAttributes attributes;
  attributes.endpoint.topicKind = rtps::NO_KEY;
  attributes.endpoint.reliabilityKind = reliabilityOf(contract);
  attributes.endpoint.durabilityKind = durabilityOf(contract);
  // for access control, before it is announced
  attributes.endpoint.properties.properties().emplace_back("topic_name", contract.topic);
  attributes.times.initialAcknackDelay = kHeartbeatPeriod;
  attributes.times.heartbeatResponseDelay = kAtOnce;
  reader_ = rtps::RTPSDomain::createRTPSReader(&participant, attributes, &history_, this);
  if (reader_ == nullptr) throw std::runtime_error("DDS can't create a reader for '" + contract.topic + "'");
  id_ = guidOf(reader_->getGuid());
  namespace dds = eprosima::fastdds::dds;
  if (!participant.registerReader(reader_, topicAttributesOf(contract), endpointQosOf<dds::ReaderQos>(contract))) {
    rtps::RTPSDomain::removeRTPSReader(reader_);
    throw std::runtime_error("DDS can't announce the reader of '" + contract.topic + "'");
  }
}

Reader::~Reader() { rtps::RTPSDomain::removeRTPSReader(reader_); }

void Reader::onNewCacheChangeAdded(rtps::RTPSReader* reader, const rtps::CacheChange_t* change) {
  const SampleId id{guidOf(change->writerGUID), static_cast<std::int64_t>(change->sequenceNumber.to64long())};
  if (change->kind == rtps::ALIVE && !id.writer.isOfSameParticipant(id_)) {
    ++receivedCount_;
    // Fast DDS stores the sender's related identity where outgoing samples have their own
    const SampleId related = sampleIdOf(change->write_params.sample_identity());
    const auto payload = std::as_bytes(std::span(change->serializedPayload.data, change->serializedPayload.length));
    received_({payload, id, related});
  }
  reader->getHistory()->remove_change(const_cast<rtps::CacheChange_t*>(change));
}

void Reader::onReaderMatched(rtps::RTPSReader*, rtps::MatchingInfo& info) {
  if (guidOf(info.remoteEndpointGuid).isOfSameParticipant(id_)) return;
  info.status == rtps::MATCHED_MATCHING ? ++writerCount_ : --writerCount_;
}

}  // namespace pongsim::ros2
