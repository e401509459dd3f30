// SPDX-License-Identifier: Apache-2.0
#include "app/cli/identity_text.h"

#include <charconv>
#include <iterator>

#include "app/cli/terminal_reason.h"
#include "config/identity.h"

namespace syncline::cli {
namespace {

constexpr std::string_view kForm = "use VENDOR:PRODUCT[:REVISION[:SERIAL]], each decimal or 0x hexadecimal";

Result<std::uint32_t> parse_number(std::string_view text, std::string_view whole) {
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  const auto digits = is_hex ? text.substr(2) : text;
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, is_hex ? 16 : 10);
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    return fail(ErrorCode::kBadValue, std::string(whole), in_terminal(kForm));
  }
  return value;
}

}  // namespace

Result<Identity> parse_identity(std::string_view text) {
  Identity identity;
  std::uint32_t* fields[] = {&identity.vendor_id, &identity.product_code, &identity.revision_no, &identity.serial_no};
  std::size_t count = 0;
  auto rest = text;
  for (;;) {
    if (count == std::size(fields)) return fail(ErrorCode::kBadValue, std::string(text), in_terminal(kForm));
    const auto colon = rest.find(':');
    const auto number = parse_number(rest.substr(0, colon), text);
    if (!number) return tl::unexpected(number.error());
    *fields[count++] = *number;
    if (colon == std::string_view::npos) break;
    rest = rest.substr(colon + 1);
  }
  if (count < 2) return fail(ErrorCode::kBadValue, std::string(text), in_terminal(kForm));
  return identity;
}

}  // namespace syncline::cli
