#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "log/store/record.hh"

namespace pongsim::log {

/// A topic of a log. A name with records of two types is there twice.
struct Topic {
  std::string name;
  std::string type;
  std::uint64_t count = 0;
  bool operator==(const Topic&) const = default;
};

/// Of a log's records, both ends included [ns].
struct TimeRange {
  std::int64_t first = 0;
  std::int64_t last = 0;
  bool operator==(const TimeRange&) const = default;
};

/// Which records are wanted.
struct Selection {
  /// The first and the last time [ns], both included.
  std::int64_t from = std::numeric_limits<std::int64_t>::min();
  std::int64_t to = std::numeric_limits<std::int64_t>::max();
  /// Names of topics; unset: all.
  std::optional<std::vector<std::string>> topics = std::nullopt;
};

/// Reads a log, which may be one that is still being written: it is read as it was when it was opened.
class Reader {
 public:
  virtual ~Reader() = default;

  /// @return Sorted by name, then by type. It may have to go through all of the file to count.
  virtual std::vector<Topic> topics() const = 0;

  /// @return Nothing of a log without records.
  virtual std::optional<TimeRange> timeRange() const = 0;

  /// Calls `visit` with each record in the order of time, those of one time in the order in which they were written.
  /// The record lives until `visit` returns.
  /// @param visit Ends it by returning false.
  /// @throws Failure where the file can't be read; then `visit` has had the records before that place.
  virtual void forEach(const Selection& selection, const std::function<bool(const Record&)>& visit) const = 0;

  /// @return What is missing of a log whose writing was cut off, or that is damaged, in a sentence without a full stop;
  /// nothing where it is whole.
  virtual std::optional<std::string> torn() const = 0;
};

}  // namespace pongsim::log
