// SPDX-License-Identifier: Apache-2.0
#include "compile/incremental.h"

#include "compile/compilation.h"

namespace syncline {

using compiler::Compilation;

IncrementalCompiler::IncrementalCompiler(CompileOptions options) : options_(options) {}
IncrementalCompiler::~IncrementalCompiler() = default;
IncrementalCompiler::IncrementalCompiler(IncrementalCompiler&&) noexcept = default;
IncrementalCompiler& IncrementalCompiler::operator=(IncrementalCompiler&&) noexcept = default;

Result<const CompileResult*> IncrementalCompiler::update(const Project& project) {
  if (const auto buildable = compiler::check_buildable(project); !buildable) {
    compilation_.reset();
    return tl::unexpected(buildable.error());
  }
  Compilation::Changes changes;
  if (!compilation_) {
    compilation_ = std::make_unique<Compilation>();
    project_ = project;
    changed_slaves_ = project.slaves.size();
  } else {
    changes.master = !(project_.master == project.master);
    if (changes.master) project_.master = project.master;
    project_.name = project.name;
    const std::size_t known = project_.slaves.size();
    project_.slaves.resize(project.slaves.size());
    changes.slaves.assign(project.slaves.size(), false);
    changed_slaves_ = 0;
    for (std::size_t i = 0; i < project.slaves.size(); ++i) {
      const bool changed = i >= known || !(project_.slaves[i] == project.slaves[i]);
      if (!changed) continue;
      project_.slaves[i] = project.slaves[i];
      changes.slaves[i] = true;
      ++changed_slaves_;
    }
  }
  compilation_->run(project_, options_, changes);
  return &compilation_->result();
}

}  // namespace syncline
