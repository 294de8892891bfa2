#pragma once

#include <fastdds/rtps/history/ReaderHistory.h>
#include <fastdds/rtps/history/WriterHistory.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/reader/ReaderListener.h>
#include <fastdds/rtps/writer/WriterListener.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transport/locks.hh"
#include "shared/threads/outbox.hh"
#include "transport/network/sample_pool.hh"
#include "transport/payload.hh"

namespace pongsim::transport {

namespace rtps = eprosima::fastrtps::rtps;

/// What a topic's samples are.
enum class Content {
  kMessages,
  /// Requests and replies of a service.
  kCalls
};

/// Properties of an endpoint.
struct Contract {
  std::string topic;
  std::string type;
  /// DDS partition; empty: none.
  std::string partition;
  /// Whether later readers get the last message, and only that is kept.
  bool keepsLast = false;
  Content content = Content::kMessages;
};

ParticipantId participantId(const rtps::GuidPrefix_t& prefix);

/// DDS writer of a topic. Reliable for readers that are fast enough; a slow one loses the oldest messages and blocks no
/// one.
class Writer : private rtps::WriterListener, private shared::Outbox::Target {
 public:
  /// @param outbox Passes the messages to DDS. Must outlive this.
  /// @param readersChanged Called on a DDS thread when a reader elsewhere is added or removed.
  /// @throws std::runtime_error if DDS refuses.
  Writer(rtps::RTPSParticipant& participant, shared::Outbox& outbox, const Contract& contract,
         std::function<void()> readersChanged);
  /// Waits until everything written was passed to DDS.
  ~Writer() override;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  const ParticipantId& participant() const { return own_; }

  /// @return Whether that participant has a matched reader.
  bool hasReaderOf(const ParticipantId& participant) const;
  /// @return The participant of the newest reader, or nothing.
  std::optional<ParticipantId> newestReader() const;
  bool hasReaders() const { return readers_.load(std::memory_order_relaxed) > 0; }
  /// @return The number of readers matched so far; they receive what is written now.
  std::uint64_t readersSoFar() const { return readersSoFar_; }

  /// Sends a message of that size, written by `fill`. Never waits for DDS.
  /// @param keeping With `kKept` it is sent again to each new reader, until another one is kept or `forgetKept`.
  void write(std::size_t messageSize, const std::function<void(std::span<std::byte>)>& fill,
             Keeping keeping = Keeping::kNone);
  void forgetKept() { keeping_ = false; }

  /// @return Messages that some reader did not get, because it or DDS was too slow.
  std::uint64_t dropped() const { return dropped_ + droppedBeforeSending(); }

  /// Waits until all readers have acknowledged everything.
  bool waitForAcknowledgement(std::chrono::nanoseconds timeout);

 private:
  void onWriterMatched(rtps::RTPSWriter* writer, rtps::MatchingInfo& info) override;
  bool send(Buffer* sample) override;
  bool sendToAll(Buffer* sample);
  bool sendKeptAgain();
  const std::string& topic() const override { return topic_; }
  bool isDroppedLast() const override { return content_ == Content::kCalls; }
  void removeDelivered();
  void makeRoomFor(std::size_t bytes);
  void removeOldest(const rtps::CacheChange_t& oldest);
  void removeAll();

  using rtps::WriterListener::onWriterMatched;

  ParticipantId own_;
  shared::Outbox& outbox_;
  std::string topic_;
  bool keepsLast_;
  Content content_;
  std::function<void()> readersChanged_;
  std::shared_ptr<SentSamples> samples_;
  rtps::WriterHistory history_;
  /// In the history; guarded by the writer's mutex.
  std::size_t keptBytes_ = 0;
  /// Kept for new readers; used by the outbox's thread.
  std::vector<std::byte> kept_;
  std::atomic<bool> keeping_ = false;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::atomic<int> readers_ = 0;
  std::atomic<std::uint64_t> readersSoFar_ = 0;
  mutable Mutex readersMutex_;
  std::vector<ParticipantId> readersOf_ GUARDED_BY(readersMutex_);
  rtps::RTPSWriter* writer_ = nullptr;
};

/// DDS reader of a topic.
class Reader : private rtps::ReaderListener {
 public:
  /// Called on a DDS thread with each sample of another participant. Its bytes may be swapped.
  using Received = std::function<void(const ParticipantId& sender, Buffer& sample)>;
  /// Called on a DDS thread when a participant's writer ends.
  using WriterGone = std::function<void(const ParticipantId& sender)>;

  /// @throws std::runtime_error if DDS refuses.
  Reader(rtps::RTPSParticipant& participant, const Contract& contract, Received received, WriterGone writerGone = {});
  ~Reader() override;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const ParticipantId& participant() const { return own_; }

  /// @return Messages that writers gave up sending because this reader was too slow.
  std::uint64_t lost() const { return lost_; }

 private:
  void onNewCacheChangeAdded(rtps::RTPSReader* reader, const rtps::CacheChange_t* change) override;
  void onReaderMatched(rtps::RTPSReader* reader, rtps::MatchingInfo& info) override;
  bool isNews(const rtps::CacheChange_t& change, const Buffer& sample);

  using rtps::ReaderListener::onReaderMatched;

  ParticipantId own_;
  Received received_;
  WriterGone writerGone_;
  std::shared_ptr<ReceivedSamples> samples_ = std::make_shared<ReceivedSamples>();
  /// A known writer.
  struct Source {
    /// Number of its last sample.
    std::uint64_t last = 0;
    /// Whether that was received since the writer was last found.
    bool isCurrent = true;
  };
  Mutex sourcesMutex_;
  /// Includes ended writers, since those of a suspended process return.
  std::map<rtps::GUID_t, Source> sources_ GUARDED_BY(sourcesMutex_);
  std::atomic<std::uint64_t> lost_ = 0;
  rtps::ReaderHistory history_;
  rtps::RTPSReader* reader_ = nullptr;
};

}  // namespace pongsim::transport
