#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gazebo_host.hh"
#include "pongsim/files/xml_text.hh"
#include "pongsim/parameters.hh"
#include "pongsim/program/gazebo_variable.hh"
#include "pongsim/system.hh"
#include "python_process.hh"
#include "world_requests.hh"

namespace pongsim {

namespace {

/// Names with a prefix lose it: the namespace may not be declared.
std::string plain(const std::string& name) { return name.substr(name.rfind(':') + 1); }

std::string xmlOf(const Element& element) {
  const std::string name = plain(element.name);
  std::string text = "<" + name;
  for (const Element::Attribute& attribute : element.attributes) {
    text += " " + plain(attribute.name) + "=\"" + xmlText(attribute.value) + "\"";
  }
  text += ">" + xmlText(element.text);
  for (const Element& child : element.children) text += xmlOf(child);
  return text + "</" + name + ">";
}

/// @return Whether it is a name of Python, or several with points between them: no path.
bool isModuleName(std::string_view name) {
  const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool isFirst = i == 0 || name[i - 1] == '.';
    if (!isLetter(name[i]) && (isFirst || (!isDigit(name[i]) && (name[i] != '.' || i + 1 == name.size()))))
      return false;
  }
  return !name.empty();
}

void appendFolders(std::string_view list, std::vector<std::string>& folders) {
  while (!list.empty()) {
    const std::string_view folder = list.substr(0, list.find(':'));
    if (!folder.empty()) folders.push_back(std::filesystem::absolute(folder).string());
    list.remove_prefix(std::min(folder.size() + 1, list.size()));
  }
}

/// @return The folder of this library, where pongsim's own systems are.
std::string ownFolder() {
  Dl_info info;
  if (::dladdr(reinterpret_cast<const void*>(&kGazeboHost), &info) == 0) return {};
  return std::filesystem::absolute(info.dli_fname).parent_path().string();
}

std::vector<std::string> moduleFolders() {
  std::vector<std::string> folders;
  for (const char* name :
       {"PONGSIM_PLUGIN_PATH", gazebo::kSystemPluginPath.fortress, gazebo::kSystemPluginPath.later, "PYTHONPATH"}) {
    if (const char* value = std::getenv(name)) appendFolders(value, folders);
  }
  appendFolders(ownFolder(), folders);
  return folders;
}

/// Runs a system for Gazebo's Python modules in a process of its own, and waits for it in each call.
class PythonSystemLoader : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is("Runs a system in Python that is written for Gazebo's modules gz.sim and gz.math.",
                   Declaration::Place::kAnywhere);
    declaration
        .parameter("module_name", &module_, "",
                   "Python module whose get_system() returns the system, in a folder of systems or of PYTHONPATH")
        .required();
    declaration.element("*", "any other element is for the module");
    declaration.usesFiles();
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    const Element& where = *context.sdf.child("module_name");
    if (!isModuleName(module_)) {
      refuse(where, "'" + module_ + "' is no name of a Python module", "write it without folder and ending");
    }
    try {
      python_ = std::make_unique<PythonProcess>(kGazeboHost, std::vector<std::string>{});
      Words load{"load", module_};
      for (std::string& folder : moduleFolders()) load.push_back(std::move(folder));
      const Words hooks = call(load);
      const auto has = [&](std::string_view name) { return std::ranges::find(hooks, name) != hooks.end(); };
      hasPreUpdate_ = has("pre_update");
      hasUpdate_ = has("update");
      hasPostUpdate_ = has("post_update");
      hasReset_ = has("reset");
      const std::uint64_t entity = context.model ? context.model->id().value : context.world.id().value;
      if (has("configure")) call({"configure", std::to_string(entity), xmlOf(context.sdf)});
    } catch (const std::runtime_error& error) {
      refuse(where, "module '" + module_ + "': " + error.what());
    }
  }

  void preUpdate(const StepInfo& info) override { update(hasPreUpdate_, "pre_update", info); }
  void update(const StepInfo& info) override { update(hasUpdate_, "update", info); }
  void postUpdate(const StepInfo& info) override { update(hasPostUpdate_, "post_update", info); }
  void reset() override { update(hasReset_, "reset", {}); }

 private:
  Words call(const Words& words) {
    return python_->call(words, [this](const Words& question) { return answerRequest(*world_, question); });
  }

  void update(bool isThere, const char* name, const StepInfo& info) {
    if (!isThere) return;
    call({name, std::to_string(info.iteration), std::to_string(info.time.count()), std::to_string(info.dt.count()),
          info.paused ? "1" : "0"});
  }

  std::string module_;
  World* world_ = nullptr;
  std::unique_ptr<PythonProcess> python_;
  bool hasPreUpdate_ = false, hasUpdate_ = false, hasPostUpdate_ = false, hasReset_ = false;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::PythonSystemLoader, "gz::sim::systems::PythonSystemLoader",
                      "ignition::gazebo::systems::PythonSystemLoader");
