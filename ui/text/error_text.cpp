// SPDX-License-Identifier: Apache-2.0
#include "ui/text/error_text.h"

#include <algorithm>
#include <string>

#include "eni/xml/file_warning.h"
#include "findings/error_text.h"
#include "findings/finding.h"
#include "reasons/because.h"
#include "ui/text/finding_text.h"

namespace syncline::ui {

namespace {

/// An error within a warning says its place itself.
bool says(const Reason& reason, const std::string& place) {
  return std::ranges::any_of(reason.given(),
                             [&](const Reason& one) { return one.text() == place || says(one, place); });
}

}  // namespace

QString errorText(const Error& error) { return findingWhole(finding_of(error)); }

QString warningText(const eni::FileWarning& warning) {
  const auto place = warning.line > 0 ? warning.file + ":" + std::to_string(warning.line) : warning.file;
  if (says(warning.reason, place)) return reasonText(warning.reason);
  const auto element = warning.element.empty() ? std::string() : " <" + warning.element + ">";
  return reasonText(because("{place}: {reason}", place + element, warning.reason));
}

}  // namespace syncline::ui
