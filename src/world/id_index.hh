#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace pongsim::world {

/// Where what has an id stands. Handles ask for it at each call, so that it is a table without chains and divisions.
class IdIndex {
 public:
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

  /// @param id Not zero, and not there yet.
  void add(std::uint64_t id, std::size_t place) {
    // two thirds full at most
    if (3 * (count_ + 1) > 2 * entries_.size()) grow();
    ++count_;
    put(id, place);
  }

  /// @param id There already.
  void move(std::uint64_t id, std::size_t place) { entries_[indexOf(id)].place = place; }

  /// @param id There already.
  void remove(std::uint64_t id) {
    std::size_t hole = indexOf(id);
    // what stands behind moves up, as far as it may stand there
    for (std::size_t i = next(hole); entries_[i].id != 0; i = next(i)) {
      const std::size_t mask = entries_.size() - 1;
      if (((i - firstOf(entries_[i].id)) & mask) < ((i - hole) & mask)) continue;
      entries_[hole] = entries_[i];
      hole = i;
    }
    entries_[hole] = Entry();
    --count_;
  }

  /// @return Its place, or `kNowhere`.
  std::size_t find(std::uint64_t id) const {
    if (entries_.empty()) return kNowhere;
    for (std::size_t i = firstOf(id);; i = next(i)) {
      if (entries_[i].id == id) return entries_[i].place;
      if (entries_[i].id == 0) return kNowhere;
    }
  }

  void clear() {
    entries_.clear();
    count_ = 0;
  }

 private:
  struct Entry {
    std::uint64_t id = 0;
    std::size_t place = kNowhere;
  };

  // ids follow each other: their low bits spread them
  std::size_t firstOf(std::uint64_t id) const { return id & (entries_.size() - 1); }
  std::size_t next(std::size_t i) const { return (i + 1) & (entries_.size() - 1); }

  std::size_t indexOf(std::uint64_t id) const {
    std::size_t i = firstOf(id);
    while (entries_[i].id != id) i = next(i);
    return i;
  }

  void put(std::uint64_t id, std::size_t place) {
    std::size_t i = firstOf(id);
    while (entries_[i].id != 0) i = next(i);
    entries_[i] = {id, place};
  }

  void grow() {
    std::vector<Entry> old(entries_.empty() ? 16 : 2 * entries_.size());
    old.swap(entries_);
    for (const Entry& entry : old) {
      if (entry.id != 0) put(entry.id, entry.place);
    }
  }

  /// A power of two of them; an id of zero stands for a free one.
  std::vector<Entry> entries_;
  std::size_t count_ = 0;
};

}  // namespace pongsim::world
