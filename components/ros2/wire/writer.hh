#pragma once

#include <fastdds/rtps/history/IPayloadPool.h>
#include <fastdds/rtps/history/WriterHistory.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/writer/WriterListener.h>
#include <fastdds/rtps/interfaces/IReaderDataFilter.hpp>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "ros2/wire/endpoint.hh"
#include "shared/threads/outbox.hh"

namespace pongsim::ros2 {

namespace rtps = eprosima::fastrtps::rtps;

/// A writer on a topic. A payload is written once, to the memory from which DDS sends it to all readers. Writing never
/// blocks: samples that a slow reader has not received are dropped according to its depth, and counted.
class Writer final : private rtps::WriterListener,
                     private shared::Outbox::Target,
                     private eprosima::fastdds::rtps::IReaderDataFilter {
 public:
  /// Called from a thread of DDS: whether a payload with this `related` is sent to the reader. Always says the same.
  using IsFor = std::function<bool(const Guid& reader, const SampleId& related)>;

  /// @param readersChanged Called from a DDS thread when a reader appears or disappears.
  /// @param isFor See `IsFor`; empty: everything is for all readers.
  /// @throws std::runtime_error if DDS fails.
  Writer(rtps::RTPSParticipant& participant, shared::Outbox& outbox, const Contract& contract,
         std::function<void()> readersChanged, IsFor isFor);
  /// Waits until DDS has everything that was written.
  ~Writer() override;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  const Guid& id() const { return id_; }
  /// @return Whether there are readers; cheap.
  bool hasReaders() const { return readerCount_.load(std::memory_order_relaxed) > 0; }
  std::size_t readers() const { return readerCount_; }
  bool hasReader(const Guid& reader) const;

  /// Sends a payload of `size` bytes, which `fill` writes in place.
  /// @param related For a reply: the request's; for a request: the reader of the reply.
  void write(std::size_t size, const Fill& fill, const SampleId& related = {});

  /// @return Number of payloads written so far.
  std::uint64_t sent() const { return sent_; }
  /// @return Number of payloads that some reader did not receive.
  std::uint64_t dropped() const { return dropped_ + droppedBeforeSending(); }

  /// Waits until all readers have acknowledged everything.
  /// @return Whether they have.
  bool waitForAcknowledgement(std::chrono::nanoseconds timeout);

 private:
  class Payloads;
  void onWriterMatched(rtps::RTPSWriter* writer, rtps::MatchingInfo& info) override;
  bool send(shared::Buffer* sample) override;
  const std::string& topic() const override { return topic_; }
  std::size_t mostWaiting() const override { return depth_; }
  bool is_relevant(const rtps::CacheChange_t& change, const rtps::GUID_t& reader) const override;
  void makeRoom();
  void dropOutlived();
  using rtps::WriterListener::onWriterMatched;

  shared::Outbox& outbox_;
  std::string topic_;
  bool keeps_;
  std::size_t depth_;
  std::optional<std::chrono::seconds> lifespan_;
  std::function<void()> readersChanged_;
  IsFor isFor_;
  std::shared_ptr<Payloads> payloads_;
  rtps::WriterHistory history_;
  std::atomic<std::uint64_t> sent_ = 0;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::atomic<std::size_t> readerCount_ = 0;
  mutable std::mutex readersMutex_;
  std::vector<Guid> readers_;
  Guid id_;
  rtps::RTPSWriter* writer_ = nullptr;
};

}  // namespace pongsim::ros2
