// SPDX-License-Identifier: Apache-2.0
#include "protocol/command.h"

#include <array>

namespace syncline {

std::string_view command_name(Command command) {
  static constexpr std::array<std::string_view, kLastCommand + 1> kNames{
      "NOP", "APRD", "APWR", "APRW", "FPRD", "FPWR", "FPRW", "BRD", "BWR", "BRW", "LRD", "LWR", "LRW", "ARMW", "FRMW"};
  const auto index = static_cast<std::size_t>(command);
  return index < kNames.size() ? kNames[index] : std::string_view("?");
}

}  // namespace syncline
