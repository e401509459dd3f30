// SPDX-License-Identifier: Apache-2.0
#include "channels/event_text.h"

#include <fmt/format.h>

#include "channels/event.h"
#include "channels/event_finding.h"
#include "findings/error_text.h"
#include "findings/finding.h"

namespace syncline {

/// An error begins with its file and line where its sentence does not name them.
std::string event_words(const Event& event, const Finding& finding) {
  if (const auto* failure = event.as<events::Failure>()) return describe(failure->error);
  const auto mend = fill_finding_template(find_finding_words(finding.code)->mend, finding);
  return mend.empty() ? facts_text(finding) : fmt::format("{}. {}", facts_text(finding), mend);
}

std::string event_words(const Event& event) {
  const auto finding = event_finding(event);
  return finding ? event_words(event, *finding) : std::string();
}

}  // namespace syncline
