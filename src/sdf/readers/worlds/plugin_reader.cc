#include "sdf/readers/worlds/plugin_reader.hh"

namespace pongsim::sdf {

description::Plugin readPlugin(const Element& element, const std::string& owner, Context& context) {
  description::Plugin plugin{element.attributeOr("filename", ""), element.attributeOr("name", ""), element};
  if (plugin.filename.empty()) {
    context.diagnostics.error(element.position, "a plugin of " + owner + " has no filename",
                              "write <plugin filename=\"...\" name=\"...\">");
  }
  // an empty name means the library's first class, and so does none from SDF 1.10 on
  constexpr int kNameIsOptional = 10;
  if (element.attribute("name") == nullptr && context.version < kNameIsOptional) {
    context.diagnostics.error(
        element.position, "a plugin of " + owner + " has no name",
        "its name is that of the class in the library, such as 'ignition::gazebo::systems::Physics'");
  }
  return plugin;
}

}  // namespace pongsim::sdf
