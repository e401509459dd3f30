// SPDX-License-Identifier: Apache-2.0
#include "ui/session/diagnosis_reader.h"

#include "ui/session/slave_requests.h"

namespace syncline::ui {
namespace {

namespace of_history = diagnosis_history;
constexpr std::int64_t kObjectDoesNotExist = 0x06020000;  // SDO abort code (ETG.1000.6, table 41)

bool refused(const RequestOutcome& outcome) {
  const auto& error = outcome.answer.error;
  return error && error->code == ErrorCode::kSdoAbort;
}

}  // namespace

DiagnosisReader::DiagnosisReader(SlaveRequests& requests, QObject* parent) : QObject(parent), requests_(requests) {}

void DiagnosisReader::start(std::uint16_t slave) {
  cancel();
  running_ = true;
  slave_ = slave;
  rounds_ = 0;
  header_ = {};
  ask(0, [this](const RequestOutcome& outcome) { takeLast(outcome); });
}

void DiagnosisReader::cancel() {
  requests_.drop(*this);
  running_ = false;
  open_ = 0;
  messages_.clear();
}

void DiagnosisReader::fail(const QString& why) {
  cancel();
  Q_EMIT failed(why);
}

/// What the slave itself refuses is about that entry alone; whatever else fails ends it all.
void DiagnosisReader::ask(std::uint8_t sub_index, std::function<void(const RequestOutcome&)> what) {
  requests_.post(
      requests::SdoRead{.slave = slave_, .object = {of_history::kIndex, sub_index}}, *this,
      [this, what = std::move(what)](const RequestOutcome& outcome) {
        if (!running_) return;
        if (outcome.ok() || refused(outcome)) return what(outcome);
        fail(outcome.why);
      },
      RequestUrgency::kBackground);
}

void DiagnosisReader::takeLast(const RequestOutcome& outcome) {
  if (!outcome.ok()) {
    if (outcome.answer.error->received != kObjectDoesNotExist) return fail(outcome.why);
    cancel();
    Q_EMIT absent();
    return;
  }
  if (!header_.take(0, outcome.answer.data)) return fail(tr("Object 0x10F3 says nothing of its length."));
  readHeader();
}

void DiagnosisReader::readHeader() {
  ++rounds_;
  header_ = {.last = header_.last};
  messages_.clear();
  open_ = of_history::kFlags;
  for (std::uint8_t sub = of_history::kMaximum; sub <= of_history::kFlags; ++sub) {
    ask(sub, [this, sub](const RequestOutcome& outcome) {
      if (outcome.ok()) static_cast<void>(header_.take(sub, outcome.answer.data));  // else it stays unknown
      if (--open_ == 0) readMessages();
    });
  }
}

void DiagnosisReader::readMessages() {
  const auto places = message_places(header_);
  open_ = places.size();
  if (places.empty()) return finish();
  for (const auto sub : places) {
    ask(sub, [this, sub](const RequestOutcome& outcome) {
      if (outcome.ok()) messages_.emplace_back(sub, outcome.answer.data);
      if (--open_ == 0) lookAgain();
    });
  }
}

/// A message that came meanwhile may stand where an old one was taken for.
void DiagnosisReader::lookAgain() {
  ask(of_history::kNewest, [this](const RequestOutcome& outcome) {
    auto now = header_;
    const bool told = outcome.ok() && now.take(of_history::kNewest, outcome.answer.data);
    if (told && now.newest != header_.newest && rounds_ < kRounds) return readHeader();
    finish();
  });
}

void DiagnosisReader::finish() {
  const auto log = diagnosis_log(header_, messages_);
  cancel();
  Q_EMIT read(log);
}

}  // namespace syncline::ui
