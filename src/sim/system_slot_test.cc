#include "sim/system_slot.hh"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "description/world.hh"
#include "physics/engine.hh"
#include "pongsim/message.hh"
#include "pongsim/node.hh"
#include "world/entities.hh"
#include "world/state.hh"

namespace pongsim::sim {
namespace {

/// Runs functions that a test gives it.
class Obedient : public System {
 public:
  explicit Obedient(std::function<void()> work) : work_(std::move(work)) {}
  void configure(const SystemContext& context) override {
    subscription_ = context.node.subscribe("/do", "ignition.msgs.Empty", [this](const Message&) { work_(); });
    publisher_ = context.node.advertise("/done", "ignition.msgs.Empty");
  }
  void preUpdate(const StepInfo&) override {
    ++calls;
    work_();
  }
  int calls = 0;

 private:
  std::function<void()> work_;
  Subscription subscription_;
  Publisher publisher_;
};

class SystemSlotTest : public testing::Test {
 protected:
  void start(std::function<void()> work) {
    auto system = std::make_unique<Obedient>(std::move(work));
    system_ = system.get();
    slot_ = std::make_unique<SystemSlot>(
        SystemSlot::Parts{ModelId(), 0, "obedient", {}, transport_.node(), Random(0, "obedient"), std::move(system)},
        access_, queue_,
        [this](const SystemSlot& slot, const std::string& what) { said_.push_back(slot.name() + " " + what); });
    Diagnostics diagnostics;
    EXPECT_TRUE(slot_->start(world_, std::nullopt, std::nullopt, {}, diagnostics));
    EXPECT_TRUE(diagnostics.all().empty());
  }

  description::World description_;
  Access access_{description_};
  assets::Places places_;
  ModelEdits edits_{access_, places_, {}};
  EditQueue queue_{edits_};
  World world_{access_};
  Transport transport_{{.network = false, .domain = {}}};
  std::vector<std::string> said_;
  Obedient* system_ = nullptr;
  std::unique_ptr<SystemSlot> slot_;
};

TEST_F(SystemSlotTest, CallsASystemThatBehaves) {
  start([] {});
  slot_->preUpdate({});
  slot_->preUpdate({});
  EXPECT_EQ(system_->calls, 2);
  EXPECT_TRUE(said_.empty());
  EXPECT_EQ(slot_->topics(), std::vector<std::string>{"/done"});
}

/// A system that writes a file.
class Writer : public System {
 public:
  void declare(Declaration& declaration) override { declaration.usesFiles(); }
  void configure(const SystemContext&) override {}
};

TEST_F(SystemSlotTest, LeavesOutOneWithFilesIfItIsFromOutside) {
  for (const bool isFromOutside : {false, true}) {
    auto writer = std::make_unique<Writer>();
    Declaration declaration;
    writer->declare(declaration);
    SystemSlot slot({ModelId(),
                     0,
                     "writer",
                     {},
                     transport_.node(),
                     Random(0, "writer"),
                     std::move(writer),
                     std::move(declaration),
                     {},
                     {},
                     false,
                     isFromOutside},
                    access_, queue_, {});
    Diagnostics diagnostics;
    EXPECT_EQ(slot.start(world_, std::nullopt, std::nullopt, {}, diagnostics), !isFromOutside);
    EXPECT_EQ(diagnostics.all().size(), isFromOutside ? 1U : 0U);
  }
}

TEST_F(SystemSlotTest, SwitchesOffOneThatThrowsUntilItIsSwitchedOn) {
  start([] { throw std::runtime_error("no"); });
  slot_->preUpdate({});
  slot_->preUpdate({});
  EXPECT_EQ(system_->calls, 1);
  EXPECT_EQ(said_, std::vector<std::string>{"obedient failed in preUpdate: no"});
  slot_->switchOn(Random(0, "obedient"));
  slot_->preUpdate({});
  EXPECT_EQ(system_->calls, 2);
}

TEST_F(SystemSlotTest, SwitchesOffOneWhoseCommandMakesNoSense) {
  start([this] { access_.refuse("a command that makes no sense"); });
  slot_->preUpdate({});
  slot_->preUpdate({});
  EXPECT_EQ(system_->calls, 1);
  EXPECT_EQ(said_, std::vector<std::string>{"obedient failed in preUpdate: a command that makes no sense"});
}

TEST_F(SystemSlotTest, SwitchesOffOneThatThrowsWhereItGetsAMessage) {
  int works = 0;
  start([&works] {
    if (++works == 2) throw 7;
    throw std::runtime_error("told to");
  });
  Publisher publisher = transport_.node().advertise("/do", "ignition.msgs.Empty");
  publisher.publish(*newMessage("ignition.msgs.Empty"));
  publisher.publish(*newMessage("ignition.msgs.Empty"));
  transport_.dispatch();
  EXPECT_EQ(works, 1);
  slot_->preUpdate({});
  EXPECT_EQ(system_->calls, 0);
  EXPECT_EQ(said_, std::vector<std::string>{"obedient failed in a message or request: told to"});
}

TEST_F(SystemSlotTest, SwitchesOffOneThatThrowsAnythingWhereItGetsAMessage) {
  start([] { throw 7; });
  Publisher publisher = transport_.node().advertise("/do", "ignition.msgs.Empty");
  publisher.publish(*newMessage("ignition.msgs.Empty"));
  EXPECT_NO_THROW(transport_.dispatch());
  EXPECT_EQ(said_, std::vector<std::string>{
                       "obedient failed in a message or request: it threw something other than a std::exception"});
}

/// A system with an immediate subscription to a topic on which another system publishes in its update.
class SystemSlotAtOnce : public SystemSlotTest {
 protected:
  void startBoth(const std::function<void()>& hear) {
    publisher_ = transport_.node().advertise("/said", "ignition.msgs.Empty");
    start([this] {
      publisher_.publish(*newMessage("ignition.msgs.Empty"));
      if (speaksUp_) access_.refuse("a command of the publisher");
    });
    slots_.push_back(std::move(slot_));
    start([] {});
    subscription_ =
        slot_->node().subscribeAtOnce("/said", "ignition.msgs.Empty", [this, hear](const Message&, const Bulk*) {
          ++heard_;
          hear();
        });
    slots_.push_back(std::move(slot_));
  }
  SystemSlot& publishing() { return *slots_.front(); }
  SystemSlot& hearing() { return *slots_.back(); }

  std::vector<std::unique_ptr<SystemSlot>> slots_;
  Publisher publisher_;
  Subscription subscription_;
  int heard_ = 0;
  bool speaksUp_ = false;
};

TEST_F(SystemSlotAtOnce, IsNotCalledWhenItIsSwitchedOffOrRests) {
  startBoth([] { throw 7; });
  publishing().preUpdate({});
  publishing().preUpdate({});
  EXPECT_EQ(heard_, 1);
  EXPECT_EQ(said_, std::vector<std::string>{
                       "obedient failed in a message or request: it threw something other than a std::exception"});
  hearing().switchOn(Random(0, "obedient"));
  hearing().setResting(true);
  publishing().preUpdate({});
  EXPECT_EQ(heard_, 1);
  // nor if another thread publishes, outside of any system's call
  publisher_.publish(*newMessage("ignition.msgs.Empty"));
  EXPECT_EQ(heard_, 1);
}

TEST_F(SystemSlotAtOnce, IsBlamedForItsOwnCommandsAlone) {
  startBoth([this] { access_.refuse("a command of the hearer"); });
  publishing().preUpdate({});
  EXPECT_EQ(said_, std::vector<std::string>{"obedient failed in a message or request: a command of the hearer"});
  publishing().preUpdate({});
  EXPECT_EQ(heard_, 1);
  EXPECT_EQ(said_.size(), 1U) << "the publisher goes on";
  speaksUp_ = true;
  publishing().preUpdate({});
  EXPECT_EQ(said_.back(), "obedient failed in preUpdate: a command of the publisher");
}

TEST_F(SystemSlotTest, LetsRestOneThatUsesWhatIsGone) {
  start([] { throw Gone("the model is gone"); });
  testing::internal::CaptureStderr();
  slot_->preUpdate({});
  slot_->preUpdate({});
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "warning: obedient: stops until the next reset: the model is gone\n");
  EXPECT_EQ(system_->calls, 1);
  EXPECT_TRUE(said_.empty());
}

}  // namespace
}  // namespace pongsim::sim
