#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "log/store/reader.hh"

namespace pongsim::log {

/// Reads Fortress's log files, written by Fortress or by `TlogWriter`. Of a truncated file it reads what is there.
class TlogReader final : public Reader {
 public:
  /// @throws Failure if the file can't be opened, or is not such a log.
  explicit TlogReader(const std::filesystem::path& file);
  ~TlogReader() override;

  /// See `Reader::topics`. The first call reads the whole file to count.
  std::vector<Topic> topics() const override;
  /// @return The names of the topics with messages of a type; needs no counting.
  std::vector<std::string> topicsOf(std::string_view type) const;
  std::optional<TimeRange> timeRange() const override;
  void forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const override;
  std::optional<std::string> torn() const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::log
