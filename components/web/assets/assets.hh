#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>

#include "web/assets/world_files.hh"
#include "web/server/session.hh"

namespace pongsim::web {

/// The files of all worlds in the process. For any thread.
class Assets final : public AssetSource {
 public:
  /// Larger files are reported as too large; they are still available by HTTP.
  static constexpr std::uintmax_t kLargest = std::uintmax_t{24} << 20;

  /// @param world Identifies the world: its previous files are forgotten.
  void set(const void* world, WorldFiles files);
  void remove(const void* world);

  std::optional<std::filesystem::path> find(std::string_view address) const;
  Asset fetch(std::string_view address) const override;

 private:
  mutable std::mutex mutex_;
  std::map<const void*, std::shared_ptr<const WorldFiles>> worlds_;
};

}  // namespace pongsim::web
