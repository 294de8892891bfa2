#include <csignal>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "pongsim/system.hh"

namespace {

/// Fails in its tenth step, or when a message tells it to.
class Misbehaving : public pongsim::System {
 public:
  void declare(pongsim::Declaration& declaration) override {
    declaration.is("Misbehaves.", pongsim::Declaration::Place::kModel);
    declaration.parameter("fault", &fault_, "", "what it does").oneOf({"throw", "nan", "crash", "message"});
  }

  void configure(const pongsim::SystemContext& context) override {
    model_ = context.model;
    told_ = context.node.subscribe("/misbehave", "ignition.msgs.Empty",
                                   [](const pongsim::Message&) { throw std::runtime_error("told to"); });
    publisher_ = context.node.advertise("/misbehave", "ignition.msgs.Empty");
  }

  void preUpdate(const pongsim::StepInfo& info) override {
    if (info.iteration != 10) return;
    if (fault_ == "throw") throw std::runtime_error("no more");
    if (fault_ == "nan") model_->joints().at(0).setVelocityTarget(std::numeric_limits<double>::quiet_NaN());
    if (fault_ == "crash") std::raise(SIGSEGV);
    if (fault_ == "message") publisher_.publish(*pongsim::newMessage("ignition.msgs.Empty"));
  }

 private:
  std::string fault_;
  std::optional<pongsim::Model> model_;
  pongsim::Subscription told_;
  pongsim::Publisher publisher_;
};

}  // namespace

PONGSIM_EXPORT_SYSTEM(Misbehaving, "test::Misbehaving");
