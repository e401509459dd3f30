// SPDX-License-Identifier: Apache-2.0
#include "master/startup/startup_message_work.h"

#include "master/mailbox/mailbox_transfer.h"
#include "reasons/brief_reason.h"

#include <fmt/format.h>

#include <utility>

namespace syncline {
StartupMessageWork::StartupMessageWork(SlaveMailbox& mailbox, std::vector<StartupMessage> messages)
    : transfer_(mailbox), response_timeout_(mailbox.port.response_timeout), messages_(std::move(messages)) {}

std::string StartupMessageWork::subject() const {
  return fmt::format("{}, {}", transfer_.mailbox()->port.name, message().name);
}

void StartupMessageWork::fail_with(const BriefError& error) {
  failed_ = true;
  result_ = fail(error.about(subject()));
}

void StartupMessageWork::begin(Nanoseconds now) {
  begun_ = true;
  unasked_ = 0;
  transfer_.set_response_timeout(message().timeout_ms == 0 ? response_timeout_ : message().timeout_ms * kMillisecond);
  if (message().answered) {
    transfer_.ask(message().type, message().data, now);
  } else {
    transfer_.tell(message().type, message().data, now);
  }
}

Datagram* StartupMessageWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  if (!begun_) begin(now);
  auto* datagram = transfer_.next(now);
  go_on(now);
  return datagram;
}

void StartupMessageWork::take(Nanoseconds now) {
  transfer_.take(now);
  go_on(now);
}

void StartupMessageWork::go_on(Nanoseconds now) {
  if (over() || !transfer_.over()) return;
  if (transfer_.failure()) return fail_with(*transfer_.failure());
  if (!message().answered) return done();
  take_message(now);
}

void StartupMessageWork::take_message(Nanoseconds now) {
  const auto answer = judge_startup_answer(message().type, transfer_.data());
  if (answer.is_answer) {
    if (!answer.refusal) return done();
    failed_ = true;
    result_ = fail(ErrorCode::kMailboxProtocol, subject(), *answer.refusal);
    return;
  }
  if (++unasked_ > kMostUnasked)
    return fail_with({.code = ErrorCode::kMailboxProtocol, .why = brief("messages without end, but no answer")});
  transfer_.receive_instead(now);
}

void StartupMessageWork::done() {
  ++index_;
  begun_ = false;
}

}  // namespace syncline
