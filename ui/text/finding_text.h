// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <span>
#include <string_view>
#include <vector>

namespace syncline {
struct Finding;
class Reason;
}  // namespace syncline

namespace syncline::ui {

/// What was seen and why, in the user's language.
[[nodiscard]] QString findingText(const Finding& finding);
/// The same without the slave in front of it ("Slave 3: ..."), for who has said whose it is.
[[nodiscard]] QString findingTextWithoutSubject(const Finding& finding);
/// What to do; empty where nothing is to be done.
[[nodiscard]] QString findingAdvice(const Finding& finding);

/// Both, one behind the other.
[[nodiscard]] QString findingWhole(const Finding& finding);

/// Why something failed or is refused (Error::detail): its row in the user's language, others' texts as they are.
[[nodiscard]] QString reasonText(const Reason& reason);

/// One of finding_phrases() in the user's language.
[[nodiscard]] QString phraseText(std::string_view phrase);

/// Key of the setting that would mend it, "slave.3.dc.sync0.shift_us"; empty where there is none.
[[nodiscard]] QString findingKey(const Finding& finding);

/// "Slaves 3 to 17, 19"
[[nodiscard]] QString slavesText(std::span<const int> positions);

/// The sentences and phrases that every translation has to know (context "Finding" of translations/words).
[[nodiscard]] std::vector<std::string_view> translatableFindings();

}  // namespace syncline::ui
