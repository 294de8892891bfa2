#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "collada.hh"
#include "pongsim/appearance.hh"
#include "pongsim/parameters.hh"
#include "pongsim/system.hh"

namespace pongsim {

namespace {

namespace fs = std::filesystem;

/// @return A unique name in one folder for each texture file: its own, with a number if that is taken.
std::map<fs::path, std::string> textureNames(const std::vector<VisiblePart>& parts) {
  std::map<fs::path, std::string> names;
  std::set<std::string> taken;
  for (const VisiblePart& part : parts) {
    if (part.texture.empty() || names.contains(part.texture)) continue;
    std::string name = part.texture.filename().string();
    for (int i = 1; !taken.insert(name).second; ++i) {
      name = part.texture.stem().string() + "_" + std::to_string(i) + part.texture.extension().string();
    }
    names[part.texture] = name;
  }
  return names;
}

/// Writes all visuals and lights into a COLLADA file, once.
class ColladaWorldExporter : public System {
 public:
  void declare(Declaration& declaration) override {
    declaration.is(
        "Writes all visuals and lights into a COLLADA file in the first step: WORLD/meshes/WORLD.dae in the current "
        "folder, with the textures in WORLD/materials/textures.",
        Declaration::Place::kWorld);
    declaration.usesFiles();
  }

  void configure(const SystemContext& context) override {
    world_ = &context.world;
    log_ = &context.log;
    const std::string name(world_->name());
    if (name.find('/') != std::string::npos || name == "." || name == "..") {
      refuse(context.sdf, "the world's name '" + name + "' can't be used for a folder");
    }
  }

  void postUpdate(const StepInfo&) override {
    if (std::exchange(isDone_, true)) return;
    try {
      writeAll();
      log_->info("the world is exported into the folder ./" + std::string(world_->name()));
    } catch (const std::exception& error) {
      failure_ = std::string("the world can't be exported: ") + error.what();
      throw std::runtime_error(failure_);
    }
  }

  void finish() override {
    if (!failure_.empty()) throw std::runtime_error(failure_);
  }

 private:
  void writeAll() {
    Diagnostics diagnostics;
    const Appearance appearance(*world_, diagnostics);
    for (const Diagnostic& each : diagnostics.all()) log_->warning(format(each));
    std::vector<VisiblePart> parts;
    for (std::size_t i = 0; i < appearance.partCount(); ++i) parts.push_back(appearance.part(i));

    const std::string name(world_->name());
    const fs::path meshes = fs::path(name) / "meshes", textureFolder = fs::path(name) / "materials" / "textures";
    fs::create_directories(meshes);
    fs::create_directories(textureFolder);
    const std::map<fs::path, std::string> textures = textureNames(parts);
    for (const auto& [file, copy] : textures) {
      fs::copy_file(file, textureFolder / copy, fs::copy_options::overwrite_existing);
    }
    const fs::path file = meshes / (name + ".dae");
    std::ofstream stream(file, std::ios::trunc);
    writeCollada(parts, appearance.lights(), textures, stream);
    stream.close();
    if (!stream) throw std::runtime_error("'" + file.string() + "' can't be written");
  }

  World* world_ = nullptr;
  const Logger* log_ = nullptr;
  bool isDone_ = false;
  std::string failure_;
};

}  // namespace

}  // namespace pongsim

PONGSIM_EXPORT_SYSTEM(pongsim::ColladaWorldExporter, "ignition::gazebo::systems::ColladaWorldExporter",
                      "gz::sim::systems::ColladaWorldExporter");
