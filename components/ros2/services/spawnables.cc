#include "ros2/services/spawnables.hh"

#include <set>
#include <system_error>

#include "ros2/services/result.hh"

namespace pongsim::ros2 {

namespace fs = std::filesystem;
namespace si = simulation_interfaces;

namespace {

bool isModel(const fs::path& folder) {
  std::error_code ignored;
  return fs::is_regular_file(folder / "model.config", ignored);
}

/// @return The model folders inside a folder.
std::vector<fs::path> modelsIn(const fs::path& folder) {
  std::vector<fs::path> models;
  std::error_code error;
  for (fs::directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && entry != end; entry.increment(error)) {
    if (isModel(entry->path())) models.push_back(entry->path());
  }
  return models;
}

}  // namespace

si::srv::GetSpawnables::Response spawnables(const std::vector<fs::path>& folders,
                                            const std::vector<std::string>& sources,
                                            const std::function<std::optional<fs::path>(const std::string&)>& resolve) {
  std::set<std::string> addresses;
  for (const fs::path& folder : folders) {
    for (const fs::path& model : modelsIn(folder)) addresses.insert("model://" + model.filename().string());
  }
  std::string unknown;
  for (const std::string& source : sources) {
    const std::optional<fs::path> folder = resolve(source);
    std::error_code error;
    if (!folder || !fs::is_directory(*folder, error)) {
      unknown += (unknown.empty() ? "no folder: '" : ", '") + source + "'";
      continue;
    }
    if (isModel(*folder)) addresses.insert(fs::absolute(*folder, error).string());
    for (const fs::path& model : modelsIn(*folder)) addresses.insert(fs::absolute(model, error).string());
  }
  si::srv::GetSpawnables::Response response;
  response.result = {Result::kResultOk, unknown};
  for (const std::string& address : addresses) {
    si::Spawnable spawnable;
    spawnable.entity_resource.uri = address;
    response.spawnables.push_back(spawnable);
  }
  return response;
}

}  // namespace pongsim::ros2
