// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe_data_type.h"

#include <fmt/format.h>

namespace syncline::coe {

std::string esi_type_name(std::uint16_t type, unsigned bits) {
  switch (type) {
    case 0x01: return "BOOL";
    case 0x02: return "SINT";
    case 0x03: return "INT";
    case 0x04: return "DINT";
    case 0x05: return "USINT";
    case 0x06: return "UINT";
    case 0x07: return "UDINT";
    case 0x08: return "REAL";
    case 0x09: return fmt::format("STRING({})", bits / 8);
    case 0x11: return "LREAL";
    case 0x15: return "LINT";
    case 0x1B: return "ULINT";
    case 0x1E: return "BYTE";
    case 0x1F: return "WORD";
    case 0x20: return "DWORD";
    default: return bits == 1 ? "BOOL" : fmt::format("BIT{}", bits);
  }
}

}  // namespace syncline::coe
