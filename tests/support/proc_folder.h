// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/temporary_folder.h"

namespace syncline::test {

/// A folder like /proc with as many threads as a test writes.
class ProcFolder {
 public:
  /// `schedstat`: ns that it ran, ns that it waited, how often it ran. Written again it replaces what was.
  void thread(int process, int id, const std::string& name, bool kernel, int policy, int priority,
              const std::string& schedstat) const {
    const auto folder = root() / std::to_string(process) / "task" / std::to_string(id);
    std::filesystem::create_directories(folder);
    // Fields 10 to 39 are times, addresses and signals that nobody asks for here.
    std::string rest;
    for (int field = 10; field < 40; ++field) rest += " 0";
    std::ofstream(folder / "stat") << fmt::format("{} ({}) S 2 0 0 0 -1 {}{} {} {} 0\n", id, name,
                                                  kernel ? 0x00208040 : 0x00400000, rest, priority, policy);
    std::ofstream(folder / "schedstat") << schedstat << '\n';
  }
  [[nodiscard]] const std::filesystem::path& root() const { return folder_.path(); }

 private:
  TemporaryFolder folder_;
};

}  // namespace syncline::test
