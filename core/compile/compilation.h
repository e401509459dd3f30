// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compile/compile.h"
#include "compile/cyclic_frames.h"
#include "compile/process_image.h"
#include "compile/slave_plan.h"

namespace syncline {
struct Project;
}  // namespace syncline

namespace syncline::compiler {

/// The steps of compile(), with what they left from the run before: a run does again only what depends on something
/// that changed. The first run does everything, so that compile() and IncrementalCompiler are the same steps.
class Compilation {
 public:
  /// What changed since the last run. Slaves that are new count as changed.
  struct Changes {
    bool master = true;
    std::vector<bool> slaves;  // empty: all
    [[nodiscard]] bool slave(std::size_t i) const { return slaves.empty() || slaves[i]; }
  };

  /// `project` must be buildable, and stay where it is while its result is read.
  void run(const Project& project, const CompileOptions& options, const Changes& changes);
  [[nodiscard]] const CompileResult& result() const { return result_; }
  [[nodiscard]] CompileResult take() { return std::move(result_); }

 private:
  /// The part of a plan that depends on other slaves and on the master.
  struct Shared {
    Placement outputs, inputs;
    std::optional<SlaveDcConfig> dc;
    std::optional<std::uint32_t> status_bit;
    Nanoseconds cycle_time = 0;
    bool operator==(const Shared& other) const;
  };

  void plan_slaves(const Project& project, const Changes& changes);
  void plan_together(const Project& project, const CompileOptions& options);
  void configure(const Project& project, const CompileOptions& options, const Changes& changes);
  void fill_image();
  void collect_findings(const Project& project);

  std::vector<SlavePlan> plans_;
  std::vector<Shared> shared_;  // of the run before
  std::vector<std::vector<Finding>> slave_findings_;
  CyclicOptions cyclic_options_;
  ImageLayout image_;
  CyclicLayout cyclic_;
  CompileResult result_;
};

/// kConfiguration, kBadValue: nothing can be built from this project.
[[nodiscard]] Status check_buildable(const Project& project);

}  // namespace syncline::compiler
