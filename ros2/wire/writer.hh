#pragma once

#include <fastdds/rtps/history/IPayloadPool.h>
#include <fastdds/rtps/history/WriterHistory.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/writer/WriterListener.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "ros2/wire/endpoint.hh"
#include "ros2/wire/outbox.hh"

namespace pongsim::ros2 {

namespace rtps = eprosima::fastrtps::rtps;

/// A topic's way out. A payload is written once, to the place from which DDS sends it to all readers. Whoever writes
/// never waits: what a slow reader has not got is dropped as its depth says, and counted.
class Writer final : private rtps::WriterListener, private Outbox::Target {
 public:
  /// @param readersChanged Called from a DDS thread when a reader comes or goes.
  /// @param tellsHash Whether the type's hash is told.
  /// @throws std::runtime_error where DDS refuses.
  Writer(rtps::RTPSParticipant& participant, Outbox& outbox, const Contract& contract, bool tellsHash,
         std::function<void()> readersChanged);
  /// Waits until DDS has all that was written.
  ~Writer() override;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  const Guid& id() const { return id_; }
  /// @return Whether anybody reads; cheap.
  bool hasReaders() const { return readerCount_.load(std::memory_order_relaxed) > 0; }
  std::size_t readers() const { return readerCount_; }
  bool hasReader(const Guid& reader) const;

  /// Sends a payload of so many bytes, which `fill` writes to its place.
  /// @param related Of a reply: the request's; of a request: the reader of the reply.
  void write(std::size_t size, const Fill& fill, const SampleId& related = {});

  /// @return Payloads written so far.
  std::uint64_t sent() const { return sent_; }
  /// @return Payloads that some reader did not get.
  std::uint64_t dropped() const { return dropped_ + droppedBeforeSending(); }

  /// Waits until all readers have acknowledged everything.
  /// @return Whether they have.
  bool waitForAcknowledgement(std::chrono::nanoseconds timeout);

 private:
  class Payloads;
  void onWriterMatched(rtps::RTPSWriter* writer, rtps::MatchingInfo& info) override;
  void send(Buffer* buffer, const SampleId& related) override;
  std::size_t mostWaiting() const override { return depth_; }
  void makeRoom();
  void dropOutlived();
  using rtps::WriterListener::onWriterMatched;

  Outbox& outbox_;
  bool keeps_;
  std::size_t depth_;
  std::optional<std::chrono::seconds> lifespan_;
  std::function<void()> readersChanged_;
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
