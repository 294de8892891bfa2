#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <queue>
#include <string>
#include <vector>

#include "log/mcap/contents.hh"

namespace pongsim::log {

/// The messages of a file in the order of time, whatever the order of its chunks. It keeps in memory what overlaps in
/// time, and of that no more than some 512 MiB: then chunks are read again.
class Merge {
 public:
  /// Says whether a message of that channel and time is wanted.
  using IsWanted = std::function<bool(std::uint16_t channel, std::uint64_t time)>;

  /// @param from, to Blocks that have nothing in between are not read [ns].
  Merge(const InputFile& file, const std::vector<Block>& blocks, std::uint64_t from, std::uint64_t to,
        IsWanted isWanted);

  /// @return The next one, there until the next call, or nothing at the end.
  /// @throws Failure where the file is damaged there.
  std::optional<mcap::Message> next();

 private:
  struct Entry {
    std::uint64_t time = 0;
    /// In `blocks_`.
    std::size_t block = 0;
    /// In the block's unpacked records: of the record's content.
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
    auto operator<=>(const Entry&) const = default;
  };
  struct Loaded {
    UnpackedBlock unpacked;
    /// Entries that are still to come.
    std::size_t wanted = 0;
  };

  void load(std::size_t block);
  const UnpackedBlock& unpacked(std::size_t block);
  void forget(std::size_t block);

  const InputFile& file_;
  const std::vector<Block>& blocks_;
  IsWanted isWanted_;
  /// In the order of the blocks' first times.
  std::vector<std::size_t> order_;
  std::size_t nextBlock_ = 0;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> entries_;
  std::map<std::size_t, Loaded> loaded_;
  std::size_t loadedSize_ = 0;
  /// Whose message was handed out last.
  std::optional<std::size_t> used_;
};

}  // namespace pongsim::log
