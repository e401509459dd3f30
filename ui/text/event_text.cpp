// SPDX-License-Identifier: Apache-2.0
#include "ui/text/event_text.h"

#include "channels/event.h"
#include "channels/event_finding.h"
#include "config/network_config.h"
#include "config/project.h"
#include "support/result.h"
#include "ui/text/error_text.h"
#include "ui/text/finding_text.h"
#include "ui/text/glossary.h"
#include "ui/text/message.h"

namespace syncline::ui {

QDateTime dateTimeOf(Nanoseconds dc_time) {
  return QDateTime::fromMSecsSinceEpoch(kDcEpochUnixSeconds * 1000 + dc_time / kMillisecond);
}

namespace {

template <class Network>
std::optional<Message> messageIn(const Event& event, const Network& network) {
  const auto finding = event_finding(event);
  if (!finding) return std::nullopt;
  Message message{dateTimeOf(event.time), finding->severity, nodeName(network, event.slave),
                  findingWhole(*finding), event.slave,       {}};
  message.moment = event.time;
  return message;
}

}  // namespace

std::optional<Message> messageOf(const Event& event, const Project& project) { return messageIn(event, project); }
std::optional<Message> messageOf(const Event& event, const NetworkConfig& running) { return messageIn(event, running); }

QString briefText(const Event& event) {
  auto finding = event_finding(event);
  if (!finding) return {};
  // What to check of an AL status code is advice.
  if (const auto* words = find_finding_words(finding->code)) {
    if (const auto brief = sentence_of(*words, "unchecked"); !brief.empty()) finding->facts = brief;
  }
  return event.slave < 0 ? findingText(*finding) : findingTextWithoutSubject(*finding);
}

Message messageOf(const Finding& finding, const Project& project) {
  return {{},
          finding.severity,
          nodeName(project, finding.place.slave),
          findingWhole(finding),
          finding.place.slave,
          QString::fromStdString(finding.place.key)};
}

Message messageOf(const Error& error, Severity severity, const QString& source) {
  return {QDateTime::currentDateTime(), severity, source, errorText(error), -1, {}};
}

}  // namespace syncline::ui
