// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_history_page.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <utility>

#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/files/save_name.h"
#include "ui/models/diagnosis_model.h"
#include "ui/models/dictionary.h"
#include "ui/session/diag_text_reader.h"
#include "ui/session/diagnosis_reader.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/poll_choice.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

namespace of_history = diagnosis_history;

QString flagsText(std::uint16_t flags) {
  const auto has = [&](std::uint16_t bit) { return (flags & bit) != 0; };
  const bool keeps = has(of_history::kAcknowledgeMode);
  QStringList parts;
  parts << (keeps ? SlaveHistoryPage::tr("When full it keeps what nobody has acknowledged")
                  : SlaveHistoryPage::tr("When full it overwrites the oldest message"));
  if (has(of_history::kOverwritten)) {
    parts << (keeps ? SlaveHistoryPage::tr("messages were thrown away because it was full")
                    : SlaveHistoryPage::tr("messages were overwritten that nobody had acknowledged"));
  }
  parts << (has(of_history::kSendEmergency) ? SlaveHistoryPage::tr("each is sent as an emergency, too")
                                            : SlaveHistoryPage::tr("none is sent as an emergency"));
  QStringList off;
  if (has(of_history::kNoInfo)) off << SlaveHistoryPage::tr("information");
  if (has(of_history::kNoWarning)) off << SlaveHistoryPage::tr("warnings");
  if (has(of_history::kNoError)) off << SlaveHistoryPage::tr("errors");
  if (!off.isEmpty()) parts << SlaveHistoryPage::tr("not kept: %1").arg(joinedParts(off));
  return SlaveHistoryPage::tr("Flags %1: %2.").arg(hexText(flags, 4), joinedClauses(parts));
}

}  // namespace

SlaveHistoryPage::SlaveHistoryPage(Workspace& workspace)
    : OnlinePage(workspace, "slaveHistoryPage", tr("History")),
      reader_(new DiagnosisReader(workspace.requests(), this)),
      texts_(new DiagTextReader(workspace.catalogue(), this)),
      model_(new DiagnosisModel(this)) {
  auto* layout = build();
  layout->addWidget(buildButtons());
  for (auto [label, name] : {std::pair{&summary_, "historySummary"}, std::pair{&flags_, "historyFlags"}}) {
    *label = new QLabel;
    (*label)->setObjectName(QLatin1String(name));
    (*label)->setWordWrap(true);
    (*label)->setTextInteractionFlags(Qt::TextSelectableByMouse);
    layout->addWidget(*label);
  }
  flags_->setForegroundRole(QPalette::PlaceholderText);
  table_ = named(new QTableView, "historyTable", tr("Messages of the slave's diagnosis history, newest first"));
  setUpTable(*table_);
  table_->setModel(model_);
  const std::pair<DiagnosisModel::Column, int> widths[] = {{DiagnosisModel::kPlace, 76},  {DiagnosisModel::kType, 82},
                                                           {DiagnosisModel::kState, 104}, {DiagnosisModel::kText, 300},
                                                           {DiagnosisModel::kTime, 156},  {DiagnosisModel::kCode, 92},
                                                           {DiagnosisModel::kStamp, 152}};
  for (const auto& [column, width] : widths) table_->setColumnWidth(column, width);
  table_->horizontalHeader()->setMinimumSectionSize(60);
  table_->horizontalHeader()->setStretchLastSection(true);
  layout->addWidget(table_, 1);
  layout->addWidget(buildStatus("historyStatus"));
  connectReaders();
  enable();
}

QWidget* SlaveHistoryPage::buildButtons() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  read_ = named(new QPushButton(tr("&Read")), "historyRead", tr("Read the diagnosis history"));
  read_->setToolTip(tr("Object 0x10F3 (ETG.1020). Reading acknowledges nothing."));
  poll_ = named(new PollChoice(tr("On demand"), tr("Every %1 s"), {1000, 2000, 10000}), "historyPoll",
                tr("How often the diagnosis history is read"));
  acknowledge_ = named(new QPushButton(tr("&Acknowledge All…")), "historyAcknowledge",
                       tr("Acknowledge all messages of the diagnosis history"));
  acknowledge_->setToolTip(tr("Writes the newest message's sub-index to 0x10F3:03"));
  export_ = named(new QPushButton(tr("&CSV…")), "historyExport", tr("Export the messages as comma-separated values"));
  layout->addWidget(read_);
  layout->addWidget(poll_);
  layout->addStretch(1);
  layout->addWidget(acknowledge_);
  layout->addWidget(export_);
  connect(read_, &QPushButton::clicked, this, &SlaveHistoryPage::read);
  connect(acknowledge_, &QPushButton::clicked, this, &SlaveHistoryPage::acknowledgeAll);
  connect(export_, &QPushButton::clicked, this, &SlaveHistoryPage::exportCsv);
  return area;
}

void SlaveHistoryPage::connectReaders() {
  connect(reader_, &DiagnosisReader::read, this, &SlaveHistoryPage::showLog);
  connect(reader_, &DiagnosisReader::absent, this, [this] {
    absent_ = true;
    poll_->reset();
    say(tr("This slave keeps no diagnosis history: it has no object 0x10F3."));
    enable();
  });
  connect(reader_, &DiagnosisReader::failed, this, [this](const QString& why) {
    say(why, true);
    enable();
  });
  connect(texts_, &DiagTextReader::told, this, [this](const Identity& identity, const DiagTexts& texts) {
    const auto* slave = settings();
    if (slave == nullptr) return;
    auto ours = slave->device.identity;
    ours.serial_no = 0;
    if (ours == identity) model_->setTexts(texts);
  });
}

QString SlaveHistoryPage::ownObstacle(const RunningSlave& slave) const {
  if (!slave.config->mailbox || !slave.config->mailbox->coe) {
    return tr("This slave does not speak CoE: it keeps no diagnosis history.");
  }
  if (has_mailbox_communication(slave.state())) return {};
  return tr("The history can be read from PREOP on: lead the slave there first.");
}

void SlaveHistoryPage::ended() {
  reader_->cancel();
  acknowledging_ = false;
}

void SlaveHistoryPage::slaveChanged() {
  known_ = absent_ = asked_ = false;
  poll_->reset();
  model_->clear();
  model_->setTexts({});
  showSummary();
  enable();
}

/// The first time it is looked at it is read by itself.
void SlaveHistoryPage::tick(std::optional<Nanoseconds> now) {
  if (now && possible() && !absent_ && !reader_->isRunning() && !acknowledging_) {
    if (poll_->due(*now) || !asked_) read();
  }
  enable();
}

void SlaveHistoryPage::enable() {
  const bool free = possible() && !reader_->isRunning() && !acknowledging_;
  read_->setEnabled(free);
  poll_->setEnabled(possible() && !absent_);
  acknowledge_->setEnabled(free && known_ && model_->unacknowledged() > 0);
  export_->setEnabled(model_->rowCount() > 0);
}

void SlaveHistoryPage::read() {
  const auto slave = running();
  if (!slave || !possible()) return;
  asked_ = true;
  absent_ = false;
  reader_->start(slave->position);
  enable();
}

void SlaveHistoryPage::showLog(const DiagnosisLog& log) {
  known_ = true;
  model_->setLog(log);
  if (!log.entries.empty()) texts_->want(settings()->device.identity);
  say(log.entries.empty() ? tr("The history is empty.") : QString());
  showSummary();
  enable();
}

void SlaveHistoryPage::showSummary() {
  summary_->setVisible(known_);
  const auto& header = model_->log().header;
  flags_->setVisible(known_ && header.flags.has_value());
  if (!known_) return;
  const auto place = [&](std::uint8_t sub) {
    return header.in_ring(sub) ? objectText({of_history::kIndex, sub}) : tr("none");
  };
  summary_->setText(
      tr("%1 of at most %2 messages. Newest: %3. Newest acknowledged: %4. New messages available: %5.")
          .arg(model_->rowCount())
          .arg(header.maximum)
          .arg(place(header.newest), place(header.newest_acknowledged), header.new_available ? tr("yes") : tr("no")));
  if (header.flags) flags_->setText(flagsText(*header.flags));
}

/// Up to the newest that is shown: what comes meanwhile stays new.
void SlaveHistoryPage::acknowledgeAll() {
  const auto newest = model_->log().header.newest;
  const int count = model_->unacknowledged();
  if (!model_->log().header.in_ring(newest) || count == 0) return;
  const auto text = tr("Acknowledge %n message(s) of %1?", nullptr, count).arg(nodeName(project(), node()));
  if (!ask(*window(), "acknowledgeQuestion", text,
           tr("The messages stay in the slave until newer ones take their places, but nobody is told of them any more. "
              "The fault itself is not acknowledged by this."),
           tr("Acknowledge"))) {
    return;
  }
  const auto slave = running();
  if (!slave) return;
  reader_->cancel();
  acknowledging_ = true;
  enable();
  post(
      requests::SdoWrite{
          .slave = slave->position, .object = {of_history::kIndex, of_history::kNewestAcknowledged}, .data = {newest}},
      [this](const RequestOutcome& outcome) {
        acknowledging_ = false;
        if (!outcome.ok()) {
          say(outcome.why, true);
          return enable();
        }
        read();
      });
}

void SlaveHistoryPage::exportCsv() {
  const auto name = QString::fromStdString(settings()->name) + QStringLiteral("-history.csv");
  const auto path = askSaveName(this, tr("Export Diagnosis History"), name, tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  if (auto status = write_whole_file(path.toStdString(), model_->csv().toStdString()); !status)
    showError(window(), tr("The history could not be exported."), status.error());
}

}  // namespace syncline::ui
