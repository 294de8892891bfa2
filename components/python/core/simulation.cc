#include "core/simulation.hh"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/added_systems.hh"
#include "core/errors.hh"
#include "core/handles.hh"
#include "core/life.hh"
#include "core/memory.hh"
#include "core/message_dict.hh"
#include "core/owner.hh"
#include "core/python_system.hh"
#include "core/sensor.hh"
#include "core/state_vector.hh"
#include "core/surroundings.hh"
#include "core/topics.hh"
#include "core/values.hh"
#include "pongsim/message.hh"
#include "pongsim/program/nearest_word.hh"
#include "pongsim/scene.hh"

namespace pongsim::python {

namespace {

/// @return Whether `world` is the text of a world rather than a file's name.
bool isText(const std::string& world) { return world.find('<') != std::string::npos; }

std::unique_ptr<Owner> open(const std::string& world, std::uint64_t seed, bool loadSystems, bool strict, int threads,
                            bool levels, bool network, std::optional<int> domain, std::optional<std::string> interface,
                            const std::string& file, const py::object& plugins) {
  if (threads < 1) throw py::value_error("threads must be 1 or more, not " + std::to_string(threads));
  if (!network && (domain || interface)) throw py::value_error("domain and interface need network=True");
  std::unique_ptr<Transport> transport;
  if (network) transport = std::make_unique<Transport>(TransportOptions{true, domain, std::move(interface)});
  SimulationOptions options;
  options.seed = seed;
  options.loadSystems = loadSystems;
  options.strict = strict;
  options.threads = threads;
  options.levels = levels;
  options.transport = transport.get();
  options.systems = elementsFrom(plugins);
  Diagnostics diagnostics;
  std::unique_ptr<Simulation> simulation;
  {
    const interpreter::Released released;
    simulation = isText(world) ? Simulation::fromText(world, file, options, diagnostics)
                               : Simulation::fromFile(world, options, diagnostics);
    if (simulation) simulation->offerEdits();
  }
  if (!simulation) raiseLoadError(diagnostics.all());
  auto owner = std::make_unique<Owner>(std::make_shared<Life>(std::move(transport), std::move(simulation)));
  owner->found = diagnostics.all();
  return owner;
}

/// Raises the exception of a step; in strict mode with that of the failed system as its cause.
template <class Work>
void takeSteps(Life& life, Work work) {
  try {
    life.stepping(work);
  } catch (const py::error_already_set&) {
    throw;
  } catch (const Gone&) {
    throw;
  } catch (const std::runtime_error& error) {
    life.raiseFailure(error.what());
  }
}

void step(Owner& owner, std::int64_t count) {
  if (count < 0) throw py::value_error("a number of steps must be 0 or more, not " + std::to_string(count));
  Life& life = *owner.life;
  Simulation& simulation = life.edit("a step");
  takeSteps(life, [&] {
    if (count == 1) return simulation.step();
    for (std::int64_t i = 0; i < count && !life.mustStop(); ++i) simulation.step();
  });
}

void runUntil(Owner& owner, double seconds) {
  if (!std::isfinite(seconds) || std::abs(seconds) > 9e9) {
    throw py::value_error("run_until needs a time in seconds, finite and below 9e9");
  }
  Life& life = *owner.life;
  Simulation& simulation = life.edit("run_until");
  const Time end = fromSeconds(seconds);
  takeSteps(life, [&] {
    while (simulation.time() < end && !life.mustStop()) simulation.step();
  });
}

void reset(Owner& owner, std::optional<std::uint64_t> seed) {
  Simulation& simulation = owner.life->edit("a reset");
  owner.life->forgetPast();
  Diagnostics diagnostics;
  takeSteps(*owner.life, [&] { simulation.reset(diagnostics, seed); });
  warnOf(diagnostics.all());
}

py::bytes save(Owner& owner) {
  const std::vector<std::byte> state = owner.life->edit("saving").saveState();
  return py::bytes(reinterpret_cast<const char*>(state.data()), state.size());
}

void restore(Owner& owner, const py::bytes& state) {
  char* data = nullptr;
  Py_ssize_t size = 0;
  if (PyBytes_AsStringAndSize(state.ptr(), &data, &size) != 0) throw py::error_already_set();
  checkOutcome(owner.life->edit("restoring")
                   .restoreState({reinterpret_cast<const std::byte*>(data), static_cast<std::size_t>(size)}));
  owner.life->forgetPast();
}

void collect(const std::vector<Model>& from, std::vector<Model>& models) {
  for (const Model& model : from) {
    models.push_back(model);
    collect(model.models(), models);
  }
}

std::vector<Model> allModels(Simulation& simulation) {
  std::vector<Model> models;
  collect(simulation.world().models(), models);
  return models;
}

template <class Number>
void put(Number number, std::byte*& to) {
  std::memcpy(to, &number, sizeof(number));
  to += sizeof(number);
}

/// @return Seven numbers per model, in the order of `model_names`.
std::shared_ptr<Memory> poses(Owner& owner) {
  const std::vector<Model> models = allModels(owner.life->use());
  auto memory = std::make_shared<Memory>(models.size() * 7 * sizeof(double));
  std::byte* to = memory->bytes.data();
  for (const Model& model : models) {
    const Pose pose = model.pose();
    for (int i = 0; i < 3; ++i) put(pose.position[i], to);
    for (int i = 0; i < 4; ++i) put(pose.rotation.coeffs()[i], to);
  }
  return memory;
}

/// Calls `use(joint, axis)` for all axes of all joints.
template <class Use>
void forAxes(Simulation& simulation, Use use) {
  for (const Model& model : allModels(simulation)) {
    for (const Joint& joint : model.joints()) {
      for (int axis = 0; axis < joint.axisCount(); ++axis) use(model, joint, axis);
    }
  }
}

std::vector<std::string> modelNames(Owner& owner) {
  std::vector<std::string> names;
  for (const Model& model : allModels(owner.life->use())) names.push_back(model.scopedName());
  return names;
}

std::vector<std::string> jointNames(Owner& owner) {
  std::vector<std::string> names;
  forAxes(owner.life->use(), [&](const Model& model, const Joint& joint, int axis) {
    names.push_back(model.scopedName() + "::" + std::string(joint.name()) +
                    (axis > 0 ? "#" + std::to_string(axis) : ""));
  });
  return names;
}

/// @return A position and a velocity for each of `joint_names`.
std::shared_ptr<Memory> jointStates(Owner& owner) {
  std::vector<double> numbers;
  forAxes(owner.life->use(), [&](const Model&, const Joint& joint, int axis) {
    numbers.push_back(joint.position(axis));
    numbers.push_back(joint.velocity(axis));
  });
  auto memory = std::make_shared<Memory>(numbers.size() * sizeof(double));
  if (!numbers.empty()) std::memcpy(memory->bytes.data(), numbers.data(), memory->bytes.size());
  return memory;
}

PyModel findModel(Owner& owner, const std::string& name) {
  Simulation& simulation = owner.life->use();
  if (const auto model = simulation.world().model(name)) return {owner.life, *model};
  const std::vector<std::string> known = modelNames(owner);
  const std::vector<std::string_view> words(known.begin(), known.end());
  const std::string hint = didYouMean(name, words);
  throw py::key_error("there is no model '" + name + "'" + (hint.empty() ? "" : "; " + hint));
}

std::vector<PyModel> models(Owner& owner) {
  std::vector<PyModel> result;
  for (const Model& model : owner.life->use().world().models()) result.push_back({owner.life, model});
  return result;
}

PyModel insert(Owner& owner, py::handle given, std::string name, py::handle pose, bool allowRenaming,
               std::string nameSpace) {
  const auto source = py::module_::import("os").attr("fspath")(given).cast<std::string>();
  InsertOptions options;
  options.name = std::move(name);
  if (!pose.is_none()) options.pose = poseFrom(pose);
  options.allowRenaming = allowRenaming;
  options.nameSpace = std::move(nameSpace);
  Simulation& simulation = owner.life->edit("insertion");
  Diagnostics diagnostics;
  const auto model = isText(source) ? simulation.insertText(source, "<text>", options, diagnostics)
                                    : simulation.insertFile(source, options, diagnostics);
  if (!model) raiseLoadError(diagnostics.all());
  warnOf(diagnostics.all());
  return {owner.life, *model};
}

void remove(Owner& owner, const PyModel& model, const py::args& others) {
  std::vector<const PyModel*> given{&model};
  for (const py::handle& other : others) {
    if (!py::isinstance<PyModel>(other)) throw py::type_error("only models can be removed");
    given.push_back(&other.cast<const PyModel&>());
  }
  std::vector<Model> models;
  for (const PyModel* each : given) {
    if (each->life != owner.life) throw py::value_error("the model is from another simulation");
    models.push_back(each->inner);
  }
  checkOutcome(owner.life->edit("removal").remove(models));
}

void addSystem(Owner& owner, const std::string& name, py::object system) {
  Simulation& simulation = owner.life->edit("adding a system");
  Diagnostics diagnostics;
  auto added = std::make_unique<PythonSystem>(*owner.life, std::move(system));
  if (!simulation.addSystem(name, std::move(added), diagnostics)) {
    owner.life->raiseFailure(diagnostics.all().front().message.c_str());
  }
}

/// Adds the lights in a message of a scene, a model or a link.
void addLights(const py::dict& from, const std::string& prefix, py::dict& lights) {
  const auto each = [&](const char* field, auto use) {
    if (!from.contains(field)) return;
    for (const py::handle part : from[field]) use(part.cast<py::dict>());
  };
  const auto nameOf = [&](const py::dict& part) { return prefix + part["name"].cast<std::string>(); };
  each("light", [&](const py::dict& light) { lights[py::str(nameOf(light))] = light; });
  for (const char* field : {"link", "model"}) {
    each(field, [&](const py::dict& part) { addLights(part, nameOf(part) + "::", lights); });
  }
}

py::dict lightsIn(const py::dict& scene) {
  py::dict lights;
  addLights(scene, "", lights);
  return lights;
}

void addWatcher(Owner& owner, const std::string& filename, const std::string& name,
                const std::vector<std::pair<std::string, std::string>>& parameters) {
  Simulation& simulation = owner.life->edit("adding a system");
  Element plugin;
  plugin.name = "plugin";
  plugin.attributes = {{"filename", filename, {}}, {"name", name, {}}};
  for (const auto& [parameter, text] : parameters) {
    Element& child = plugin.children.emplace_back();
    child.name = parameter;
    child.text = text;
  }
  Diagnostics diagnostics;
  if (simulation.addWatcher(plugin, diagnostics)) return warnOf(diagnostics.all());
  raise("SystemFailed", diagnostics.all().front().message);
}

Owner* ownerIn(PyObject* self) {
  auto* instance = reinterpret_cast<py::detail::instance*>(self);
  return static_cast<Owner*>(instance->get_value_and_holder().value_ptr());
}

/// Reports the callbacks and systems that the simulation holds to the garbage collector.
void setUpCollection(PyHeapTypeObject* heapType) {
  PyTypeObject& type = heapType->ht_type;
  type.tp_flags |= Py_TPFLAGS_HAVE_GC;
  type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) -> int {
    Py_VISIT(Py_TYPE(self));
    const Owner* owner = ownerIn(self);
    return owner != nullptr && owner->life ? owner->life->traverse(visit, arg) : 0;
  };
  type.tp_clear = [](PyObject* self) -> int {
    const Owner* owner = ownerIn(self);
    if (owner != nullptr && owner->life) owner->life->release();
    return 0;
  };
}

void bindDiagnostic(py::module_& module) {
  py::class_<Diagnostic>(module, "Diagnostic", "An error or warning about a file, with its position and a hint.")
      .def_property_readonly(
          "is_error", [](const Diagnostic& self) { return self.severity == Severity::kError; },
          "True: an error, False: a warning.")
      .def_property_readonly(
          "file",
          [](const Diagnostic& self) {
            return self.position.file ? std::optional<std::string>(*self.position.file) : std::nullopt;
          },
          "The file's name as it was given; None without a file.")
      .def_property_readonly(
          "line", [](const Diagnostic& self) { return self.position.line; }, "From 1; 0: unknown.")
      .def_property_readonly(
          "column", [](const Diagnostic& self) { return self.position.column; }, "From 1; 0: unknown.")
      .def_readonly("message", &Diagnostic::message, "What is wrong, in one line.")
      .def_readonly("hint", &Diagnostic::hint, "A hint in one line, or empty.")
      .def("__str__", [](const Diagnostic& self) { return format(self); })
      .def("__repr__", [](const Diagnostic& self) { return "<pongsim.Diagnostic " + format(self) + ">"; });
}

/// Steps, reset, saved states, and the end.
void bindRun(py::class_<Owner>& simulation) {
  simulation
      .def("step", &step, py::arg("count") = 1,
           "Makes `count` steps: delivers messages, calls the systems, moves the bodies. Other Python threads run "
           "meanwhile; Ctrl-C ends it between two steps. Raises exceptions of callbacks, and SystemFailed if the "
           "simulation is strict.")
      .def("run_until", &runUntil, py::arg("time"), "Makes steps until the simulated time is at least `time` [s].")
      .def(
          "step_paused",
          [](Owner& self) {
            takeSteps(*self.life, [&, &simulation = self.life->edit("a step")] { simulation.stepPaused(); });
          },
          "Delivers messages and calls the systems with `dt` zero; nothing moves.")
      .def(
          "dispatch",
          [](Owner& self) {
            std::size_t count = 0;
            takeSteps(*self.life,
                      [&, &transport = self.life->edit("dispatch").transport()] { count = transport.dispatch(); });
            return count;
          },
          "Delivers received messages and requests without a step. Returns their number.")
      .def(
          "reset", &reset, py::arg("seed") = py::none(),
          "Resets the world to its start, with the same bits, and a new seed or the same. Inserted models are removed, "
          "removed ones return; systems and subscriptions stay.")
      .def("save", &save,
           "Returns everything that the next steps depend on, as bytes for `restore`. Messages in transit are not "
           "included.")
      .def(
          "restore", &restore, py::arg("state"),
          "Restores a saved state, from which the world continues with the same bits. Raises Refused for a state of "
          "another world, or with other models, joints or systems, and for one that is damaged or forged; then nothing "
          "has changed.")
      .def(
          "state_hash", [](Owner& self) { return self.life->use().stateHash(); },
          "A hash of all bits of the state: equal for two runs of the same world with the same seed and inputs. "
          "format(sim.state_hash(), \"016x\") is what `pongsim run --hash` prints.")
      .def(
          "close", [](Owner& self) { self.life->close(); },
          "Completes what the systems write, and ends the simulation. All its objects raise Gone afterwards. Raises "
          "SystemFailed if a file is not complete, such as a recording on a full disk; it has ended nevertheless.");
}

/// What can be read, and the settings that can be changed.
void bindProperties(py::class_<Owner>& simulation) {
  simulation
      .def_property_readonly(
          "is_closed", [](Owner& self) { return self.life->isClosed(); }, "Whether it has ended.")
      .def_property_readonly(
          "time", [](Owner& self) { return toSeconds(self.life->use().time()); }, "Simulated time since the start [s].")
      .def_property_readonly(
          "time_ns", [](Owner& self) { return self.life->use().time().count(); }, "The same in whole nanoseconds.")
      .def_property_readonly(
          "iterations", [](Owner& self) { return self.life->use().iterations(); }, "Steps since the start.")
      .def_property(
          "step_size", [](Owner& self) { return toSeconds(self.life->use().stepSize()); },
          [](Owner& self, double seconds) {
            if (!std::isfinite(seconds) || std::abs(seconds) > 1e6) throw py::value_error("a step must be at most 1 s");
            checkOutcome(self.life->edit("the step's length").setStepSize(fromSeconds(seconds)));
          },
          "Step size [s]: <max_step_size> of the world unless changed.")
      .def_property(
          "gravity", [](Owner& self) { return tupleOf(self.life->use().world().gravity()); },
          [](Owner& self, py::handle gravity) {
            checkOutcome(self.life->use().world().setGravity(vectorOf(gravity, "gravity")));
          },
          "Gravity in the world frame [m/s^2].")
      .def_property_readonly(
          "name", [](Owner& self) { return std::string(self.life->use().world().name()); }, "The world's name.")
      .def_readonly("diagnostics", &Owner::found, "Errors and warnings from loading the world, in order.")
      .def_property_readonly("models", &models, "The top-level models, in the order of the file.")
      .def_property_readonly("model_names", &modelNames, "The scoped names of all models, including nested ones.")
      .def_property_readonly("joint_names", &jointNames,
                             "\"model::joint\" for each axis that has a position; \"#1\" is appended for a second one.")
      .def_property_readonly(
          "sensor_names", [](Owner& self) { return sensorNames(*self.life); }, "The scoped names of all sensors.")
      .def_property_readonly(
          "topics",
          [](Owner& self) {
            py::dict topics;
            for (const OwnTopic& each : self.life->use().transport().node().ownTopics()) {
              topics[py::str(each.name)] = each.type;
            }
            return topics;
          },
          "The topics of this simulation, with their message types.");
}

/// Models, sensors, systems and messages.
void bindContent(py::class_<Owner>& simulation) {
  simulation
      .def("model", &findModel, py::arg("name"),
           "The model with that name, nested ones as \"outer::inner\". Raises KeyError.")
      .def("insert", &insert, py::arg("source"), py::kw_only(), py::arg("name") = "", py::arg("pose") = py::none(),
           py::arg("allow_renaming") = false, py::arg("namespace") = "",
           "Inserts the first model of a file, a model folder, or SDF or URDF text, with its systems.\n\n"
           "name: replaces its own.\n"
           "pose: of the model frame in the world, replaces the file's: a Pose, x y z, or x y z roll pitch yaw [m, "
           "rad].\n"
           "allow_renaming: use NAME_0, NAME_1 and so on if the name is taken.\n"
           "namespace: prefix of all its topics, such as \"/robot1\".\n"
           "Raises LoadError, with the position in the file.")
      .def("remove", &remove, py::arg("model"),
           "Removes top-level models with their systems and the joints connected to them: all of them or, raising "
           "Refused, none. Several at once are faster than one by one.")
      .def("_poses", &poses)
      .def("_joint_states", &jointStates)
      .def(
          "_find_sensor", [](Owner& self, const std::string& name) { return findSensor(self.life, name); },
          py::arg("name"))
      .def("_add_system", &addSystem, py::arg("name"), py::arg("system"))
      .def(
          "lights",
          [](Owner& self) {
            const MessagePointer scene = newMessage("ignition.msgs.Scene");
            Scene(self.life->use().world()).fillIn(*scene);
            return lightsIn(dictOf(*scene));
          },
          "The lights of the world and of links, by their names (\"sun\", \"model::link::lamp\"): dicts of the fields "
          "of "
          "`ignition.msgs.Light`, for `change_light`.")
      .def(
          "change_light",
          [](Owner& self, py::handle light) {
            const MessagePointer message = newMessage("ignition.msgs.Light");
            fillIn(*message, light);
            checkOutcome(self.life->edit("a change of a light").changeLight(*message));
          },
          py::arg("light"),
          "Changes a light, for cameras and `render`, until the world is reset: a dict of `lights` with other values. "
          "Raises "
          "ValueError, TypeError and Refused.")
      .def("_add_watcher", &addWatcher, py::arg("filename"), py::arg("name"), py::arg("parameters"))
      .def(
          "_open_subscription",
          [](Owner& self, const std::string& topic, py::object callback, py::object type, std::size_t length) {
            return PythonSubscription::open(self.life, topic, std::move(callback), std::move(type), length);
          },
          py::arg("topic"), py::arg("callback"), py::arg("type"), py::arg("length"))
      .def(
          "_publish",
          [](Owner& self, const std::string& topic, py::handle message, const std::string& type) {
            publish(*self.life, topic, message, type);
          },
          py::arg("topic"), py::arg("message"), py::arg("type"))
      .def(
          "_ask",
          [](Owner& self, const std::string& service, py::handle message, const std::string& type, py::handle reply,
             double timeout) { return request(self.life, service, message, type, reply, timeout); },
          py::arg("service"), py::arg("request"), py::arg("type"), py::arg("reply"), py::arg("timeout"));
}

}  // namespace

void bindSimulation(py::module_& module) {
  bindDiagnostic(module);
  py::class_<Owner> type(module, "Simulation", py::custom_type_setup(setUpCollection));
  type.def(py::init(&open), py::arg("world"), py::arg("seed"), py::arg("load_systems"), py::arg("strict"),
           py::arg("threads"), py::arg("levels"), py::arg("network"), py::arg("domain"), py::arg("interface"),
           py::arg("file"), py::arg("plugins") = py::tuple());
  bindRun(type);
  bindState(type);
  bindSurroundings(type);
  bindProperties(type);
  bindContent(type);
}

}  // namespace pongsim::python
