// SPDX-License-Identifier: Apache-2.0
// What the page of objects asks the slave, and what it gives away.
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QTreeView>
#include <algorithm>
#include <utility>

#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/files/save_name.h"
#include "ui/models/object_filter.h"
#include "ui/models/object_model.h"
#include "ui/pages/slave_objects_page.h"
#include "ui/session/dictionary_reader.h"
#include "ui/session/watch_list.h"
#include "ui/session/workspace.h"

namespace syncline::ui {

/// Entries below a row of the filter and itself.
std::vector<coe::ObjectAddress> SlaveObjectsPage::readable(const QModelIndex& parent) const {
  std::vector<coe::ObjectAddress> all;
  if (parent.isValid()) {
    const auto source = filter_->mapToSource(parent);
    const auto* entry = model_->entry(source);
    if (entry != nullptr && entry->readable()) all.push_back(model_->address(source));
  }
  for (int row = 0; row < filter_->rowCount(parent); ++row) {
    const auto below = readable(filter_->index(row, 0, parent));
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

void SlaveObjectsPage::readSelected() {
  std::vector<coe::ObjectAddress> all;
  for (const auto& row : tree_->selectionModel()->selectedRows()) {
    for (const auto object : readable(row)) {
      if (std::ranges::find(all, object) == all.end()) all.push_back(object);
    }
  }
  if (all.empty()) return say(tr("Nothing that can be read is selected."));
  read(all);
}

void SlaveObjectsPage::readShown() { read(readable({})); }

void SlaveObjectsPage::read(const std::vector<coe::ObjectAddress>& objects) {
  if (!possible() || objects.empty() || !running()) return;
  batch_ += static_cast<int>(objects.size());
  for (const auto object : objects) readOne(object, [this](const RequestOutcome& outcome) { takeOfBatch(outcome); });
  showWork();
}

void SlaveObjectsPage::takeOfBatch(const RequestOutcome& outcome) {
  ++batch_done_;
  if (!outcome.ok()) ++batch_failed_;
  const int read = batch_done_ - batch_failed_;
  const bool over = batch_done_ >= batch_;
  if (batch_ == 1 || outcome.end == RequestEnd::kGone) {
    say(outcome.why, !outcome.ok());
  } else if (!over || batch_failed_ == 0) {
    say(tr("%1 of %2 entries").arg(read).arg(batch_));
  } else {
    say(tr("%1 of %2 entries; the others say why in their line").arg(read).arg(batch_), read == 0);
  }
  if (over) batch_ = batch_done_ = batch_failed_ = 0;
  showWork();
}

void SlaveObjectsPage::readWatched() {
  const auto watched = model_->watched();
  if (!running()) return;
  polling_ = watched.size();
  for (const auto object : watched) readOne(object, [this](const RequestOutcome&) { --polling_; });
}

void SlaveObjectsPage::readOne(coe::ObjectAddress object, SlaveRequests::Done then) {
  const auto slave = running();
  if (!slave) return;
  post(
      requests::SdoRead{.slave = slave->position, .object = object},
      [this, object, then = std::move(then)](const RequestOutcome& outcome) {
        if (outcome.ok()) {
          model_->setValue(object, outcome.answer.data, outcome.answer.time);
        } else if (outcome.end == RequestEnd::kFailed) {
          model_->setFailure(object, outcome.why);
        }
        if (then) then(outcome);
      },
      RequestUrgency::kBackground);
}

/// The master writes those in each cycle.
bool SlaveObjectsPage::mappedOutput(coe::ObjectAddress object) const {
  const auto slave = running();
  if (!slave) return false;
  const auto maps = [&](const ConfiguredPdo& one) {
    return one.direction == PdoDirection::kRx && one.pdo.sync_manager &&
           std::ranges::any_of(one.pdo.entries, [&](const PdoEntry& entry) {
             return entry.index == object.index && entry.sub_index == object.sub_index;
           });
  };
  return std::ranges::any_of(slave->config->pdos, maps);
}

void SlaveObjectsPage::write(coe::ObjectAddress object, const std::vector<std::uint8_t>& bytes) {
  const auto* entry = entryOf(object);
  if (entry == nullptr) return;
  const auto name = QStringLiteral("%1 %2").arg(objectText(object), entry->name);
  auto more = tr("The slave acts upon the new value at once.");
  if (mappedOutput(object)) {
    more += u' ' + tr("The object is in the process data: the master writes it in each cycle and will overwrite this.");
  }
  if (!mayDisturb(tr("Write %1 to %2?").arg(valueText(*entry, bytes), name), more, tr("Write"))) return;
  const auto slave = running();
  if (!slave) return;
  say(tr("%1 is written.").arg(name));
  post(requests::SdoWrite{.slave = slave->position, .object = object, .data = bytes},
       [this, object, bytes](const RequestOutcome& outcome) {
         if (!outcome.ok()) return say(outcome.why, true);
         readBack(object, bytes);
       });
}

/// A slave may take a value and make another one of it.
void SlaveObjectsPage::readBack(coe::ObjectAddress object, const std::vector<std::uint8_t>& written) {
  const auto* entry = entryOf(object);
  if (entry == nullptr || !entry->readable()) return say(tr("%1 is written.").arg(objectText(object)));
  readOne(object, [this, object, written](const RequestOutcome& outcome) {
    const auto* now = entryOf(object);
    if (now == nullptr) return;
    if (!outcome.ok()) return say(tr("Written, but not to be read back: %1").arg(outcome.why), true);
    const auto text = valueText(*now, outcome.answer.data);
    if (outcome.answer.data == written) return say(tr("%1 is %2 now.").arg(objectText(object), text));
    say(tr("Written, but the slave has made %1 of it.").arg(text), true);
  });
}

void SlaveObjectsPage::stop() {
  stopAsking();
  say(tr("Stopped."));
  showWork();
}

void SlaveObjectsPage::keepWatched() {
  if (settings() != nullptr) workspace().watched().set(settings()->station_address, model_->watched());
  if (watched_only_->isChecked()) filter_->invalidate();
}

void SlaveObjectsPage::exportCsv() {
  const auto name = QString::fromStdString(settings()->name) + QStringLiteral("-objects.csv");
  const auto path = askSaveName(this, tr("Export Objects"), name, tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  if (auto status = write_whole_file(path.toStdString(), tableCsv(*filter_).toStdString()); !status)
    showError(window(), tr("The objects could not be exported."), status.error());
}

void SlaveObjectsPage::copy() {
  const auto rows = tree_->selectionModel()->selectedRows();
  if (!rows.isEmpty()) QGuiApplication::clipboard()->setText(rowsText(rows));
}

}  // namespace syncline::ui
