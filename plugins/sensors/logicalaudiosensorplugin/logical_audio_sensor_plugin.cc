#include <ignition/msgs/boolean.pb.h>
#include <ignition/msgs/double.pb.h>
#include <ignition/msgs/empty.pb.h>

#include <algorithm>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pongsim/messages/fields.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"
#include "sound.hh"

namespace pongsim {

namespace {

/// A source in its world.
struct PlacedSource {
  PlacedSource(const SoundSource& said, const std::optional<Model>& holder, std::string name)
      : source(said), model(holder), key(std::move(name)), playing(said) {}

  /// @return Whether it is in the world, and not in an unloaded level.
  bool isThere() const { return !model || model->exists(); }
  Vector3 position() const { return ((model ? model->pose() : Pose()) * source.X_ParentSource).position; }
  /// In the order of the file, even if a model was set aside meanwhile.
  std::pair<std::uint64_t, int> order() const { return {model ? model->id().value : 0, source.id}; }

  SoundSource source;
  std::optional<Model> model;
  /// "world/W/model/M/sensor/source_1"
  std::string key;
  Playing playing;
  Service playService;
  Service stopService;
};

/// The sources of all systems of a world.
class Sounds {
 public:
  void add(const PlacedSource& source) {
    sources_.push_back(&source);
    std::ranges::stable_sort(sources_, {}, [](const PlacedSource* each) { return each->order(); });
  }
  void remove(const PlacedSource& source) { std::erase(sources_, &source); }
  const std::vector<const PlacedSource*>& all() const { return sources_; }

 private:
  std::vector<const PlacedSource*> sources_;
};

/// Plays sources, and publishes what microphones detect of all sources in the world.
class LogicalAudioSensorPlugin : public System {
 public:
  ~LogicalAudioSensorPlugin() override {
    for (const PlacedSource& source : sources_) sounds_->remove(source);
  }

  void declare(Declaration& declaration) override {
    declaration.is("Simulates sound sources, and publishes what microphones detect of all sources in the world.",
                   Declaration::Place::kAnywhere);
    declaration.element(
        "source",
        "a sound source: `<id>`, `<pose>`, `<attenuation_function>` linear, `<attenuation_shape>` sphere, "
        "`<inner_radius>` [m] up to which it is as loud as `<volume_level>` (0 to 1), "
        "`<falloff_distance>` [m] from which it is inaudible, `<playing>`, `<play_duration>` [s] (0: "
        "unlimited); all but the pose are required; may be repeated");
    declaration.element(
        "microphone",
        "`<id>`, `<pose>` and `<volume_threshold>` (0), the lowest volume that it detects; may be repeated");
    // one topic per microphone, with its id
    declaration.publishes("/model/M/sensor/mic_ID/detection", "ignition.msgs.Double",
                          "volume of a source, in each step in which it is audible; the first key of the header names "
                          "the source; /world/W instead of /model/M if the plugin is in the world");
    declaration.serves("/model/M/sensor/source_ID/play", "ignition.msgs.Empty", "ignition.msgs.Boolean",
                       "plays the source");
    declaration.serves("/model/M/sensor/source_ID/stop", "ignition.msgs.Empty", "ignition.msgs.Boolean",
                       "stops the source");
  }

  void configure(const SystemContext& context) override {
    for (System* before : context.before) {
      if (auto* other = dynamic_cast<LogicalAudioSensorPlugin*>(before)) sounds_ = other->sounds_;
    }
    if (sounds_ == nullptr) sounds_ = std::make_shared<Sounds>();
    model_ = context.model;
    const std::string world = "world/" + std::string(context.world.name());
    const std::string models = model_ ? modelsOf(*model_) : "";
    fullName_ = world + models + "/sensor/";
    prefix_ = (model_ ? models : "/" + world) + "/sensor/";
    each(context, "source", [&](const Element& element) { addSource(element, context); });
    each(context, "microphone", [&](const Element& element) { addMicrophone(element, context); });
  }

  void preUpdate(const StepInfo& info) override {
    for (PlacedSource& source : sources_) source.playing.update(info.time);
  }

  void postUpdate(const StepInfo& info) override {
    if (info.paused) return;
    for (Ear& ear : ears_) {
      if (ear.publisher.hasSubscribers()) listen(ear, info.time);
    }
  }

  void reset() override {
    for (PlacedSource& source : sources_) source.playing.reset();
  }

  void transfer(StateArchive& archive) override {
    for (PlacedSource& source : sources_) archive(source.playing);
  }

 private:
  /// A microphone in its world.
  struct Ear {
    Microphone microphone;
    Publisher publisher;
  };

  /// @return "/model/outer/model/inner"
  static std::string modelsOf(const Model& model) {
    const std::optional<Model> parent = model.parent();
    return (parent ? modelsOf(*parent) : "") + "/model/" + std::string(model.name());
  }

  /// Calls `add` with each element of that name. One that is invalid is left out; the others stay.
  template <class Add>
  static void each(const SystemContext& context, const char* name, Add add) {
    for (const Element* element : context.sdf.childrenNamed(name)) {
      const std::string left = "this <" + std::string(name) + "> is left out: ";
      try {
        add(*element);
      } catch (const Error& error) {
        const Diagnostic& found = error.diagnostic();
        context.diagnostics.warning(found.position, left + found.message, found.hint);
      } catch (const std::invalid_argument& error) {
        context.diagnostics.warning(element->position, left + error.what());
      }
    }
  }

  void addSource(const Element& element, const SystemContext& context) {
    const SoundSource said = readSource(element, context.diagnostics);
    const std::string name = "source_" + std::to_string(said.id);
    PlacedSource& source = sources_.emplace_back(said, model_, fullName_ + name);
    const auto serve = [&](const char* what, void (Playing::*call)()) {
      using ignition::msgs::Boolean;
      return context.node.serve<ignition::msgs::Empty, Boolean>(
          cleanTopic(prefix_ + name + what), [&source, call](const ignition::msgs::Empty&, Boolean& reply) {
            (source.playing.*call)();
            reply.set_data(true);
            return true;
          });
    };
    try {
      source.playService = serve("/play", &Playing::play);
      source.stopService = serve("/stop", &Playing::stop);
    } catch (...) {
      // the id is taken
      sources_.pop_back();
      throw;
    }
    sounds_->add(source);
  }

  void addMicrophone(const Element& element, const SystemContext& context) {
    const Microphone microphone = readMicrophone(element, context.diagnostics);
    if (std::ranges::any_of(ears_, [&](const Ear& ear) { return ear.microphone.id == microphone.id; })) {
      refuse(*element.child("id"), "there is already a microphone " + std::to_string(microphone.id));
    }
    ears_.push_back({microphone, context.node.advertise<ignition::msgs::Double>(
                                     cleanTopic(prefix_ + "mic_" + std::to_string(microphone.id) + "/detection"))});
  }

  void listen(Ear& ear, Time now) {
    const Pose X_WorldParent = model_ ? model_->pose() : Pose();
    const Vector3 place = (X_WorldParent * ear.microphone.X_ParentMicrophone).position;
    for (const PlacedSource* source : sounds_->all()) {
      if (!source->playing.is() || !source->isThere()) continue;
      const double volume = volumeAt(source->source, (source->position() - place).norm());
      if (!isHeard(volume, ear.microphone)) continue;
      ignition::msgs::Header& header = *message_.mutable_header();
      setStamp(now, header);
      if (header.data_size() == 0) header.add_data();
      header.mutable_data(0)->set_key(source->key);
      message_.set_data(volume);
      ear.publisher.publish(message_);
    }
  }

  std::optional<Model> model_;
  /// Prefix of the names of sources and microphones: in messages, and in topics and services.
  std::string fullName_;
  std::string prefix_;
  std::shared_ptr<Sounds> sounds_;
  // others keep pointers to its elements
  std::list<PlacedSource> sources_;
  std::vector<Ear> ears_;
  ignition::msgs::Double message_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::LogicalAudioSensorPlugin, "ignition::gazebo::systems::LogicalAudioSensorPlugin",
                      "gz::sim::systems::LogicalAudioSensorPlugin");
