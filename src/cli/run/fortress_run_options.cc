#include "cli/run/fortress_run_options.hh"

#include <CLI/App.hpp>
#include <string_view>

#include "cli/options/number_option.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

namespace {

/// @param engine Nothing is checked without one.
void checkRenderEngine(const char* option, const std::optional<std::string>& engine) {
  if (!engine) return;
  std::string_view name = *engine;
  // "ignition-rendering-ogre2", "gz-rendering-ogre2", "gz-rendering8-ogre2"
  if (name.starts_with("ignition-rendering") || name.starts_with("gz-rendering")) {
    name.remove_prefix(name.rfind('-') + 1);
  }
  if (name == "ogre" || name == "ogre2") return;
  throw UsageError("there is no render engine '" + *engine + "' for '" + option + "'",
                   "leave it out: cameras use pongsim's own renderer instead of ogre and ogre2");
}

/// @param backend Nothing is checked without one.
void checkBackend(const char* option, const std::optional<std::string>& backend) {
  if (!backend || *backend == "opengl" || *backend == "vulkan" || *backend == "metal") return;
  throw UsageError("'" + *backend + "' is no backend for '" + option + "'", "Gazebo knows opengl, vulkan and metal");
}

void checkInitialTime(const std::optional<std::string>& time) {
  constexpr const char* kOption = "--initial-sim-time";
  if (!time || numberFromZero(kOption, *time, "a number of seconds") == 0) return;
  throw UsageError("every world starts at 0 s: there is no '" + std::string(kOption) + "'", "leave it out");
}

}  // namespace

void FortressRunOptions::addTo(CLI::App& run) {
  const auto addFlag = [&run](const char* name, bool& target) {
    run.add_flag(name, target)->disable_flag_override()->group("");
  };
  const auto add = [&run](const char* name, std::optional<std::string>& target) {
    run.add_option_function<std::string>(name, [&target](const std::string& text) { target = text; })->group("");
  };
  addFlag("-s", isServer_);
  addFlag("-g", isGui_);
  addFlag("--headless-rendering", isHeadless_);
  add("--gui-config", guiConfig_);
  add("--physics-engine", physicsEngine_);
  add("--render-engine", renderEngine_);
  add("--render-engine-gui", guiEngine_);
  add("--render-engine-server", serverEngine_);
  addFlag("--wait-for-assets", waitsForAssets_);
  add("--render-engine-api-backend", backend_);
  add("--render-engine-gui-api-backend", guiBackend_);
  add("--render-engine-server-api-backend", serverBackend_);
  add("--initial-sim-time", initialTime_);
  add("--network-role", role_);
  add("--network-secondaries", secondaries_);
}

std::vector<std::string> FortressRunOptions::check() const {
  // as in Fortress, -s takes precedence over -g
  if (isGui_ && !isServer_) {
    throw UsageError("'-g' is not supported: pongsim has no GUI", "'pongsim view' draws a running world");
  }
  if (role_ || secondaries_) {
    throw UsageError("one process runs the whole world: there is no '" +
                         std::string(role_ ? "--network-role" : "--network-secondaries") + "'",
                     "leave it out; '--threads' uses more cores, '--levels' loads only levels near performers");
  }
  checkRenderEngine("--render-engine", renderEngine_);
  checkRenderEngine("--render-engine-server", serverEngine_);
  checkBackend("--render-engine-api-backend", backend_);
  checkBackend("--render-engine-gui-api-backend", guiBackend_);
  checkBackend("--render-engine-server-api-backend", serverBackend_);
  checkInitialTime(initialTime_);
  std::vector<std::string> sentences;
  if (physicsEngine_) sentences.emplace_back("'--physics-engine' has no effect: pongsim has its own engine");
  for (const auto& [option, isGiven] :
       {std::pair("--gui-config", guiConfig_.has_value()), std::pair("--render-engine-gui", guiEngine_.has_value()),
        std::pair("--render-engine-gui-api-backend", guiBackend_.has_value())}) {
    if (isGiven && !isServer_) {
      sentences.push_back("'" + std::string(option) + "' has no effect: pongsim has no GUI");
    }
  }
  return sentences;
}

}  // namespace pongsim::cli
