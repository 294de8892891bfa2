#include "log/record/resources.hh"

#include <ignition/msgs/geometry.pb.h>
#include <ignition/msgs/material.pb.h>
#include <ignition/msgs/serialized_map.pb.h>

#include <algorithm>
#include <array>
#include <system_error>

#include "log/store/failure.hh"
#include "pongsim/components.hh"

namespace pongsim::log {

namespace fs = std::filesystem;
namespace im = ignition::msgs;

namespace {

bool hasAddress(std::string_view element) {
  constexpr std::array<std::string_view, 4> kAddresses{"uri", "filename", "diffuse", "normal"};
  return std::ranges::find(kAddresses, element) != kAddresses.end() || element.ends_with("_map");
}

/// @return The folder of the model that a file belongs to, if any.
std::optional<fs::path> modelFolderOf(const fs::path& file) {
  std::error_code error;
  for (fs::path folder = file.parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (fs::exists(folder / "model.config", error)) return folder;
  }
  return std::nullopt;
}

/// @return Whether a mesh beside it may refer to the file.
bool isLook(const fs::path& file) {
  constexpr std::array<std::string_view, 5> kKinds{".mtl", ".png", ".jpg", ".jpeg", ".material"};
  return std::ranges::find(kKinds, file.extension().string()) != kKinds.end();
}

}  // namespace

std::string withAddresses(std::string_view sdf, const std::function<std::string(const std::string&)>& visit) {
  std::string text;
  while (true) {
    const std::size_t open = sdf.find('<');
    const std::size_t close = open == std::string_view::npos ? open : sdf.find('>', open);
    const std::size_t next = close == std::string_view::npos ? close : sdf.find('<', close);
    if (next == std::string_view::npos) return text.append(sdf);
    const std::string_view name = sdf.substr(open + 1, close - open - 1);
    const std::string_view content = sdf.substr(close + 1, next - close - 1);
    text.append(sdf.substr(0, close + 1));
    const bool isWhole = sdf.substr(next).starts_with("</") && content.find_first_not_of(" \t\r\n") == 0;
    if (isWhole && hasAddress(name)) {
      text += visit(std::string(content));
    } else {
      text.append(content);
    }
    sdf.remove_prefix(next);
  }
}

void ResourceCopies::add(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return;
  if (const std::optional<fs::path> model = modelFolderOf(file)) {
    copy(*model);
    return;
  }
  copy(file);
  for (const fs::directory_entry& beside : fs::directory_iterator(file.parent_path(), error)) {
    if (isLook(beside.path())) copy(beside.path());
  }
}

void ResourceCopies::copy(const fs::path& from) {
  if (!done_.insert(from).second) return;
  std::error_code error;
  const fs::path to = folder_ / from.relative_path();
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::overwrite_existing, error);
  if (error) throw Failure("'" + from.string() + "' can't be copied to '" + to.string() + "': " + error.message());
}

void ResourceCopies::addAllOf(const Message& step) {
  const auto geometryType = static_cast<std::int64_t>(componentType("Geometry"));
  const auto materialType = static_cast<std::int64_t>(componentType("Material"));
  for (const auto& [id, entity] : static_cast<const im::SerializedStepMap&>(step).state().entities()) {
    im::Geometry geometry;
    im::Material material;
    const auto shape = entity.components().find(geometryType);
    if (shape != entity.components().end() && geometry.ParseFromString(shape->second.component())) {
      add(geometry.mesh().filename());
      add(geometry.heightmap().filename());
    }
    const auto look = entity.components().find(materialType);
    if (look == entity.components().end() || !material.ParseFromString(look->second.component())) continue;
    add(material.pbr().albedo_map());
    add(material.pbr().normal_map());
  }
}

}  // namespace pongsim::log
