// SPDX-License-Identifier: Apache-2.0
#include "dc/delay_text.h"

#include <fmt/format.h>

namespace syncline {

std::string delay_warning_text(dc::DelayWarning warning, std::int64_t value) {
  const auto port = static_cast<char>('A' + (value & 3));
  switch (warning) {
    case dc::DelayWarning::kReversedCable:
      return fmt::format(
          "connected by port {} instead of A: swap its cables IN and OUT; its delay is right here, but other "
          "masters take it wrong without a word",
          port);
    case dc::DelayWarning::kNegativeHop:
      return fmt::format("the delay to it comes out negative ({} ns); 0 is taken", value);
    case dc::DelayWarning::kImplausibleHop:
      return fmt::format("the delay to it is implausible ({} ns); 0 is taken", value);
    case dc::DelayWarning::kNotIncreasing:
      return fmt::format("its delay of {} ns is not above that of the slave before it", value);
    case dc::DelayWarning::kUnexplainedPort:
      return fmt::format("port {} has a link and no slave behind it: a closed ring or another master", port);
  }
  return {};
}

}  // namespace syncline
