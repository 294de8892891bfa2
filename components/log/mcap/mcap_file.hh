#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "log/mcap/chunk_builder.hh"
#include "log/mcap/compression.hh"
#include "log/mcap/output_file.hh"
#include "log/mcap/record_types.hh"

namespace pongsim::log {

/// An MCAP file being written: its header, each chunk with its message indexes, the summary.
class McapFile {
 public:
  /// @param profile "", or "ros2".
  /// @throws Failure if the file can't be created.
  McapFile(const std::filesystem::path& path, bool overwrites, const std::string& profile, Compression compression);

  /// @throws Failure if it can't be written. What is complete by then can be read.
  void append(const ChunkBuilder& chunk);

  /// Writes the summary, which ends the file.
  /// @param schemas, channels All that occur in chunks.
  void finish(const std::vector<mcap::Schema>& schemas, const std::vector<mcap::Channel>& channels);

  std::uint64_t size() const { return file_.size(); }

 private:
  void put(std::string_view bytes);
  void count(const ChunkBuilder& chunk);

  OutputFile file_;
  Compression compression_;
  Packer packer_;
  /// Of all bytes written so far.
  std::uint32_t crc_ = 0;
  std::vector<mcap::ChunkIndex> chunks_;
  mcap::Statistics statistics_;
};

}  // namespace pongsim::log
