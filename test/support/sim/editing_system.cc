#include <ignition/msgs/stringmsg.pb.h>

#include <optional>
#include <string>

#include "pongsim/system.hh"

namespace pongsim::test {

/// Edits the world on messages on /edit: "template NAME", "text SDF", "file FILE", "read SDF", "find ADDRESS", "copy
/// MODEL", "remove MODEL", "remove itself", at once or, after "step ", in the next step's update. Publishes the result
/// on /edited, except after "silent ".
class Editing : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Edits the world as it is told.", Declaration::Place::kAnywhere);
    declaration.element("sdf", "a model to insert");
    declaration.sharesTopics();
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    edits_ = &context.edits;
    model_ = context.model;
    if (const Element* sdf = context.sdf.child("sdf")) template_ = context.edits.read(*sdf, context.diagnostics);
    edit_ = context.node.subscribe<ignition::msgs::StringMsg>("/edit", [this](const auto& message) {
      if (message.data().starts_with("step ")) {
        waiting_ = message.data().substr(5);
      } else {
        edit(message.data());
      }
    });
    edited_ = context.node.advertise<ignition::msgs::StringMsg>("/edited");
  }

  void update(const StepInfo&) override {
    if (waiting_.empty()) return;
    edit(waiting_);
    waiting_.clear();
  }

 private:
  void edit(const std::string& command) {
    if (command.starts_with("silent ")) return ask(command.substr(7), {}, {});
    ask(
        command,
        [this](const Outcome<Model>& model) {
          if (model && model.value->name() == "bad") throw std::runtime_error("it is bad");
          tell(model ? "there is " + std::string(model.value->name()) : model.error);
        },
        [this](const Outcome<void>& removed) { tell(removed ? "it has gone" : removed.error); });
  }

  void ask(const std::string& command, WorldEdits::Inserted inserted, WorldEdits::Removed removed) {
    const std::size_t blank = command.find(' ');
    const std::string verb = command.substr(0, blank), rest = command.substr(blank + 1);
    if (verb == "template") {
      edits_->insert(*template_, {.name = rest, .pose = Pose{{3, 0, 0}, Quaternion::Identity()}}, std::move(inserted));
    } else if (verb == "text") {
      edits_->insertText(rest, "text", {}, std::move(inserted));
    } else if (verb == "file") {
      edits_->insertFile(rest, {}, std::move(inserted));
    } else if (verb == "read") {
      read(rest, std::move(inserted));
    } else if (verb == "find") {
      tell(edits_->resolve(rest).value_or("nothing").string());
    } else if (verb == "copy") {
      edits_->insertCopy(*world_->model(rest), {.allowRenaming = true}, std::move(inserted));
    } else if (rest == "itself") {
      edits_->remove(*model_, std::move(removed));
    } else {
      edits_->remove(*world_->model(rest), std::move(removed));
    }
  }

  void read(const std::string& text, WorldEdits::Inserted inserted) {
    Diagnostics diagnostics;
    try {
      const ModelTemplate model = edits_->readText(text, "read", diagnostics);
      tell("read " + model.name() + " with " + std::to_string(diagnostics.all().size()) + " warnings");
      edits_->insert(model, {}, std::move(inserted));
    } catch (const Error& error) {
      tell(error.what());
    }
  }

  void tell(const std::string& what) {
    ignition::msgs::StringMsg message;
    message.set_data(what);
    edited_.publish(message);
  }

  World* world_ = nullptr;
  WorldEdits* edits_ = nullptr;
  std::optional<Model> model_;
  std::optional<ModelTemplate> template_;
  std::string waiting_;
  Subscription edit_;
  Publisher edited_;
};

}  // namespace pongsim::test

PONGSIM_EXPORT_SYSTEM(pongsim::test::Editing, "test::Editing");
