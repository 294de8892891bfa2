#include "sim/edits/edit_services.hh"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/nearest_word.hh"
#include "msgs/control/control_messages.hh"
#include "msgs/fields/number_check.hh"
#include "pongsim/commands.hh"
#include "pongsim/log.hh"
#include "pongsim/message.hh"
#include "pongsim/physical_properties.hh"
#include "sim/diagnostic_log.hh"

namespace pongsim::sim {

namespace {

const Logger& editLog() {
  static const Logger log("world");
  return log;
}

ServiceAnswer answerFor(const Outcome<void>& outcome) {
  return outcome ? ServiceAnswer(true) : ServiceAnswer::refused(outcome.error);
}

/// @return The links of the models and of those nested in them.
std::vector<Link> linksOf(const std::vector<Model>& models) {
  std::vector<Link> links;
  for (const Model& model : models) {
    const std::vector<Link> own = model.links(), nested = linksOf(model.models());
    links.insert(links.end(), own.begin(), own.end());
    links.insert(links.end(), nested.begin(), nested.end());
  }
  return links;
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
  serve("visual_config", "ignition.msgs.Visual", &EditServices::setVisual);
  serve("set_mass", "ignition.msgs.Link", &EditServices::setMass);
  serve("set_joint_position", "ignition.msgs.Joint", &EditServices::setJointPosition);
  serve("set_physics", "ignition.msgs.Physics", &EditServices::setPhysics);
  serve("wheel_slip", "ignition.msgs.WheelSlipParametersCmd", &EditServices::setWheelSlip);
  serve("level/set_performer", "ignition.msgs.StringMsg", &EditServices::setPerformer);
  lights_ = simulation.transport().node().subscribe(nameOf("light_config"), "ignition.msgs.Light",
                                                    [this](const Message& light) {
                                                      const Outcome<void> changed = simulation_.changeLight(light);
                                                      if (!changed) editLog().warning("light_config: " + changed.error);
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

Outcome<Vector3> EditServices::positionOf(const msgs::PlaceOnEarth& place) {
  const std::optional<TangentPlane> plane = simulation_.world().tangentPlane();
  if (!plane) return {std::nullopt, "the world has no <spherical_coordinates>"};
  return {plane->positionOf(place.position), {}};
}

Outcome<void> EditServices::insert(const msgs::EntityFactory& asked, Inserted& inserted) {
  if (!asked.unknownField.empty()) return {"field '" + asked.unknownField + "' is not supported"};
  const int sources =
      int{!asked.text.empty()} + int{!asked.file.empty()} + int{!asked.original.empty()} + int{asked.light != nullptr};
  if (sources != 1) return {"give one of 'sdf', 'sdf_filename', 'clone_name' and 'light'"};
  InsertOptions options{
      .name = asked.name, .pose = asked.pose, .allowRenaming = asked.allowRenaming, .isFromOutside = true};
  if (asked.place) {
    Outcome<Vector3> position = positionOf(*asked.place);
    if (!position) return {position.error};
    const Quaternion rotation = asked.pose.value_or(Pose()).rotation;
    options.pose = Pose{*position, fromRollPitchYaw(0, 0, asked.place->heading) * rotation};
  }
  if (asked.light != nullptr) return insertLight(asked, options, inserted);
  return asked.original.empty() ? insertModelOrLight(asked, options, inserted) : insertCopy(asked, options, inserted);
}

Outcome<void> EditServices::insertModelOrLight(const msgs::EntityFactory& asked, const InsertOptions& options,
                                               Inserted& inserted) {
  Diagnostics diagnostics;
  const std::optional<ModelOrLight> entity =
      asked.text.empty() ? simulation_.insertModelOrLight(asked.file, options, diagnostics)
                         : simulation_.insertModelOrLight(asked.text, "sdf", options, diagnostics);
  const std::string error = logDiagnostics(diagnostics, editLog());
  if (!entity) return {error};
  if (const Model* model = std::get_if<Model>(&*entity))
    inserted.models.push_back(*model);
  else
    inserted.lights.push_back(std::get<std::string>(*entity));
  return {};
}

Outcome<void> EditServices::insertCopy(const msgs::EntityFactory& asked, const InsertOptions& options,
                                       Inserted& inserted) {
  Outcome<Model> original = find({.id = 0, .name = asked.original, .type = "MODEL"});
  if (!original) return {original.error};
  Diagnostics diagnostics;
  const std::optional<Model> model = simulation_.insertCopy(*original, options, diagnostics);
  const std::string error = logDiagnostics(diagnostics, editLog());
  if (!model) return {error};
  inserted.models.push_back(*model);
  return {};
}

Outcome<void> EditServices::insertLight(const msgs::EntityFactory& asked, const InsertOptions& options,
                                        Inserted& inserted) {
  const Outcome<std::string> name = simulation_.insertLight(*asked.light, options);
  if (!name) return {name.error};
  inserted.lights.push_back(*name.value);
  return {};
}

ServiceAnswer EditServices::create(const Message& request) {
  Inserted inserted;
  return answerFor(insert(msgs::entityFactory(request), inserted));
}

// Inserts all or none, because a client could not tell which ones had been inserted.
ServiceAnswer EditServices::createMultiple(const Message& request) {
  Inserted inserted;
  for (const msgs::EntityFactory& asked : msgs::entityFactories(request)) {
    const Outcome<void> done = insert(asked, inserted);
    if (done) continue;
    const std::string number = std::to_string(inserted.models.size() + inserted.lights.size() + 1);
    simulation_.remove(inserted.models);
    for (const std::string& light : inserted.lights) simulation_.removeLight({}, light);
    return ServiceAnswer::refused("number " + number + ": " + done.error);
  }
  return true;
}

Outcome<Model> EditServices::find(const msgs::EntityName& asked) {
  const World world = simulation_.world();
  const std::optional<Model> found = asked.id != 0 ? world.model(ModelId{asked.id}) : world.model(asked.name);
  if (found && !found->parent()) return {found, {}};
  if (asked.id != 0) return {std::nullopt, "there is no top-level model with the id " + std::to_string(asked.id)};
  if (asked.name.empty()) return {std::nullopt, "give a name or an id"};
  if (found) return {std::nullopt, "'" + asked.name + "' is nested in another model"};
  if (simulation_.isSetAside(asked.name)) {
    return {std::nullopt, "model '" + asked.name + "' is in a level that is not loaded"};
  }
  std::vector<std::string_view> names;
  const std::vector<Model> models = world.models();
  for (const Model& model : models) names.push_back(model.name());
  const std::string nearest = base::didYouMean(asked.name, names);
  return {std::nullopt, "there is no model '" + asked.name + "'" + (nearest.empty() ? "" : "; " + nearest)};
}

ServiceAnswer EditServices::remove(const Message& request) {
  const msgs::EntityName asked = msgs::entityName(request);
  if (asked.type == "LIGHT") return answerFor(simulation_.removeLight(LightId{asked.id}, asked.name));
  if (asked.type != "MODEL" && (asked.id == 0 || asked.type != "NONE")) {
    return ServiceAnswer::refused("'type: " + asked.type + "': only models and lights can be removed");
  }
  Outcome<Model> model = find(asked);
  if (!model) return ServiceAnswer::refused(model.error);
  return answerFor(simulation_.remove(*model));
}

ServiceAnswer EditServices::setPose(const Message& request) {
  const msgs::PoseOfEntity asked = msgs::poseOfEntity(request);
  Outcome<Model> model = find(asked.entity);
  if (!model) return ServiceAnswer::refused(model.error);
  return answerFor(model->setPose(asked.pose));
}

// Sets all poses or none as far as that can be checked before: each model must exist.
ServiceAnswer EditServices::setPoses(const Message& request) {
  const std::vector<msgs::PoseOfEntity> asked = msgs::posesOfEntities(request);
  std::vector<Model> models;
  for (const msgs::PoseOfEntity& each : asked) {
    Outcome<Model> model = find(each.entity);
    if (!model) return ServiceAnswer::refused(model.error);
    models.push_back(*model);
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const Outcome<void> moved = models[i].setPose(asked[i].pose);
    if (!moved) return ServiceAnswer::refused("model '" + std::string(models[i].name()) + "': " + moved.error);
  }
  return true;
}

/// Sets the geographic position of the world's origin, or moves a model to one and keeps its orientation.
ServiceAnswer EditServices::setPlace(const Message& request) {
  const auto [entity, place] = msgs::placeOfEntity(request);
  if (!entity) return answerFor(simulation_.world().setPlace(place.position, place.heading));
  Outcome<Model> model = find(*entity);
  if (!model) return ServiceAnswer::refused(model.error);
  Outcome<Vector3> position = positionOf(place);
  if (!position) return ServiceAnswer::refused(position.error);
  Pose pose = model->pose();
  pose.position = *position;
  return answerFor(model->setPose(pose));
}

ServiceAnswer EditServices::setLight(const Message& request) { return answerFor(simulation_.changeLight(request)); }

Outcome<VisualId> EditServices::findVisual(const msgs::VisualLook& asked) {
  if (asked.id == 0 && (asked.name.empty() || (asked.link.empty() && asked.linkId == 0))) {
    return {std::nullopt, "give an id, or a name with the parent_name (MODEL::LINK) or parent_id of its link"};
  }
  for (const Link& link : linksOf(simulation_.world().models())) {
    const bool isParent = asked.id != 0 || asked.linkId == link.id().value ||
                          (asked.linkId == 0 && (asked.link == link.scopedName() || asked.link == link.name()));
    if (!isParent) continue;
    for (const Visual& visual : link.visuals()) {
      if (asked.id != 0 ? visual.id().value == asked.id : visual.name() == asked.name) return {visual.id(), {}};
    }
  }
  if (asked.id != 0) return {std::nullopt, "there is no visual with the id " + std::to_string(asked.id)};
  return {std::nullopt, "there is no visual '" + asked.name + "' in such a link"};
}

/// Changes the colours of a visual. As in Fortress, only those that are given, and nothing else of the message.
ServiceAnswer EditServices::setVisual(const Message& request) {
  const msgs::VisualLook asked = msgs::visualLook(request);
  const VisualColors& colors = asked.colors;
  if (!colors.diffuse && !colors.ambient && !colors.specular && !colors.emissive) {
    return ServiceAnswer::refused("give a colour: material { diffuse }, ambient, specular or emissive");
  }
  const Outcome<VisualId> visual = findVisual(asked);
  if (!visual) return ServiceAnswer::refused(visual.error);
  return answerFor(PhysicalProperties(simulation_.world()).setColors(*visual.value, colors));
}

Outcome<Link> EditServices::findLink(const msgs::EntityName& asked) {
  Outcome<msgs::EntityName> found = findLinkOrModel(asked);
  if (!found) return {std::nullopt, found.error};
  if (found->type != "LINK") return {std::nullopt, "'" + found->name + "' is a model; give a link"};
  return {simulation_.world().link(LinkId{found->id}), {}};
}

/// Sets the mass of a link, as if its density had changed.
ServiceAnswer EditServices::setMass(const Message& request) {
  const msgs::LinkMass asked = msgs::linkMass(request);
  if (!asked.mass) return ServiceAnswer::refused("give the mass: inertial { mass }");
  Outcome<Link> link = findLink(asked.entity);
  if (!link) return ServiceAnswer::refused(link.error);
  PhysicalProperties properties(simulation_.world());
  const double factor = properties.inertiaFactor(*link) * *asked.mass / link->mass().mass;
  return answerFor(properties.setMass(*link, *asked.mass, factor));
}

Outcome<Joint> EditServices::findJoint(const msgs::EntityName& asked) {
  const World world = simulation_.world();
  if (asked.id != 0) {
    if (const auto joint = world.joint(JointId{asked.id})) return {joint, {}};
    return {std::nullopt, "there is no joint with the id " + std::to_string(asked.id)};
  }
  const std::size_t colons = asked.name.rfind("::");
  const auto model =
      colons == std::string::npos ? std::nullopt : world.model(std::string_view(asked.name).substr(0, colons));
  const auto joint = model ? model->joint(std::string_view(asked.name).substr(colons + 2)) : std::nullopt;
  if (joint) return {joint, {}};
  if (asked.name.empty()) return {std::nullopt, "give a name or an id"};
  return {std::nullopt, "there is no joint '" + asked.name + "' (it is 'MODEL::JOINT')"};
}

ServiceAnswer EditServices::setJointPosition(const Message& request) {
  if (const auto fault = msgs::unusableNumber(request, kLargestCommand)) return ServiceAnswer::refused(*fault);
  const msgs::JointPositions asked = msgs::jointPositions(request);
  if (!asked.positions[0] && !asked.positions[1]) {
    return ServiceAnswer::refused("give a position: axis1 { position }");
  }
  Outcome<Joint> joint = findJoint(asked.entity);
  if (!joint) return ServiceAnswer::refused(joint.error);
  if (asked.positions[1] && joint->axisCount() < 2) {
    return ServiceAnswer::refused("joint '" + std::string(joint->name()) + "' has no axis2");
  }
  for (int axis : {0, 1}) {
    const std::optional<double> position = asked.positions[static_cast<std::size_t>(axis)];
    if (!position) continue;
    // what could refuse the second would have refused the first
    const Outcome<void> moved = joint->resetPosition(*position, axis);
    if (!moved) return ServiceAnswer::refused(moved.error);
  }
  return true;
}

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
  Outcome<void> done;
  // checked in seconds first, because the value may not fit `Time`
  const double longest = toSeconds(Simulation::kLongestStep);
  if (!(asked.stepSize >= 0 && asked.stepSize <= longest)) done = {"max_step_size is not between 0 and 1 s"};
  if (done && asked.stepSize != 0) done = simulation_.setStepSize(fromSeconds(asked.stepSize));
  if (done && asked.realTimeFactor != 0) done = simulation_.setRealTimeFactor(asked.realTimeFactor);
  if (done && asked.gravity) done = simulation_.world().setGravity(*asked.gravity);
  if (done) return true;
  simulation_.setStepSize(oldStep);
  simulation_.setRealTimeFactor(oldFactor);
  return ServiceAnswer::refused(done.error);
}

Outcome<msgs::EntityName> EditServices::findLinkOrModel(const msgs::EntityName& asked) {
  const World world = simulation_.world();
  if (asked.id != 0) {
    if (const auto link = world.link(LinkId{asked.id})) return {{{asked.id, link->scopedName(), "LINK"}}, {}};
    if (const auto model = world.model(ModelId{asked.id})) return {{{asked.id, model->scopedName(), "MODEL"}}, {}};
    return {std::nullopt, "there is no link or model with the id " + std::to_string(asked.id)};
  }
  if (const auto model = world.model(asked.name)) return {{{model->id().value, asked.name, "MODEL"}}, {}};
  const std::size_t colons = asked.name.rfind("::");
  if (colons != std::string::npos) {
    const auto model = world.model(std::string_view(asked.name).substr(0, colons));
    const auto link = model ? model->link(std::string_view(asked.name).substr(colons + 2)) : std::nullopt;
    if (link) return {{{link->id().value, asked.name, "LINK"}}, {}};
  }
  if (asked.name.empty()) return {std::nullopt, "give a name or an id"};
  return {std::nullopt, "there is no model '" + asked.name + "', and no link of that name (it is 'MODEL::LINK')"};
}

/// Publishes the request for the wheel-slip systems, which apply it in the next step.
ServiceAnswer EditServices::setWheelSlip(const Message& request) {
  msgs::WheelSlip asked = msgs::wheelSlip(request);
  Outcome<msgs::EntityName> entity = findLinkOrModel(asked.entity);
  if (!entity) return ServiceAnswer::refused(entity.error);
  const auto isSound = [](double compliance) { return compliance >= 0 && std::isfinite(compliance); };
  if (!isSound(asked.lateral) || !isSound(asked.longitudinal)) {
    return ServiceAnswer::refused("slip compliances must be finite and zero or more");
  }
  // the topic exists only from the first request on, because Fortress has no such topic
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
