#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "log/mcap/chunk_builder.hh"
#include "log/mcap/compression.hh"
#include "log/mcap/output_file.hh"
#include "log/mcap/record_types.hh"

namespace pongsim::log {

/// An MCAP file that is being written: its header, chunk after chunk with the indexes of their messages, the summary.
class McapFile {
 public:
  /// @param profile "", or "ros2".
  /// @throws Failure where the file can't be made.
  McapFile(const std::filesystem::path& path, bool overwrites, const std::string& profile, Compression compression);

  /// @throws Failure where it can't be written. What is whole in the file by then can be read.
  void append(const ChunkBuilder& chunk);

  /// Writes the summary, after which nothing comes.
  /// @param schemas, channels All that the chunks have.
  void finish(const std::vector<mcap::Schema>& schemas, const std::vector<mcap::Channel>& channels);

  std::uint64_t size() const { return file_.size(); }

 private:
  void put(std::string_view bytes);
  void count(const ChunkBuilder& chunk);

  OutputFile file_;
  Compression compression_;
  Packer packer_;
  /// Of all bytes so far.
  std::uint32_t crc_ = 0;
  std::vector<mcap::ChunkIndex> chunks_;
  mcap::Statistics statistics_;
};

}  // namespace pongsim::log
