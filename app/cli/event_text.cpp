// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_text.h"

#include <fmt/format.h>

#include <utility>

#include "app/cli/event_name.h"
#include "app/cli/milliseconds.h"
#include "channels/event.h"
#include "channels/event_finding.h"
#include "findings/error_text.h"
#include "findings/finding.h"

namespace syncline::cli {

namespace {

/// With the advice behind it. An error begins with its file and line where its sentence does not name them.
std::string words_of(const Event& event, const Finding& finding) {
  if (const auto* failure = event.as<events::Failure>()) return describe(failure->error);
  const auto mend = fill_finding_template(find_finding_words(finding.code)->mend, finding);
  return mend.empty() ? facts_text(finding) : fmt::format("{}. {}", facts_text(finding), mend);
}

}  // namespace

std::string event_words(const Event& event) {
  const auto finding = event_finding(event);
  return finding ? words_of(event, *finding) : std::string();
}

Json event_json(const Event& event, Nanoseconds start) {
  const auto finding = event_finding(event);
  auto text = finding ? words_of(event, *finding) : std::string();
  if (text.empty()) return nullptr;
  return {{"time_ms", milliseconds(event.time - start)},
          {"kind", event_name(event)},
          {"code", finding->code},
          {"severity", severity_name(finding->severity)},
          {"slave", event.slave < 0 ? Json(nullptr) : Json(event.slave)},
          {"text", std::move(text)}};
}

std::string event_text(const Event& event, Nanoseconds start) {
  const auto text = event_words(event);
  if (text.empty()) return {};
  return fmt::format("{:>10.3f} s  {}", static_cast<double>(event.time - start) / 1e9, text);
}

}  // namespace syncline::cli
