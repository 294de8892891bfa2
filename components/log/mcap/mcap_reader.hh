#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "log/mcap/contents.hh"
#include "log/mcap/definition.hh"
#include "log/mcap/input_file.hh"
#include "log/store/reader.hh"

namespace pongsim::log {

/// How a file's messages are compressed.
struct Packing {
  /// "zstd", "lz4" or "none"; several are separated by commas.
  std::string compression;
  std::uint64_t chunks = 0;
  /// Total size of the chunks [B].
  std::uint64_t packed = 0, unpacked = 0;
};

/// Reads MCAP, using its index if there is one. Of a truncated file it reads everything before the cut. A topic whose
/// type the file does not give has the type "".
class McapReader final : public Reader {
 public:
  /// @throws Failure if it is not an MCAP file.
  explicit McapReader(const std::filesystem::path& path);

  std::vector<Topic> topics() const override;
  std::optional<TimeRange> timeRange() const override;
  void forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const override;
  std::optional<std::string> torn() const override;

  /// @return What the file says about a topic's messages.
  Definition definition(std::string_view topic, std::string_view type) const;
  /// @return "", "ros2" or another profile of its writer.
  const std::string& profile() const { return contents_.header.profile; }
  /// @return The program that wrote it.
  const std::string& library() const { return contents_.header.library; }
  Packing packing() const;

 private:
  const mcap::Schema* schemaOf(const mcap::Channel& channel) const;
  std::string_view typeOf(const mcap::Channel& channel) const;

  std::string name_;
  InputFile file_;
  Contents contents_;
};

}  // namespace pongsim::log
