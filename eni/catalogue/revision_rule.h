// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// ETG.2000 Device/Type@CheckRevisionNo: which revisions the vendor takes for the device of an ESI entry. LW and HW are
/// the low and the high word of the revision number, G is "greater".
namespace syncline::eni {

/// `rule`: NONE, EQ, EQ_OR_G, LW_EQ, LW_EQ_HW_EQ_OR_G, HW_EQ, HW_EQ_LW_EQ_OR_G. False for a rule that is not known:
/// nobody said that such a device may stand in.
[[nodiscard]] bool revision_fits(std::string_view rule, std::uint32_t esi_revision, std::uint32_t scanned_revision);
/// "the revision or a newer one"; empty for a rule that is not known.
[[nodiscard]] std::string revision_rule_words(std::string_view rule);

}  // namespace syncline::eni
