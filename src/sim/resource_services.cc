#include "sim/resource_services.hh"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "msgs/control/control_messages.hh"

namespace pongsim::sim {

namespace {

constexpr std::string_view kPaths = "ignition.msgs.StringMsg_V";
constexpr std::string_view kPath = "ignition.msgs.StringMsg";
constexpr std::string_view kNothing = "ignition.msgs.Empty";

}  // namespace

ResourceServices::ResourceServices(Simulation& simulation, FolderAdded folderAdded)
    : simulation_(simulation), folderAdded_(std::move(folderAdded)) {
  Node node = simulation.transport().node();
  publisher_ = node.advertise("/gazebo/resource_paths", kPaths);
  get_ = node.serve("/gazebo/resource_paths/get", kNothing, kPaths, [this](const Message&, Message& reply) {
    fillIn(reply);
    return true;
  });
  add_ = node.serve("/gazebo/resource_paths/add", kPaths, kNothing,
                    [this](const Message& request, Message&) { return add(request); });
  resolve_ = node.serve("/gazebo/resource_paths/resolve", kPath, kPath,
                        [this](const Message& request, Message& reply) { return resolve(request, reply); });
}

ServiceAnswer ResourceServices::add(const Message& request) {
  const std::vector<std::string> folders = msgs::strings(request);
  if (folders.empty()) return ServiceAnswer::refused("the request contains no folder");
  // adds all folders or none
  for (const std::string& folder : folders) {
    std::error_code error;
    // the same message whether the folder exists or not, so that a request can't probe for it
    if (!std::filesystem::is_directory(folder, error) || !simulation_.isInReach(folder))
      return ServiceAnswer::refused("'" + folder + "' is not a folder in the world's folder or in those of " +
                                    "PONGSIM_RESOURCE_PATH");
  }
  for (const std::string& folder : folders) {
    const Outcome<void> added = simulation_.addResourceFolder(folder);
    if (!added) return ServiceAnswer::refused(added.error);
    folderAdded_(folder);
  }
  const MessagePointer message = newMessage(kPaths);
  fillIn(*message);
  publisher_.publish(*message);
  return true;
}

ServiceAnswer ResourceServices::resolve(const Message& request, Message& reply) {
  const std::string address = msgs::string(request);
  const std::optional<std::filesystem::path> found = simulation_.resolve(address);
  // the same message whether the file exists or not, so that a request can't probe for it
  if (!found || !simulation_.isInReach(*found))
    return ServiceAnswer::refused("there is no '" + address + "' in the folders with models");
  msgs::setString(found->string(), reply);
  return true;
}

void ResourceServices::fillIn(Message& stringMsgV) const {
  for (const std::filesystem::path& folder : simulation_.resourceFolders()) {
    msgs::addString(folder.string(), stringMsgV);
  }
}

}  // namespace pongsim::sim
