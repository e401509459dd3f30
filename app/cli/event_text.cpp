// SPDX-License-Identifier: Apache-2.0
#include "app/cli/event_text.h"

#include <fmt/format.h>

#include <utility>

#include "app/cli/milliseconds.h"
#include "channels/event.h"
#include "channels/event_finding.h"
#include "channels/event_name.h"
#include "channels/event_text.h"
#include "findings/finding.h"

namespace syncline::cli {

Json event_json(const Event& event, Nanoseconds start) {
  const auto finding = event_finding(event);
  auto text = finding ? event_words(event, *finding) : std::string();
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
