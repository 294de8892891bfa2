#include "rendering/renderer_choice.hh"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include "rendering/egl.hh"
#include "rendering/osmesa.hh"

namespace pongsim::rendering {

namespace {

/// A card that can't draw is no reason to leave cameras out later, in the midst of a run.
Contexts openCard() {
  Contexts contexts;
  try {
    contexts.first = eglContext(loadEgl(), EglDevices::kAll);
    const Binding binding(*contexts.first);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(error.what() + std::string("; the renderer 'auto' would draw in software"));
  }
  return contexts;
}

/// A machine has what draws in software, or EGL, or both.
Contexts openAny() {
  Contexts contexts;
  try {
    contexts.first = eglContext(loadEgl(), EglDevices::kCards);
  } catch (const std::runtime_error&) {
    return {openOsmesa()};
  }
  std::string missing;
  try {
    contexts.spare = openOsmesa();
    return contexts;
  } catch (const std::runtime_error& error) {
    missing = error.what();
  }
  try {
    const Binding binding(*contexts.first);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(missing + ", and " + error.what());
  }
  return contexts;
}

}  // namespace

std::optional<RendererChoice> rendererChoice(std::string_view name) {
  if (name == "software") return RendererChoice::kSoftware;
  if (name == "egl") return RendererChoice::kEgl;
  if (name == "auto") return RendererChoice::kAuto;
  return std::nullopt;
}

Contexts openContexts() {
  const char* const said = std::getenv(kRendererVariable);
  const std::string name = said == nullptr || *said == '\0' ? "software" : said;
  const std::optional<RendererChoice> choice = rendererChoice(name);
  if (!choice) {
    throw std::runtime_error(std::string(kRendererVariable) + " is '" + name + "'; it takes auto, software or egl");
  }
  switch (*choice) {
    case RendererChoice::kEgl:
      return openCard();
    case RendererChoice::kAuto:
      return openAny();
    case RendererChoice::kSoftware:
      break;
  }
  return {openOsmesa()};
}

}  // namespace pongsim::rendering
