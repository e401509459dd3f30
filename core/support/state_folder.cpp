// SPDX-License-Identifier: Apache-2.0
#include "support/state_folder.h"

#include <cstdlib>

namespace syncline {

std::string state_folder(const std::string& name) {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::string(state) + "/syncline/" + name;
  const char* home = std::getenv("HOME");
  return std::string(home != nullptr && *home != '\0' ? home : "/var/tmp") + "/.local/state/syncline/" + name;
}

}  // namespace syncline
