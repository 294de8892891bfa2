#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "log/mcap/compression.hh"
#include "log/mcap/mcap_reader.hh"
#include "log/store/reader.hh"
#include "log/store/writer.hh"

namespace pongsim::log {

enum class Format { kTlog, kMcap };

/// @return By the name's end.
/// @throws UsageError where that is another one.
Format formatOf(const std::filesystem::path& file);

/// A log of one of the formats, which its first bytes tell.
class LogFile {
 public:
  /// @throws Failure where it can't be read.
  explicit LogFile(const std::filesystem::path& file);

  const Reader& reader() const { return *reader_; }
  Format format() const { return mcap_ == nullptr ? Format::kTlog : Format::kMcap; }
  /// @return The same reader where the format is MCAP, else null.
  const McapReader* mcap() const { return mcap_; }
  /// @return What the file says of a topic's messages; of a tlog, where it says nothing, that they are protobuf.
  Definition definition(std::string_view topic, std::string_view type) const;

 private:
  std::unique_ptr<Reader> reader_;
  const McapReader* mcap_ = nullptr;
};

/// @return The name of the topic in the file.
/// @throws Failure, with the nearest name as a hint, where it has no such.
std::string requireTopic(const Reader& reader, const std::string& file, const std::string& topic);

/// @throws UsageError where it is none of "zstd", "lz4" and "none".
Compression compressionFrom(const std::string& text);

}  // namespace pongsim::log
