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
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transport/outbox.hh"
#include "transport/payload.hh"
#include "transport/sample_pool.hh"

namespace pongsim::transport {

namespace rtps = eprosima::fastrtps::rtps;

/// What an endpoint tells and asks of its counterparts.
struct Contract {
  std::string topic;
  std::string type;
  /// DDS partition, none where empty.
  std::string partition;
  /// Whether a reader that comes later gets the last message, and no other is kept.
  bool keepsLast = false;
};

ParticipantId participantId(const rtps::GuidPrefix_t& prefix);

/// A topic's way out to other processes. Reliable for those who keep up; a slow one loses the oldest messages, and
/// holds up nobody.
class Writer : private rtps::WriterListener, private Outbox::Target {
 public:
  /// @param outbox Takes the messages to DDS. Must outlive it.
  /// @param readersChanged Called from a DDS thread when a reader elsewhere comes or goes.
  /// @throws std::runtime_error where DDS refuses.
  Writer(rtps::RTPSParticipant& participant, Outbox& outbox, const Contract& contract,
         std::function<void()> readersChanged);
  /// Waits until DDS has all that was written.
  ~Writer() override;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// @return Whether that participant's reader would get what is written now.
  bool hasReaderOf(const ParticipantId& participant) const;
  /// @return The participant of the reader that came last, or nothing.
  std::optional<ParticipantId> newestReader() const;
  bool hasReaders() const { return readers_.load(std::memory_order_relaxed) > 0; }
  /// @return How many have come so far; what is written now reaches them.
  std::uint64_t readersSoFar() const { return readersSoFar_; }

  /// Sends a message of so many bytes, which `fill` writes to the place it is given. Never waits for DDS.
  /// @param keeping With `kKept` it is sent again to each reader that comes, until another one is kept or `forgetKept`.
  void write(std::size_t messageSize, const std::function<void(std::span<std::byte>)>& fill,
             Keeping keeping = Keeping::kNone);
  void forgetKept() { keeping_ = false; }

  /// @return Messages that some reader did not get, because it or DDS did not keep up.
  std::uint64_t dropped() const { return dropped_ + droppedBeforeSending(); }

  /// Waits until all readers have acknowledged everything.
  bool waitForAcknowledgement(std::chrono::nanoseconds timeout);

 private:
  void onWriterMatched(rtps::RTPSWriter* writer, rtps::MatchingInfo& info) override;
  bool send(Buffer* sample) override;
  bool sendToAll(Buffer* sample);
  bool sendKeptAgain();
  const std::string& topic() const override { return topic_; }
  void removeDelivered();
  void makeRoomFor(std::size_t bytes);
  void removeOldest(const rtps::CacheChange_t& oldest);
  void removeAll();

  using rtps::WriterListener::onWriterMatched;

  ParticipantId own_;
  Outbox& outbox_;
  std::string topic_;
  bool keepsLast_;
  std::function<void()> readersChanged_;
  std::shared_ptr<SentSamples> samples_;
  rtps::WriterHistory history_;
  /// In the history, guarded by the writer's mutex.
  std::size_t keptBytes_ = 0;
  /// What is kept for readers that come, for the outbox's thread.
  std::vector<std::byte> kept_;
  std::atomic<bool> keeping_ = false;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::atomic<int> readers_ = 0;
  std::atomic<std::uint64_t> readersSoFar_ = 0;
  mutable std::mutex readersMutex_;
  std::vector<ParticipantId> readersOf_;
  rtps::RTPSWriter* writer_ = nullptr;
};

/// A topic's way in from other processes.
class Reader : private rtps::ReaderListener {
 public:
  /// Called from a DDS thread with each sample that another participant has sent. Its bytes may be exchanged for
  /// others.
  using Received = std::function<void(const ParticipantId& sender, Buffer& sample)>;
  /// Called from a DDS thread when a participant's writer has ended.
  using WriterGone = std::function<void(const ParticipantId& sender)>;

  /// @throws std::runtime_error where DDS refuses.
  Reader(rtps::RTPSParticipant& participant, const Contract& contract, Received received, WriterGone writerGone = {});
  ~Reader() override;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// @return Messages that writers gave up sending, because this reader did not keep up.
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
  /// A writer that has been heard.
  struct Source {
    /// Number of its last sample.
    std::uint64_t last = 0;
    /// Whether that came since it was found, the last time it was.
    bool isCurrent = true;
  };
  std::mutex sourcesMutex_;
  /// Those that have gone too, for one of a process that was stopped comes again.
  std::map<rtps::GUID_t, Source> sources_;
  std::atomic<std::uint64_t> lost_ = 0;
  rtps::ReaderHistory history_;
  rtps::RTPSReader* reader_ = nullptr;
};

}  // namespace pongsim::transport
