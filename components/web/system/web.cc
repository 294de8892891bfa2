#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "pongsim/files/fuel_address.hh"
#include "pongsim/message.hh"
#include "pongsim/scene.hh"
#include "pongsim/sensing/marker_services.hh"
#include "pongsim/system.hh"
#include "pongsim/world_edits.hh"
#include "web/assets/world_files.hh"
#include "web/frames/contact_channel.hh"
#include "web/frames/pose_feed.hh"
#include "web/pictures/picture_channel.hh"
#include "web/system/hub.hh"
#include "web/system/parameters.hh"
#include "web/world/relay.hh"

namespace pongsim::web {

namespace {

constexpr std::size_t kMostWarnings = 20;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string{} : std::string(value);
}

/// Prints the address of the page, whatever the log level.
void announce(const Hub& hub) {
  if (logLevel() == LogLevel::kNone) return;
  const std::string address = pageAddress(hub.settings(), hub.server().port());
  std::fprintf(stderr, "in a browser: %s\n", address.c_str());
}

/// @return The folders whose files may be served for inserted models. Those that a request adds later are not among
/// them.
std::vector<std::filesystem::path> foldersOfModels(const SystemContext& context) {
  std::vector<std::filesystem::path> folders = context.edits.resourceFolders();
  if (std::filesystem::path cache = fuelCacheFolder(); !cache.empty()) folders.push_back(std::move(cache));
  if (const auto file = context.world.sourcePosition().file)
    folders.push_back(std::filesystem::absolute(*file).parent_path());
  return folders;
}

class Web final : public System {
 public:
  ~Web() override {
    feed_.reset();
    if (!hub_) return;
    if (channel_) hub_->channels().remove(*channel_);
    if (pictures_) {
      hub_->channels().remove(*pictures_);
      pictures_->end();
      hub_->channels().remove(*contacts_);
      contacts_->end();
    }
    hub_->assets().remove(this);
    relay_.reset();
  }

  void declare(Declaration& declaration) override {
    declaration.is("Shows the world in browsers, and to clients of Foxglove and of ign-launch's WebSocket server.",
                   Declaration::Place::kWorld);
    declaration.standsOutside();
    parameters_.declare(declaration);
    MarkerServices::declare(declaration, MarkerViewers::kPeople);
  }

  void configure(const SystemContext& context) override {
    try {
      parameters_.readRest(context.sdf);
      ServerSettings settings = serverSettings(parameters_, variable("PONGSIM_NETWORK"), variable("PONGSIM_WEB_TOKEN"));
      settings.page = installedPage();
      hub_ = Hub::open(settings, parameters_.gz);
    } catch (const std::exception& error) {
      // an error here keeps the run from starting
      context.diagnostics.error(context.sdf.position, error.what());
      return;
    }
    if (hub_->settings().page.empty()) context.log.warning("the page is not installed: other clients only");
    world_.emplace(context.world);
    log_ = &context.log;
    const std::vector<std::uint64_t> ids = Scene(*world_).topLevelIds();
    ownIds_.insert(ids.begin(), ids.end());
    folders_ = foldersOfModels(context);
    const std::string name(context.world.name());
    const auto wake = [waking = context.node]() mutable { waking.wake(); };
    channel_ = std::make_shared<PoseChannel>(name, wake);
    pictures_ = std::make_shared<PictureChannel>(name, wake);
    hub_->channels().add(channel_);
    contacts_ = std::make_shared<ContactChannel>(name, wake);
    hub_->channels().add(pictures_);
    hub_->channels().add(contacts_);
    feed_.emplace(context.world, channel_);
    relay_.emplace(hub_->worlds(), name, context.node, context.log);
    mustAnnounce_ = hub_.use_count() == 1;
    // the services have the same name in all worlds: those of a run are of its first world
    if (mustAnnounce_) markers_.emplace(context.world, context.node, context.log, MarkerViewers::kPeople);
  }

  void preUpdate(const StepInfo& step) override {
    if (!relay_) return;
    // in the first step: before it, the run may still fail to start
    if (std::exchange(mustAnnounce_, false)) announce(*hub_);
    reportSettings(step);
    relay_->update(step);
    if (areFilesOld_ && hub_->server().clients() > 0) updateFiles();
  }

  void postUpdate(const StepInfo& step) override {
    if (!feed_) return;
    if (markers_) markers_->update(step.time);
    feed_->update(step);
    pictures_->update(*world_, step);
    contacts_->update(*world_, step);
  }

  void reset() override {
    // before the first step, which may have the time of the last one
    if (markers_) markers_->update(Time(0));
  }

  void worldChanged() override {
    areFilesOld_ = true;
    if (feed_) feed_->worldChanged();
  }

 private:
  void updateFiles() {
    areFilesOld_ = false;
    const MessagePointer own = newMessage("ignition.msgs.Scene"), inserted = newMessage("ignition.msgs.Scene");
    const Scene scene(*world_);
    scene.fillIn(*own, [this](std::uint64_t id) { return ownIds_.contains(id); });
    scene.fillIn(*inserted, [this](std::uint64_t id) { return !ownIds_.contains(id); });
    std::vector<std::string> skins;
    for (const ActorPlace& actor : scene.actors()) skins.push_back(actor.skin);
    WorldFiles files(*own, skins);
    for (const std::string& file : files.addInserted(*inserted, folders_)) warnOf(file);
    hub_->assets().set(this, std::move(files));
  }

  /// Once per file, and not of more than some.
  void warnOf(const std::string& file) {
    if (refused_.size() >= kMostWarnings || !refused_.insert(file).second) return;
    log_->warning("clients don't get '" + file +
                  "' of an inserted model: it is in none of the folders of models; start the run with its folder in "
                  "PONGSIM_RESOURCE_PATH");
  }

  /// Published in advance, because clients request it when they connect.
  void reportSettings(const StepInfo& step) {
    // while the world is paused, dt is 0
    if (step.dt > Time(0)) stepSize_ = toSeconds(step.dt);
    const Vector3 gravity = world_->gravity();
    relay_->reportSettings({.isPaused = step.paused,
                            .realTimeFactor = world_->realTimeFactor(),
                            .stepSize = stepSize_,
                            .gravity = {gravity.x(), gravity.y(), gravity.z()}});
  }

  WebParameters parameters_;
  std::shared_ptr<Hub> hub_;
  std::optional<World> world_;
  std::shared_ptr<PoseChannel> channel_;
  std::shared_ptr<PictureChannel> pictures_;
  std::shared_ptr<ContactChannel> contacts_;
  std::optional<MarkerServices> markers_;
  std::optional<PoseFeed> feed_;
  std::optional<Relay> relay_;
  /// Duration of the last step [s].
  std::optional<double> stepSize_;
  const Logger* log_ = nullptr;
  /// Models and lights of the world's file.
  std::unordered_set<std::uint64_t> ownIds_;
  /// Where files of inserted models may lie.
  std::vector<std::filesystem::path> folders_;
  /// Files of inserted models that lie elsewhere.
  std::set<std::string> refused_;
  bool areFilesOld_ = true;
  bool mustAnnounce_ = false;
};

}  // namespace

}  // namespace pongsim::web

PONGSIM_EXPORT_SYSTEM(pongsim::web::Web, "pongsim::systems::Web", "gz::sim::systems::WebsocketServer",
                      "gz::launch::WebsocketServer", "ignition::launch::WebsocketServer",
                      "ignition::launch::v5::WebsocketServer");
