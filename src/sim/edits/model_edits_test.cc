#include "sim/edits/model_edits.hh"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "pongsim/simulation.hh"
#include "support/test_domain.hh"

namespace pongsim::sim {
namespace {

class ModelEditsTest : public testing::Test {
 protected:
  void SetUp() override {
    test::testDomain();
    Diagnostics diagnostics;
    simulation_ = Simulation::fromText(
        "<sdf version='1.9'><world name='w'><model name='tower'><link name='l'/><model name='top'><link name='l'/>"
        "</model></model></world></sdf>",
        "world.sdf", {.loadSystems = false}, diagnostics);
    ASSERT_NE(simulation_, nullptr);
  }

  std::unique_ptr<Simulation> simulation_;
};

TEST_F(ModelEditsTest, SayWhatOfAFileIsLeftOut) {
  const auto warningOf = [this](const std::string& content) {
    Diagnostics diagnostics;
    const auto inserted =
        simulation_->insertModelOrLight("<sdf version='1.9'>" + content + "</sdf>", "a.sdf", {}, diagnostics);
    EXPECT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(inserted.has_value(), !diagnostics.hasErrors());
    return diagnostics.all().empty() ? "" : diagnostics.all().front().message + "; " + diagnostics.all().front().hint;
  };
  EXPECT_EQ(warningOf("<light name='a' type='point'/><light name='b' type='point'/>"),
            "light 'b' is left out: the first light, 'a', is inserted; ");
  EXPECT_EQ(warningOf("<model name='c'><link name='l'/></model><model name='d'><link name='l'/></model>"),
            "model 'd' is left out: the first model, 'c', is inserted; ");
  EXPECT_EQ(warningOf("<actor name='e'/>"),
            "there is no model or light to insert; actors can only be loaded with a world");
}

TEST_F(ModelEditsTest, LeavePartsOfModelsWhereTheyAre) {
  const Model top = *simulation_->world().model("tower::top");
  Diagnostics diagnostics;
  EXPECT_FALSE(simulation_->insertCopy(top, {.name = "copy"}, diagnostics));
  EXPECT_EQ(diagnostics.all().front().message, "model 'tower::top' is part of another model");
  EXPECT_EQ(simulation_->remove(top).error, "model 'tower::top' is part of 'tower' and can't be removed alone");
}

}  // namespace
}  // namespace pongsim::sim
