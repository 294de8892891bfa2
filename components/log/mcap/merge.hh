#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <string>
#include <vector>

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// Iterates over the messages of a file in time order, whatever the order of its chunks. Chunks that overlap in time
/// are kept in memory, up to some 512 MiB; beyond that, chunks are read again.
class Merge {
 public:
  /// Whether a message with this channel and time is wanted.
  using IsWanted = std::function<bool(std::uint16_t channel, std::uint64_t time)>;

  /// @param from, to Blocks without messages in this range are not read [ns].
  Merge(const InputFile& file, const std::vector<Block>& blocks, std::uint64_t from, std::uint64_t to,
        IsWanted isWanted);

  /// @return The next message, valid until the next call; nothing at the end.
  /// @throws Failure if the file is damaged there.
  std::optional<mcap::Message> next();

 private:
  struct QueuedMessage {
    std::uint64_t time = 0;
    /// Index in `blocks_`.
    std::size_t block = 0;
    /// Offset of the record's content in the block's uncompressed records.
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    auto operator<=>(const QueuedMessage&) const = default;
  };
  struct Loaded {
    UnpackedBlock unpacked;
    /// Number of messages not returned yet.
    std::size_t wanted = 0;
  };

  void load(std::size_t block);
  const UnpackedBlock& unpacked(std::size_t block);
  void forget(std::size_t block);

  const InputFile& file_;
  const std::vector<Block>& blocks_;
  IsWanted isWanted_;
  /// Sorted by the blocks' start times.
  std::vector<std::size_t> order_;
  std::size_t nextBlock_ = 0;
  std::priority_queue<QueuedMessage, std::vector<QueuedMessage>, std::greater<>> queue_;
  std::map<std::size_t, Loaded> loaded_;
  std::size_t loadedSize_ = 0;
  /// The block of the last returned message.
  std::optional<std::size_t> used_;
};

}  // namespace pongsim::log
