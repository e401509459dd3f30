// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace syncline {

struct Finding;
class Reason;

/// What describe() says of a finding whose row begins with a capital letter or with somebody's own text, as errors'
/// rows do, as a reason that stands in another one: the rows' words with what fills them. Figures that a language
/// writes otherwise (times, numbers) are English.
[[nodiscard]] Reason reason_of(const Finding& finding);

/// The facts alone, without a full stop where their row has none: what stands in another sentence, behind a colon.
[[nodiscard]] Reason facts_reason(const Finding& finding);

/// As reason_of_words(), of the rows of findings, too.
[[nodiscard]] std::optional<Reason> reason_of_any_words(std::string_view words, std::vector<Reason> given);

}  // namespace syncline
