#include <ignition/msgs/double.pb.h>
#include <pongsim/parameters.hh>
#include <pongsim/system.hh>

#include <optional>
#include <string>

namespace {

/// Publishes how far a model has gone, as the meter of a car does.
class DistanceMeter : public pongsim::System {
 public:
  void declare(pongsim::Declaration& declaration) override {
    declaration.is("Publishes how far a model has gone.", pongsim::Declaration::Place::kModel);
    declaration.parameter("rate", &rate_, "Hz", "messages a simulated second; 0: one every step").atLeast(0);
    declaration.parameter("topic", &topic_, "", "where they go").otherwise("/model/M/distance");
    declaration.publishes("<topic>", "ignition.msgs.Double", "length of the way since the start [m]");
  }

  void configure(const pongsim::SystemContext& context) override {
    model_ = context.model;
    schedule_ = pongsim::Schedule(pongsim::periodOf(rate_));
    last_ = model_->pose().position;
    publisher_ = context.node.advertise<ignition::msgs::Double>(
        pongsim::topicOr(topic_, "/model/" + std::string(model_->name()) + "/distance"));
  }

  void postUpdate(const pongsim::StepInfo& info) override {
    if (info.paused) return;
    const pongsim::Vector3 position = model_->pose().position;
    distance_ += (position - last_).norm();
    last_ = position;
    // nobody listens: nothing is filled in
    if (!schedule_.isDue(info.time) || !publisher_.hasSubscribers()) return;
    message_.set_data(distance_);
    publisher_.publish(message_);
  }

  void reset() override {
    schedule_.reset();
    last_ = model_->pose().position;
    distance_ = 0;
  }

 private:
  double rate_ = 10;
  std::string topic_;
  std::optional<pongsim::Model> model_;
  pongsim::Schedule schedule_;
  pongsim::Vector3 last_ = pongsim::Vector3::Zero();
  double distance_ = 0;
  pongsim::Publisher publisher_;
  ignition::msgs::Double message_;
};

}  // namespace

PONGSIM_EXPORT_SYSTEM(DistanceMeter, "example::DistanceMeter");
