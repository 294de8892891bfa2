#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "core/life.hh"
#include "pongsim/system.hh"

namespace pongsim::python {

/// A system written in Python. Functions that its class does not define are not called, and cost nothing.
class PythonSystem final : public System {
 public:
  /// @param system Instance of a class derived from pongsim.System. It already knows its simulation.
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

  /// @return The bound method; null if the class does not define it.
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

/// Binds the class for step information passed to systems.
void bindSystems(py::module_& module);

}  // namespace pongsim::python
