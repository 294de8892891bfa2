#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace pongsim::world {

/// Finds slots by ids. Ids are consecutive, so it is a table of slots in pages: handles look one up in each call. It
/// needs one byte per 128 ids up to the largest, and the pages in use.
class IdIndex {
 public:
  static constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

  /// @param id Not zero, and not in use.
  void add(std::uint64_t id, std::size_t place) {
    const std::size_t number = id / kPageSize;
    if (number >= pages_.size()) pages_.resize(number + 1);
    std::unique_ptr<Page>& page = pages_[number];
    if (page == nullptr) page = std::make_unique<Page>();
    ++page->count;
    page->places[id % kPageSize] = place;
  }

  /// @param id In use.
  void move(std::uint64_t id, std::size_t place) { pages_[id / kPageSize]->places[id % kPageSize] = place; }

  /// Does nothing if the id is not in use.
  void remove(std::uint64_t id) noexcept {
    if (find(id) == kNowhere) return;
    std::unique_ptr<Page>& page = pages_[id / kPageSize];
    page->places[id % kPageSize] = kNowhere;
    if (--page->count == 0) page.reset();
  }

  /// @return Its slot, or `kNowhere`.
  std::size_t find(std::uint64_t id) const {
    const std::size_t number = id / kPageSize;
    if (number >= pages_.size() || pages_[number] == nullptr) return kNowhere;
    return pages_[number]->places[id % kPageSize];
  }

  void clear() { pages_.clear(); }

 private:
  static constexpr std::size_t kPageSize = 1024;

  struct Page {
    Page() { places.fill(kNowhere); }
    std::size_t count = 0;
    std::array<std::size_t, kPageSize> places;
  };

  std::vector<std::unique_ptr<Page>> pages_;
};

}  // namespace pongsim::world
