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

/// @return The format given by the file extension.
/// @throws UsageError for other extensions.
Format formatOf(const std::filesystem::path& file);

/// A log in one of the formats, recognized by its first bytes.
class LogFile {
 public:
  /// @throws Failure if it can't be read.
  explicit LogFile(const std::filesystem::path& file);

  const Reader& reader() const { return *reader_; }
  Format format() const { return mcap_ == nullptr ? Format::kTlog : Format::kMcap; }
  /// @return The same reader if the format is MCAP, else null.
  const McapReader* mcap() const { return mcap_; }
  /// @return What the file says about a topic's messages; for a tlog that says nothing: that they are protobuf.
  Definition definition(std::string_view topic, std::string_view type) const;

 private:
  std::unique_ptr<Reader> reader_;
  const McapReader* mcap_ = nullptr;
};

/// @return The name of the topic in the file.
/// @throws Failure, with the nearest name as a hint, if there is no such topic.
std::string requireTopic(const Reader& reader, const std::string& file, const std::string& topic);

/// @throws UsageError unless it is one of "zstd", "lz4" and "none".
Compression compressionFrom(const std::string& text);

}  // namespace pongsim::log
