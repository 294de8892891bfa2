#include "pongsim/system.hh"

namespace {

class Counting : public pongsim::System {
 public:
  void configure(const pongsim::SystemContext&) override {}
  void preUpdate(const pongsim::StepInfo&) override { ++count_; }

 private:
  int count_ = 0;
};

}  // namespace

PONGSIM_EXPORT_SYSTEM(Counting, "test::Counting", "test::Counter");
