// SPDX-License-Identifier: Apache-2.0
#include "ui/session/dictionary_reader.h"

#include <algorithm>
#include <utility>

#include "ui/session/slave_requests.h"

namespace syncline::ui {

DictionaryReader::DictionaryReader(SlaveRequests& requests, QObject* parent) : QObject(parent), requests_(requests) {}

void DictionaryReader::start(std::uint16_t slave, coe::ObjectListType list) {
  cancel();
  running_ = true;
  slave_ = slave;
  objects_ = done_ = 0;
  ask(requests::ObjectListRead{slave, list}, [this](const RequestOutcome& outcome) {
    const auto* told =
        outcome.answer.information ? std::get_if<coe::ObjectList>(&*outcome.answer.information) : nullptr;
    if (outcome.ok() && told != nullptr) return takeList(*told);
    end();
    Q_EMIT failed(outcome.ok() ? tr("The slave does not tell its objects.") : outcome.why);
  });
}

void DictionaryReader::cancel() {
  requests_.drop(*this);
  end();
}

void DictionaryReader::end() {
  running_ = false;
  pending_.clear();
}

/// What the slave itself refuses is about that object alone; whatever else fails ends it all, because what comes after
/// would be missing as if it were not there.
void DictionaryReader::ask(SlaveRequest request, std::function<void(const RequestOutcome&)> what) {
  const auto done = [this, what = std::move(what)](const RequestOutcome& outcome) {
    if (!running_) return;
    const auto& error = outcome.answer.error;
    if (outcome.ok() || (error && error->code == ErrorCode::kSdoAbort)) return what(outcome);
    cancel();
    Q_EMIT failed(outcome.why);
  };
  requests_.post(std::move(request), *this, done, RequestUrgency::kBackground);
}

void DictionaryReader::takeList(const coe::ObjectList& list) {
  auto indices = list.indices;
  std::ranges::sort(indices);
  // Not std::ranges::unique: clang 14 cannot compile what libstdc++ 12 makes of it.
  indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
  objects_ = static_cast<int>(indices.size());
  Q_EMIT listed(indices);
  Q_EMIT progressed(0, objects_);
  for (const auto index : indices) {
    ask(requests::ObjectRead{slave_, index}, [this, index](const RequestOutcome& outcome) {
      const auto* told =
          outcome.answer.information ? std::get_if<coe::ObjectDescription>(&*outcome.answer.information) : nullptr;
      if (outcome.ok() && told != nullptr) return takeObject(*told);
      pending_[index].object.index = index;
      complete(index);
    });
  }
  if (indices.empty()) {
    end();
    Q_EMIT finished();
  }
}

void DictionaryReader::takeObject(const coe::ObjectDescription& told) {
  auto& pending = pending_[told.index];
  pending.object.index = told.index;
  pending.object.name = QString::fromStdString(told.name);
  pending.object.single = told.code == coe::ObjectCode::kVariable && told.max_sub_index == 0;
  pending.last = told.max_sub_index;
  pending.repeat_last = told.code == coe::ObjectCode::kArray && told.max_sub_index > kLongArray;
  const int asked = pending.repeat_last ? 1 : told.max_sub_index;
  pending.open = asked + 1;
  constexpr std::uint8_t kAll =
      coe::value_info::kUnitType | coe::value_info::kDefault | coe::value_info::kMinimum | coe::value_info::kMaximum;
  for (int sub = 0; sub <= asked; ++sub) {
    ask(requests::EntryRead{slave_, told.index, static_cast<std::uint8_t>(sub), kAll},
        [this, index = told.index](const RequestOutcome& outcome) {
          const auto& information = outcome.answer.information;
          takeEntry(index, outcome.ok() && information ? std::get_if<coe::EntryDescription>(&*information) : nullptr);
        });
  }
}

/// Gaps between the sub-indices of a record are usual.
void DictionaryReader::takeEntry(std::uint16_t index, const coe::EntryDescription* told) {
  auto& pending = pending_[index];
  if (told != nullptr) pending.object.entries.push_back(entryOf(*told));
  if (--pending.open > 0) return;
  auto& entries = pending.object.entries;
  std::ranges::sort(entries, {}, &DictionaryEntry::sub_index);
  if (pending.repeat_last && !entries.empty() && entries.back().sub_index == 1) {
    for (int sub = 2; sub <= pending.last; ++sub) {
      auto next = entries[entries.size() - 1];
      next.sub_index = static_cast<std::uint8_t>(sub);
      entries.push_back(std::move(next));
    }
  }
  complete(index);
}

void DictionaryReader::complete(std::uint16_t index) {
  const auto object = std::move(pending_[index].object);
  pending_.erase(index);
  ++done_;
  Q_EMIT objectRead(object);
  Q_EMIT progressed(done_, objects_);
  if (done_ < objects_ || !running_) return;
  end();
  Q_EMIT finished();
}

}  // namespace syncline::ui
