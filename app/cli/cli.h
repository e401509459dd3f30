// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace syncline::cli {

/// Exit codes of synclinectl.
inline constexpr int kDone = 0;
inline constexpr int kAnswerIsNo = 1;  // not in sync, findings of severity error
inline constexpr int kUsage = 2;
inline constexpr int kFailed = 3;  // bus or file error

/// Where a command writes: results to `out`, messages and errors to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
};

/// The whole command line program without the process around it. `arguments` without the program name.
int run(const std::vector<std::string>& arguments, Console console);

}  // namespace syncline::cli
