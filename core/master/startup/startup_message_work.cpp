// SPDX-License-Identifier: Apache-2.0
#include "master/startup/startup_message_work.h"

#include <fmt/format.h>

#include <utility>

#include "master/mailbox/mailbox_client.h"

namespace syncline {
namespace {

constexpr int kMostUnasked = 64;

}  // namespace

StartupMessageWork::StartupMessageWork(MailboxPort port, std::vector<StartupMessage> messages, std::uint8_t& counter,
                                       EmergencyHandler on_emergency)
    : transfer_(std::move(port), counter),
      response_timeout_(transfer_.port().response_timeout),
      messages_(std::move(messages)),
      on_emergency_(std::move(on_emergency)) {}

std::string StartupMessageWork::subject() const { return fmt::format("{}, {}", transfer_.port().name, message().name); }

void StartupMessageWork::fail_with(Error error) {
  failed_ = true;
  error.subject = subject();
  result_ = fail(std::move(error));
}

void StartupMessageWork::begin(Nanoseconds now) {
  begun_ = true;
  unasked_ = 0;
  transfer_.set_response_timeout(message().timeout_ms == 0 ? response_timeout_ : message().timeout_ms * kMillisecond);
  if (message().answered) {
    transfer_.send(message().type, message().data, now);
  } else {
    transfer_.send_only(message().type, message().data, now);
  }
}

Datagram* StartupMessageWork::next(Nanoseconds now) {
  if (over()) return nullptr;
  if (!begun_) begin(now);
  auto* datagram = transfer_.next(now);
  if (transfer_.over() && !transfer_.result()) fail_with(transfer_.result().error());  // no message can come of it
  return datagram;
}

void StartupMessageWork::take(Nanoseconds now) {
  transfer_.take(now);
  if (!transfer_.over()) return;
  if (!transfer_.result()) return fail_with(transfer_.result().error());
  if (!message().answered) return done();
  take_message(*transfer_.result(), now);
}

void StartupMessageWork::take_message(const MailboxMessage& received, Nanoseconds now) {
  if (received.type == MailboxType::kError) return fail_with(mailbox_error(subject(), received));
  if (const auto emergency = emergency_in(received); emergency && on_emergency_) on_emergency_(*emergency);
  const auto answer =
      received.type == message().type ? judge_startup_answer(received.type, received.data) : StartupAnswer{};
  if (answer.is_answer) {
    if (answer.refusal) return fail_with(Error{ErrorCode::kMailboxProtocol, {}, *answer.refusal});
    return done();
  }
  if (++unasked_ > kMostUnasked) {
    return fail_with(Error{ErrorCode::kMailboxProtocol, {}, "messages without end, but no answer"});
  }
  transfer_.await_further(now);
}

void StartupMessageWork::done() {
  ++index_;
  begun_ = false;
}

}  // namespace syncline
