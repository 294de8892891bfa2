#include "cli/options/renderer_option.hh"

#include <CLI/App.hpp>
#include <cstdlib>
#include <string>

#include "rendering/renderer_choice.hh"
#include "shared/program/failure.hh"

namespace pongsim::cli {

void addRendererOption(CLI::App& command) {
  const auto choose = [](const std::string& name) {
    if (!rendering::rendererChoice(name)) {
      throw UsageError("option '--renderer' takes auto, software or egl, not '" + name + "'");
    }
    setenv(rendering::kRendererVariable, name.c_str(), 1);
  };
  command
      .add_option_function<std::string>("--renderer", choose,
                                        "What draws: software (Mesa on the processor, the default), egl (a graphics\n"
                                        "card), or auto (a graphics card if there is one that can, else software)")
      ->type_name("NAME");
}

}  // namespace pongsim::cli
