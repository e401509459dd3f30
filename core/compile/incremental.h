// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "compile/compile.h"
#include "config/project.h"

namespace syncline {

namespace compiler {
class Compilation;
}

/// compile() for a project that is edited: keeps the last project and its result, and does again only what an edit
/// touches. The result is always that of compile(). Not for use from several threads at once.
class IncrementalCompiler {
 public:
  explicit IncrementalCompiler(CompileOptions options = {});
  ~IncrementalCompiler();
  IncrementalCompiler(IncrementalCompiler&&) noexcept;
  IncrementalCompiler& operator=(IncrementalCompiler&&) noexcept;

  /// What changed since the last call is found by comparing. Errors as compile(), which forget what is kept. The result
  /// is valid until the next call.
  [[nodiscard]] Result<const CompileResult*> update(const Project& project);

  /// Slaves whose settings the last update() found changed.
  [[nodiscard]] std::size_t changed_slaves() const { return changed_slaves_; }

 private:
  CompileOptions options_;
  Project project_;  // plans refer to it
  std::unique_ptr<compiler::Compilation> compilation_;
  std::size_t changed_slaves_ = 0;
};

}  // namespace syncline
