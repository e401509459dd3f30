// SPDX-License-Identifier: Apache-2.0
#include "compile/compile.h"

#include "compile/compilation.h"
#include "config/project.h"

namespace syncline {

Result<CompileResult> compile(const Project& project, const CompileOptions& options) {
  if (const auto buildable = compiler::check_buildable(project); !buildable) {
    return tl::unexpected(buildable.error());
  }
  compiler::Compilation compilation;
  compilation.run(project, options, {});
  return compilation.take();
}

}  // namespace syncline
