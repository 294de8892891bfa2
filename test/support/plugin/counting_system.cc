#include "pongsim/system.hh"

namespace {

class Counting : public pongsim::System {
 public:
  void declare(pongsim::Declaration& declaration) override {
    declaration.is("Counts steps.", pongsim::Declaration::Place::kAnywhere);
    declaration.parameter("from", &count_, "", "where it begins");
  }
  void configure(const pongsim::SystemContext&) override {}
  void preUpdate(const pongsim::StepInfo&) override { ++count_; }

 private:
  int count_ = 3;
};

}  // namespace

PONGSIM_EXPORT_SYSTEM(Counting, "test::Counting", "test::Counter");
