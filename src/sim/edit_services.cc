#include "sim/edit_services.hh"

#include <optional>

#include "base/nearest_word.hh"
#include "msgs/control_messages.hh"
#include "pongsim/log.hh"
#include "pongsim/simulation.hh"
#include "sim/diagnostic_log.hh"

namespace pongsim::sim {

namespace {

const Logger& editLog() {
  static const Logger log("world");
  return log;
}

/// @param refusal Why not, or nothing.
ServiceAnswer answerFor(const std::optional<std::string>& refusal) {
  return refusal ? ServiceAnswer::refused(*refusal) : true;
}

}  // namespace

EditServices::EditServices(Simulation& simulation) : simulation_(simulation) {
  serve("create", "ignition.msgs.EntityFactory", &EditServices::create);
  serve("create_multiple", "ignition.msgs.EntityFactory_V", &EditServices::createMultiple);
  serve("remove", "ignition.msgs.Entity", &EditServices::removeModel);
  serve("set_pose", "ignition.msgs.Pose", &EditServices::setPose);
  serve("set_pose_vector", "ignition.msgs.Pose_V", &EditServices::setPoses);
  serve("set_physics", "ignition.msgs.Physics", &EditServices::setPhysics);
}

void EditServices::serve(const char* name, const char* requestType, Answer answer) {
  const std::string service = cleanTopic("/world/" + std::string(simulation_.world().name()) + "/" + name);
  services_.push_back(simulation_.transport().node().serve(service, requestType, "ignition.msgs.Boolean",
                                                           [this, answer](const Message& request, Message& reply) {
                                                             msgs::setBoolean(true, reply);
                                                             return (this->*answer)(request);
                                                           }));
}

std::optional<std::string> EditServices::insert(const msgs::EntityFactory& asked, std::vector<Model>& inserted) {
  if (!asked.unknownField.empty()) return "field '" + asked.unknownField + "' is not supported";
  if (asked.text.empty() == asked.file.empty()) return "one of 'sdf' and 'sdf_filename' says what to make";
  InsertOptions options;
  options.name = asked.name;
  options.pose = asked.pose;
  options.allowRenaming = asked.allowRenaming;
  Diagnostics diagnostics;
  const std::optional<Model> model = asked.text.empty()
                                         ? simulation_.insertFile(asked.file, options, diagnostics)
                                         : simulation_.insertText(asked.text, "sdf", options, diagnostics);
  const std::string error = logDiagnostics(diagnostics, editLog());
  if (!model) return error;
  inserted.push_back(*model);
  return std::nullopt;
}

ServiceAnswer EditServices::create(const Message& request) {
  std::vector<Model> inserted;
  return answerFor(insert(msgs::entityFactory(request), inserted));
}

// All or none: who asked would not know which ones are there.
ServiceAnswer EditServices::createMultiple(const Message& request) {
  std::vector<Model> inserted;
  for (const msgs::EntityFactory& asked : msgs::entityFactories(request)) {
    const std::optional<std::string> error = insert(asked, inserted);
    if (!error) continue;
    const std::string number = std::to_string(inserted.size() + 1);
    for (const Model& model : inserted) simulation_.remove(model);
    return ServiceAnswer::refused("number " + number + ": " + *error);
  }
  return true;
}

std::optional<Model> EditServices::find(const msgs::EntityName& asked, std::string& error) {
  std::vector<std::string_view> names;
  const std::vector<Model> models = simulation_.world().models();
  for (const Model& model : models) {
    if (asked.id != 0 ? model.id().value == asked.id : model.name() == asked.name) return model;
    names.push_back(model.name());
  }
  if (asked.id != 0) {
    error = "there is no model at the top level with the id " + std::to_string(asked.id);
  } else if (asked.name.empty()) {
    error = "neither a name nor an id is given";
  } else if (simulation_.world().model(asked.name)) {
    error = "'" + asked.name + "' is nested in another model";
  } else {
    const std::string nearest = base::didYouMean(asked.name, names);
    error = "there is no model '" + asked.name + "'" + (nearest.empty() ? "" : "; " + nearest);
  }
  return std::nullopt;
}

ServiceAnswer EditServices::removeModel(const Message& request) {
  const msgs::EntityName asked = msgs::entityName(request);
  if (asked.type != "MODEL" && (asked.id == 0 || asked.type != "NONE")) {
    return ServiceAnswer::refused("'type: " + asked.type + "': only models can be removed, 'type: MODEL'");
  }
  std::string error;
  const std::optional<Model> model = find(asked, error);
  if (!model) return ServiceAnswer::refused(error);
  return answerFor(simulation_.remove(*model));
}

ServiceAnswer EditServices::setPose(const Message& request) {
  const msgs::PoseOfEntity asked = msgs::poseOfEntity(request);
  std::string error;
  std::optional<Model> model = find(asked.entity, error);
  if (!model) return ServiceAnswer::refused(error);
  return answerFor(model->setPose(asked.pose));
}

// All or none, as far as it can be known before: that each is there.
ServiceAnswer EditServices::setPoses(const Message& request) {
  const std::vector<msgs::PoseOfEntity> asked = msgs::posesOfEntities(request);
  std::vector<Model> models;
  for (const msgs::PoseOfEntity& each : asked) {
    std::string error;
    const std::optional<Model> model = find(each.entity, error);
    if (!model) return ServiceAnswer::refused(error);
    models.push_back(*model);
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const std::optional<std::string> refusal = models[i].setPose(asked[i].pose);
    if (refusal) return ServiceAnswer::refused("model '" + std::string(models[i].name()) + "': " + *refusal);
  }
  return true;
}

ServiceAnswer EditServices::setPhysics(const Message& request) {
  const msgs::PhysicsSettings asked = msgs::physicsSettings(request);
  if (asked.stepSize == 0 && asked.realTimeFactor == 0 && !asked.gravity) {
    return ServiceAnswer::refused("none of max_step_size, real_time_factor and gravity is given");
  }
  const Time oldStep = simulation_.stepSize();
  const double oldFactor = simulation_.realTimeFactor();
  std::optional<std::string> refusal;
  // looked at before it becomes a time, which it may not fit
  const double longest = toSeconds(Simulation::kLongestStep);
  if (!(asked.stepSize >= 0 && asked.stepSize <= longest)) refusal = "max_step_size is not between 0 and 1 s";
  if (!refusal && asked.stepSize != 0) refusal = simulation_.setStepSize(fromSeconds(asked.stepSize));
  if (!refusal && asked.realTimeFactor != 0) refusal = simulation_.setRealTimeFactor(asked.realTimeFactor);
  if (!refusal && asked.gravity) refusal = simulation_.world().setGravity(*asked.gravity);
  if (!refusal) return true;
  simulation_.setStepSize(oldStep);
  simulation_.setRealTimeFactor(oldFactor);
  return ServiceAnswer::refused(*refusal);
}

}  // namespace pongsim::sim
