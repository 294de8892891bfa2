#pragma once

#include <fastdds/rtps/history/ReaderHistory.h>
#include <fastdds/rtps/participant/RTPSParticipant.h>
#include <fastdds/rtps/reader/ReaderListener.h>

#include <atomic>
#include <cstdint>
#include <functional>

#include "ros2/wire/endpoint.hh"

namespace pongsim::ros2 {

namespace rtps = eprosima::fastrtps::rtps;

/// A reader of a topic.
class Reader final : private rtps::ReaderListener {
 public:
  /// Called from a DDS thread with the samples of other participants, in order.
  using Received = std::function<void(const Sample&)>;

  /// @throws std::runtime_error if DDS fails.
  Reader(rtps::RTPSParticipant& participant, const Contract& contract, Received received);
  /// `received` is not called from then on.
  ~Reader() override;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const Guid& id() const { return id_; }
  std::size_t writers() const { return writerCount_; }
  std::uint64_t received() const { return receivedCount_; }

 private:
  void onNewCacheChangeAdded(rtps::RTPSReader* reader, const rtps::CacheChange_t* change) override;
  void onReaderMatched(rtps::RTPSReader* reader, rtps::MatchingInfo& info) override;
  using rtps::ReaderListener::onReaderMatched;

  Received received_;
  rtps::ReaderHistory history_;
  std::atomic<std::size_t> writerCount_ = 0;
  std::atomic<std::uint64_t> receivedCount_ = 0;
  Guid id_;
  rtps::RTPSReader* reader_ = nullptr;
};

}  // namespace pongsim::ros2
