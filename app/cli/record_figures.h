// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "app/cli/record_range.h"

namespace syncline::cli {

class Context;

struct FiguresOptions {
  std::string file;
  RecordRange range;
  std::vector<std::string> signals;  // keys; empty: all that have a value
  bool json = false;
};

/// What the overview shows of a recording, and each signal as numbers; of a range, or since the run was armed.
void show_figures(Context& context, const FiguresOptions& options);

}  // namespace syncline::cli
