#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "log/mcap/chunk_builder.hh"
#include "log/mcap/compression.hh"
#include "log/mcap/definition.hh"
#include "log/mcap/mcap_file.hh"
#include "log/store/writer.hh"

namespace pongsim::log {

struct McapOptions {
  /// Whether an existing file is overwritten; if not, it is an error.
  bool overwrites = false;
  Compression compression = Compression::kZstd;
  /// "", or "ros2" if all messages are ROS messages.
  std::string profile = {};
  /// A chunk ends with the message that brings it to this size [B], ...
  std::size_t chunkSize = std::size_t{4} << 20U;
  /// ... or this long after its first message was written, in wall time.
  std::chrono::milliseconds chunkAge{500};
  /// `write` blocks while more than this is waiting to be compressed and written [B].
  std::size_t queueSize = std::size_t{64} << 20U;
};

/// Writes MCAP. Compression and writing happen on a thread of their own. Negative times are an error.
class McapWriter final : public Writer {
 public:
  /// @param definitions Called once for each topic and type. A type without a name has no schema.
  /// @throws Failure if the file can't be created.
  McapWriter(const std::filesystem::path& path, McapOptions options, Definitions definitions);
  ~McapWriter() override;
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  void write(const Record& record) override;
  void close() override;

 private:
  using Clock = std::chrono::steady_clock;

  mcap::Channel& channelFor(const Record& record);
  std::uint16_t schemaFor(std::string_view type, const Definition& definition);
  void endChunk();
  std::optional<ChunkBuilder> nextChunk();
  void work();
  void workSafely();

  const McapOptions options_;
  const Definitions definitions_;
  McapFile file_;

  // used by `write`, with the mutex held
  // Keyed by topic and type.
  std::map<std::tuple<std::string, std::string>, std::uint16_t, std::less<>> channelIds_;
  std::vector<mcap::Schema> schemas_;
  std::vector<mcap::Channel> channels_;
  std::vector<std::uint32_t> sequences_;

  std::mutex mutex_;
  std::condition_variable changed_;
  ChunkBuilder open_;
  Clock::time_point openSince_;
  std::deque<ChunkBuilder> waiting_;
  std::size_t waitingSize_ = 0;
  bool isClosing_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace pongsim::log
