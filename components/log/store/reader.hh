#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "log/store/record.hh"

namespace pongsim::log {

/// A topic of a log. A name with records of two types is listed twice.
struct Topic {
  std::string name;
  std::string type;
  std::uint64_t count = 0;
  bool operator==(const Topic&) const = default;
};

/// Time range of a log's records, both ends included [ns].
struct TimeRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
  bool operator==(const TimeRange&) const = default;
};

/// Selects records.
struct Selection {
  /// The first and the last time [ns], both included.
  std::int64_t from = std::numeric_limits<std::int64_t>::min();
  std::int64_t to = std::numeric_limits<std::int64_t>::max();
  /// Names of topics; unset: all.
  std::optional<std::vector<std::string>> topics = std::nullopt;
};

/// Reads a log. If the log is still being written, it is read as it was when it was opened.
class Reader {
 public:
  virtual ~Reader() = default;

  /// @return Sorted by name, then by type. Counting may require reading the whole file.
  virtual std::vector<Topic> topics() const = 0;

  /// @return Nothing for a log without records.
  virtual std::optional<TimeRange> timeRange() const = 0;

  /// Calls `visit` with each record in time order; records with the same time in the order in which they were written.
  /// The record is valid until `visit` returns.
  /// @param visit Returns false to stop.
  /// @throws Failure if the file can't be read; `visit` has then received the records before that point.
  virtual void forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const = 0;

  /// @return What is missing in a truncated or damaged log, as a sentence without a full stop; nothing if it is
  /// complete.
  virtual std::optional<std::string> torn() const = 0;
};

}  // namespace pongsim::log
