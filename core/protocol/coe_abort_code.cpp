// SPDX-License-Identifier: Apache-2.0
#include "protocol/coe_abort_code.h"

#include <algorithm>
#include <array>

#include "protocol/coe.h"

namespace syncline::coe {
namespace {

struct Row {
  std::uint32_t code;
  std::string_view text;
};

constexpr auto kCodes = std::to_array<Row>({
    {0x05030000, "toggle bit did not change"},
    {0x05040000, "SDO protocol timeout"},
    {0x05040001, "command specifier invalid or unknown"},
    {0x05040002, "block size invalid"},
    {0x05040003, "block sequence number invalid"},
    {0x05040004, "block checksum wrong"},
    {0x05040005, "out of memory"},
    {0x06010000, "access to the object not supported"},
    {0x06010001, "reading a write-only object"},
    {0x06010002, "writing a read-only object"},
    {0x06010003, "subindex cannot be written, subindex 0 must be 0 first"},
    {0x06010004, "complete access not supported"},
    {0x06010005, "object larger than the mailbox"},
    {0x06010006, "object is mapped to a PDO, download blocked"},
    {0x06020000, "object does not exist"},
    {0x06040041, "object cannot be mapped to a PDO"},
    {0x06040042, "mapped objects exceed the PDO length"},
    {0x06040043, "parameters incompatible"},
    {0x06040047, "incompatible inside the device"},
    {0x06060000, "hardware error"},
    {0x06070010, "data type or length does not match"},
    {0x06070012, "data too long"},
    {0x06070013, "data too short"},
    {0x06090011, "subindex does not exist"},
    {0x06090030, "value out of range"},
    {0x06090031, "value too high"},
    {0x06090032, "value too low"},
    {0x06090033, "configured modules differ from the detected ones"},
    {0x06090036, "maximum is below the minimum"},
    {0x060A0023, "resource not available"},
    {0x08000000, "general error"},
    {0x08000020, "data cannot be transferred or stored"},
    {0x08000021, "not possible under local control"},
    {0x08000022, "not possible in the present device state, try it in PREOP"},
    {0x08000023, "no object dictionary"},
    {0x08000024, "no data available"},
});

constexpr std::string_view kUnknownCode = "unknown abort code";

}  // namespace

std::vector<std::string_view> abort_code_texts() {
  std::vector<std::string_view> texts{kUnknownCode};
  for (const Row& row : kCodes) texts.push_back(row.text);
  return texts;
}

std::string_view abort_code_text(std::uint32_t code) {
  const auto row = std::find_if(kCodes.begin(), kCodes.end(), [code](const Row& r) { return r.code == code; });
  return row != kCodes.end() ? row->text : kUnknownCode;
}

}  // namespace syncline::coe
