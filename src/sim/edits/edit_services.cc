#include "sim/edits/edit_services.hh"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/nearest_word.hh"
#include "msgs/control/control_messages.hh"
#include "pongsim/log.hh"
#include "pongsim/message.hh"
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
  serve("remove", "ignition.msgs.Entity", &EditServices::remove);
  serve("set_pose", "ignition.msgs.Pose", &EditServices::setPose);
  serve("set_pose_vector", "ignition.msgs.Pose_V", &EditServices::setPoses);
  serve("set_spherical_coordinates", "ignition.msgs.SphericalCoordinates", &EditServices::setPlace);
  serve("light_config", "ignition.msgs.Light", &EditServices::setLight);
  serve("set_physics", "ignition.msgs.Physics", &EditServices::setPhysics);
  serve("wheel_slip", "ignition.msgs.WheelSlipParametersCmd", &EditServices::setWheelSlip);
  serve("level/set_performer", "ignition.msgs.StringMsg", &EditServices::setPerformer);
  lights_ = simulation.transport().node().subscribe(nameOf("light_config"), "ignition.msgs.Light",
                                                    [this](const Message& light) {
                                                      if (const auto refusal = simulation_.changeLight(light))
                                                        editLog().warning("light_config: " + *refusal);
                                                    });
}

std::string EditServices::nameOf(const char* name) {
  return cleanTopic("/world/" + std::string(simulation_.world().name()) + "/" + name);
}

void EditServices::serve(const char* name, const char* requestType, Answer answer) {
  services_.push_back(simulation_.transport().node().serve(nameOf(name), requestType, "ignition.msgs.Boolean",
                                                           [this, answer](const Message& request, Message& reply) {
                                                             msgs::setBoolean(true, reply);
                                                             return (this->*answer)(request);
                                                           }));
}

std::optional<Vector3> EditServices::positionOf(const msgs::PlaceOnEarth& place, std::string& refusal) {
  const std::optional<TangentPlane> plane = simulation_.world().tangentPlane();
  if (plane) return plane->positionOf(place.position);
  refusal = "the world has no <spherical_coordinates>";
  return std::nullopt;
}

std::optional<Pose> EditServices::poseFor(const msgs::EntityFactory& asked, std::string& refusal) {
  if (!asked.place) return asked.pose;
  const std::optional<Vector3> position = positionOf(*asked.place, refusal);
  if (!position) return std::nullopt;
  Pose pose = asked.pose.value_or(Pose());
  pose.position = *position;
  pose.rotation = fromRollPitchYaw(0, 0, asked.place->heading) * pose.rotation;
  return pose;
}

std::optional<std::string> EditServices::insert(const msgs::EntityFactory& asked, Inserted& inserted) {
  if (!asked.unknownField.empty()) return "field '" + asked.unknownField + "' is not supported";
  const int sources =
      int{!asked.text.empty()} + int{!asked.file.empty()} + int{!asked.original.empty()} + int{asked.light != nullptr};
  if (sources != 1) return "give one of 'sdf', 'sdf_filename', 'clone_name' and 'light'";
  std::string refusal;
  const InsertOptions options{
      .name = asked.name, .pose = poseFor(asked, refusal), .allowRenaming = asked.allowRenaming};
  if (!refusal.empty()) return refusal;
  if (asked.light != nullptr) return insertLight(asked, options, inserted);
  return asked.original.empty() ? insertModelOrLight(asked, options, inserted) : insertCopy(asked, options, inserted);
}

std::optional<std::string> EditServices::insertModelOrLight(const msgs::EntityFactory& asked,
                                                            const InsertOptions& options, Inserted& inserted) {
  Diagnostics diagnostics;
  const std::optional<ModelOrLight> entity =
      asked.text.empty() ? simulation_.insertModelOrLight(asked.file, options, diagnostics)
                         : simulation_.insertModelOrLight(asked.text, "sdf", options, diagnostics);
  const std::string error = logDiagnostics(diagnostics, editLog());
  if (!entity) return error;
  if (const Model* model = std::get_if<Model>(&*entity))
    inserted.models.push_back(*model);
  else
    inserted.lights.push_back(std::get<std::string>(*entity));
  return std::nullopt;
}

std::optional<std::string> EditServices::insertCopy(const msgs::EntityFactory& asked, const InsertOptions& options,
                                                    Inserted& inserted) {
  std::string refusal;
  const std::optional<Model> original = find({.id = 0, .name = asked.original, .type = "MODEL"}, refusal);
  if (!original) return refusal;
  Diagnostics diagnostics;
  const std::optional<Model> model = simulation_.insertCopy(*original, options, diagnostics);
  const std::string error = logDiagnostics(diagnostics, editLog());
  if (!model) return error;
  inserted.models.push_back(*model);
  return std::nullopt;
}

std::optional<std::string> EditServices::insertLight(const msgs::EntityFactory& asked, const InsertOptions& options,
                                                     Inserted& inserted) {
  const Outcome<std::string> name = simulation_.insertLight(*asked.light, options);
  if (!name.value) return name.error;
  inserted.lights.push_back(*name.value);
  return std::nullopt;
}

ServiceAnswer EditServices::create(const Message& request) {
  Inserted inserted;
  return answerFor(insert(msgs::entityFactory(request), inserted));
}

// All or none: who asked would not know which ones are there.
ServiceAnswer EditServices::createMultiple(const Message& request) {
  Inserted inserted;
  for (const msgs::EntityFactory& asked : msgs::entityFactories(request)) {
    const std::optional<std::string> error = insert(asked, inserted);
    if (!error) continue;
    const std::string number = std::to_string(inserted.models.size() + inserted.lights.size() + 1);
    simulation_.remove(inserted.models);
    for (const std::string& light : inserted.lights) simulation_.removeLight({}, light);
    return ServiceAnswer::refused("number " + number + ": " + *error);
  }
  return true;
}

std::optional<Model> EditServices::find(const msgs::EntityName& asked, std::string& error) {
  const World world = simulation_.world();
  const std::optional<Model> found = asked.id != 0 ? world.model(ModelId{asked.id}) : world.model(asked.name);
  if (found && !found->parent()) return found;
  if (asked.id != 0) {
    error = "there is no top-level model with the id " + std::to_string(asked.id);
  } else if (asked.name.empty()) {
    error = "give a name or an id";
  } else if (found) {
    error = "'" + asked.name + "' is nested in another model";
  } else if (simulation_.isSetAside(asked.name)) {
    error = "model '" + asked.name + "' is in a level that is not loaded";
  } else {
    std::vector<std::string_view> names;
    const std::vector<Model> models = world.models();
    for (const Model& model : models) names.push_back(model.name());
    const std::string nearest = base::didYouMean(asked.name, names);
    error = "there is no model '" + asked.name + "'" + (nearest.empty() ? "" : "; " + nearest);
  }
  return std::nullopt;
}

ServiceAnswer EditServices::remove(const Message& request) {
  const msgs::EntityName asked = msgs::entityName(request);
  if (asked.type == "LIGHT") return answerFor(simulation_.removeLight(LightId{asked.id}, asked.name));
  if (asked.type != "MODEL" && (asked.id == 0 || asked.type != "NONE")) {
    return ServiceAnswer::refused("'type: " + asked.type + "': only models and lights can be removed");
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

/// Says where the world is, or puts a model somewhere, turned as it was.
ServiceAnswer EditServices::setPlace(const Message& request) {
  const auto [entity, place] = msgs::placeOfEntity(request);
  if (!entity) return answerFor(simulation_.world().setPlace(place.position, place.heading));
  std::string error;
  std::optional<Model> model = find(*entity, error);
  if (!model) return ServiceAnswer::refused(error);
  const std::optional<Vector3> position = positionOf(place, error);
  if (!position) return ServiceAnswer::refused(error);
  Pose pose = model->pose();
  pose.position = *position;
  return answerFor(model->setPose(pose));
}

ServiceAnswer EditServices::setLight(const Message& request) { return answerFor(simulation_.changeLight(request)); }

ServiceAnswer EditServices::setPerformer(const Message& request) {
  return answerFor(simulation_.addPerformer(msgs::string(request)));
}

ServiceAnswer EditServices::setPhysics(const Message& request) {
  const msgs::PhysicsSettings asked = msgs::physicsSettings(request);
  if (asked.stepSize == 0 && asked.realTimeFactor == 0 && !asked.gravity) {
    return ServiceAnswer::refused("give max_step_size, real_time_factor or gravity");
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

std::optional<msgs::EntityName> EditServices::findLinkOrModel(const msgs::EntityName& asked, std::string& error) {
  const World world = simulation_.world();
  if (asked.id != 0) {
    if (const auto link = world.link(LinkId{asked.id})) return msgs::EntityName{asked.id, link->scopedName(), "LINK"};
    if (const auto model = world.model(ModelId{asked.id})) {
      return msgs::EntityName{asked.id, model->scopedName(), "MODEL"};
    }
    error = "there is no link or model with the id " + std::to_string(asked.id);
    return std::nullopt;
  }
  if (const auto model = world.model(asked.name)) return msgs::EntityName{model->id().value, asked.name, "MODEL"};
  const std::size_t colons = asked.name.rfind("::");
  if (colons != std::string::npos) {
    const auto model = world.model(std::string_view(asked.name).substr(0, colons));
    const auto link = model ? model->link(std::string_view(asked.name).substr(colons + 2)) : std::nullopt;
    if (link) return msgs::EntityName{link->id().value, asked.name, "LINK"};
  }
  error = asked.name.empty() ? "give a name or an id"
                             : "there is no model '" + asked.name + "', and no link of that name (it is 'MODEL::LINK')";
  return std::nullopt;
}

/// Passes it on to the systems that let wheels slip, which take it up at the next step.
ServiceAnswer EditServices::setWheelSlip(const Message& request) {
  msgs::WheelSlip asked = msgs::wheelSlip(request);
  std::string error;
  const std::optional<msgs::EntityName> entity = findLinkOrModel(asked.entity, error);
  if (!entity) return ServiceAnswer::refused(error);
  const auto isSound = [](double compliance) { return compliance >= 0 && std::isfinite(compliance); };
  if (!isSound(asked.lateral) || !isSound(asked.longitudinal)) {
    return ServiceAnswer::refused("slip compliances must be finite and zero or more");
  }
  // on a topic that is there from the first request on only, for Fortress has none
  if (!wheelSlips_) {
    wheelSlips_ =
        simulation_.transport().node().advertise(nameOf("wheel_slip"), "ignition.msgs.WheelSlipParametersCmd");
  }
  if (!wheelSlips_.hasSubscribers()) return ServiceAnswer::refused("the world has no wheel-slip system");
  asked.entity = *entity;
  const MessagePointer command = newMessage("ignition.msgs.WheelSlipParametersCmd");
  msgs::setWheelSlip(asked, *command);
  wheelSlips_.publish(*command);
  return true;
}

}  // namespace pongsim::sim
