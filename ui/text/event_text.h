// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDateTime>
#include <QString>
#include <optional>

#include "findings/finding.h"

namespace syncline {
struct Error;
struct Event;
struct NetworkConfig;
struct Project;
}  // namespace syncline

namespace syncline::ui {

struct Message;

/// The line of the message window for an event of the master; empty for those that only report progress.
[[nodiscard]] std::optional<Message> messageOf(const Event& event, const Project& project);
/// The same of a bus that runs: its slaves have the names of its configuration, whatever is edited meanwhile.
[[nodiscard]] std::optional<Message> messageOf(const Event& event, const NetworkConfig& running);
[[nodiscard]] Message messageOf(const Finding& finding, const Project& project);
[[nodiscard]] Message messageOf(const Error& error, Severity severity, const QString& source);
/// What an event says, in a line among others that tells whose it is: without its slave and without advice. Empty as
/// above.
[[nodiscard]] QString briefText(const Event& event);
/// DC-epoch time (host clock of the event) as a date, local time zone.
[[nodiscard]] QDateTime dateTimeOf(Nanoseconds dc_time);

}  // namespace syncline::ui
