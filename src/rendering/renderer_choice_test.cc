#include "rendering/renderer_choice.hh"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "rendering/osmesa.hh"
#include "support/environment_variable.hh"

namespace pongsim::rendering {
namespace {

using pongsim::test::EnvironmentVariable;

/// @return Whether it draws, and has a spare context; otherwise the reason.
std::string openedWith(const std::string& name) {
  const EnvironmentVariable variable(kRendererVariable, name);
  try {
    const Contexts contexts = openContexts();
    return std::string("draws") + (contexts.spare == nullptr ? "" : ", with a spare");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(RendererChoice, HasThreeNames) {
  EXPECT_EQ(rendererChoice("software"), RendererChoice::kSoftware);
  EXPECT_EQ(rendererChoice("egl"), RendererChoice::kEgl);
  EXPECT_EQ(rendererChoice("auto"), RendererChoice::kAuto);
  EXPECT_EQ(rendererChoice("EGL"), std::nullopt);
  EXPECT_EQ(openedWith("vulkan"), "PONGSIM_RENDERER is 'vulkan'; it takes auto, software or egl");
}

TEST(RendererChoice, IsOfWhatIsInstalled) {
  const std::string software = openedWith("software"), egl = openedWith("egl");
  EXPECT_EQ(openedWith(""), software);
  if (software != "draws") {
    EXPECT_NE(software.find("(apt-get install libosmesa6)"), std::string::npos) << software;
    GTEST_SKIP() << software;
  }
  EXPECT_TRUE(openedWith("auto").starts_with("draws"));
  if (egl == "draws") {
    EXPECT_EQ(openedWith("auto"), "draws, with a spare");
  } else {
    EXPECT_NE(egl.find("; the renderer 'auto' would draw in software"), std::string::npos) << egl;
  }
}

}  // namespace
}  // namespace pongsim::rendering
