#include "msgs/scene/gui_message.hh"

#include <ignition/msgs/gui.pb.h>

#include "sdf/text/print.hh"

namespace pongsim::msgs {

namespace im = ignition::msgs;

void setGui(const std::optional<Element>& gui, Message& message) {
  auto& filled = static_cast<im::GUI&>(message);
  filled.Clear();
  if (!gui) return;
  const std::string fullscreen = gui->attributeOr("fullscreen", "false");
  filled.set_fullscreen(fullscreen == "true" || fullscreen == "1");
  for (const Element* plugin : gui->childrenNamed("plugin")) {
    im::Plugin& added = *filled.add_plugin();
    added.set_name(plugin->attributeOr("name", ""));
    added.set_filename(plugin->attributeOr("filename", ""));
    added.set_innerxml(sdf::printChildren(*plugin));
  }
}

}  // namespace pongsim::msgs
