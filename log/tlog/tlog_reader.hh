#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "log/store/reader.hh"

namespace pongsim::log {

/// Reads Fortress's log files, its own and those of `TlogWriter`. Of a file that is cut off it reads what is there.
class TlogReader final : public Reader {
 public:
  /// @throws Failure where the file can't be opened, or is no such log.
  explicit TlogReader(const std::filesystem::path& file);
  ~TlogReader() override;

  /// As `Reader::topics`. The first call counts: it goes through all of the file.
  std::vector<Topic> topics() const override;
  /// @return The names of the topics with messages of a type, which is known without counting.
  std::vector<std::string> topicsOf(std::string_view type) const;
  std::optional<TimeRange> timeRange() const override;
  void forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const override;
  std::optional<std::string> torn() const override;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pongsim::log
