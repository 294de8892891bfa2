#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "core/life.hh"
#include "pongsim/system.hh"

namespace pongsim::python {

/// A system in Python among those of the world. A function that its class does not have is not called, and costs
/// nothing.
class PythonSystem final : public System {
 public:
  /// @param system Of a class derived from pongsim.System. It knows its simulation already.
  PythonSystem(Life& life, py::object system);
  ~PythonSystem() override;

  void declare(Declaration& declaration) override;
  void configure(const SystemContext& context) override;
  void preUpdate(const StepInfo& info) override { call(preUpdate_, &info); }
  void update(const StepInfo& info) override { call(update_, &info); }
  void postUpdate(const StepInfo& info) override { call(postUpdate_, &info); }
  void reset() override;
  void worldChanged() override { call(worldChanged_, nullptr); }
  void transfer(StateArchive& archive) override;

 private:
  using Method = std::shared_ptr<Kept>;

  /// @return The bound function; null where the class does not have its own.
  Method own(const char* name) const;
  void call(const Method& method, const StepInfo* info);
  template <class Work>
  void guarded(Work work);

  Life& life_;
  Method self_;
  Method preUpdate_;
  Method update_;
  Method postUpdate_;
  Method reset_;
  Method worldChanged_;
  Method save_;
  Method restore_;
};

/// Adds the class of what a system is told of a step.
void bindSystems(py::module_& module);

}  // namespace pongsim::python
