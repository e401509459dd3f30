// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "reasons/reason.h"
#include "support/types.h"

namespace syncline {

/// One figure of the evidence. The name is that of its placeholder in the finding's words and of its JSON field.
struct Figure {
  enum class Unit : std::uint8_t {
    kCount,        // how many; a balance may be below 0
    kTimes,        // "once", "3 times"
    kNanoseconds,  // four digits: a figure that was measured
    kTime,         // all digits: one that was set
    kMoment,       // kMoment: ns since the run began, or what the finder counts from
    kPpm,          // value in thousandths
    kSlave,        // position; `other` is the last one of a range, or the same; -1 the host, -2 nobody; `text` its name
    kSlaves,       // each of several: `text` are their positions, "3 to 17, 19"
    kPort,
    kHex16,
    kHex32,
    kHex,  // small letters, `other` digits
    kAlStatus,
    kAlCode,  // AL status code with its meaning
    kText,    // somebody's own: a name, a file, a command
    kPhrase,  // ours: known to the translations
    kAside,   // a phrase behind a colon; nothing when it is empty
    kNumber,  // names something (a station address, a line) as others write it: no language groups its digits
  };
  std::string_view name;
  Unit unit = Unit::kCount;
  std::int64_t value = 0, other = 0;
  std::string text{};  // kText, kPhrase, kAside, kSlave, kSlaves; kCount, kTimes: "at least" when it is not empty
  Reason reason{};     // kPhrase, kAside: what stands there instead of `text`
  bool operator==(const Figure&) const = default;
};

/// A figure in English and engineering units.
[[nodiscard]] std::string figure_text(const Figure& figure);
/// "250 us", "62.5 us", "1.000125 ms": all digits, in the unit that suits the size.
[[nodiscard]] std::string exact_time_text(Nanoseconds time);

}  // namespace syncline
