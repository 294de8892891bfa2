#include <dlfcn.h>

#include <optional>
#include <string>

#include "pongsim/log.hh"
#include "pongsim/system.hh"

namespace pongsim::test {

/// Inserts a model with a sensor and a joint by the world's service `create`, and removes it again by `remove`, as a
/// caller from outside would, but at fixed steps.
class Inserting : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Inserts and removes a model.", Declaration::Place::kWorld);
  }

  void configure(const SystemContext& context) override {
    node_ = context.node;
    prefix_ = "/world/" + std::string(context.world.name()) + "/";
  }

  void preUpdate(const StepInfo& info) override {
    // the request is handled before the next step
    mark(info.iteration == 4 || info.iteration == 12);
    if (info.iteration == 4) {
      call(
          "create", "ignition.msgs.EntityFactory",
          "sdf: \"<sdf version='1.9'><model name='arm'><pose>0 3 1 0 0 0</pose><link name='base'><collision name='c'>"
          "<geometry><box><size>1 1 1</size></box></geometry></collision><sensor name='s' type='imu'>"
          "<update_rate>1000</update_rate></sensor></link><link name='tip'><pose>0 0 1 0 0 0</pose></link>"
          "<joint name='j' type='revolute'><parent>base</parent><child>tip</child><axis><xyz>0 1 0</xyz></axis></joint>"
          "</model></sdf>\"");
    } else if (info.iteration == 12) {
      call("remove", "ignition.msgs.Entity", "name: 'arm' type: MODEL");
    }
  }

 private:
  /// Tells the library that makes calls fail, if it is loaded.
  static void mark(bool isEditing) {
    if (void* const function = dlsym(RTLD_DEFAULT, "pongsimFaultsEdit")) {
      reinterpret_cast<void (*)(bool)>(function)(isEditing);
    }
  }

  void call(const std::string& service, const char* type, const char* content) {
    const MessagePointer message = newMessage(type);
    if (const auto error = parseMessage(content, *message)) return log_.warning(error->message);
    pending_ = node_->request(prefix_ + service, *message, "ignition.msgs.Boolean",
                              [this, service](const CallResult& result, const Message&) {
                                if (!result.error.empty()) log_.warning(service + ": " + result.error);
                              });
  }

  std::optional<Node> node_;
  std::string prefix_;
  PendingRequest pending_;
  Logger log_{"inserting"};
};

}  // namespace pongsim::test

PONGSIM_EXPORT_SYSTEM(pongsim::test::Inserting, "test::Inserting");
