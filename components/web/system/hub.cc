#include "web/system/hub.hh"

#include <dlfcn.h>

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "web/system/traffic_channel.hh"

namespace pongsim::web {

namespace {

/// @return Whether two worlds request the same server. Random tokens are not compared.
bool isSame(const ServerSettings& a, const ServerSettings& b) {
  const auto values = [](const ServerSettings& each) {
    const AccessRules& access = each.access;
    return std::tie(each.addresses, each.certificate, each.key, access.isOpen, access.isReadOnly, access.readingOrigins,
                    access.writingOrigins, each.framingOrigins);
  };
  return values(a) == values(b);
}

}  // namespace

std::shared_ptr<Hub> Hub::open(const ServerSettings& settings, const GzSettings& gz) {
  static std::mutex mutex;
  static std::map<int, std::weak_ptr<Hub>> hubs;
  const std::lock_guard lock(mutex);
  std::weak_ptr<Hub>& place = hubs[settings.port];
  std::shared_ptr<Hub> hub = place.lock();
  if (!hub) {
    place = hub = std::make_shared<Hub>(settings, gz);
  } else if (!isSame(hub->settings_, settings) || hub->gzSettings_ != gz) {
    throw std::runtime_error("another world uses port " + std::to_string(settings.port) +
                             " with other settings; use the same settings for both, or another <port> for this one");
  }
  return hub;
}

Hub::Hub(ServerSettings settings, const GzSettings& gz)
    : settings_(std::move(settings)), gzSettings_(gz), gz_(worlds_, assets_, gz), plain_(worlds_, gz_, recentLog_) {
  settings_.findAsset = [this](std::string_view address) { return assets_.find(address); };
  channels_.add(std::make_shared<TrafficChannel>(settings_.traffic));
  server_.emplace(settings_, log_, std::vector<Protocol*>{&foxglove_, &plain_});
}

std::filesystem::path installedPage() {
  Dl_info self{};
  if (dladdr(reinterpret_cast<const void*>(&installedPage), &self) == 0 || self.dli_fname == nullptr) return {};
  std::error_code error;
  const std::filesystem::path library = std::filesystem::canonical(self.dli_fname, error);
  // PREFIX/lib/pongsim/plugins, or one folder deeper with multiarch
  for (std::filesystem::path folder = library.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    std::filesystem::path page = folder / "share" / "pongsim" / "web";
    if (std::filesystem::exists(page / "index.html", error)) return page;
  }
  return {};
}

}  // namespace pongsim::web
