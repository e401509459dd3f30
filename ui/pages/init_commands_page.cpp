// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/init_commands_page.h"

#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QVBoxLayout>

#include "exports/init_command_origin.h"
#include "exports/init_commands.h"
#include "protocol/object_value.h"
#include "settings/setting.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/item_list.h"
#include "ui/editors/record_editor.h"
#include "ui/models/record_model.h"
#include "ui/models/word_filter.h"
#include "ui/pages/message_parts.h"
#include "ui/session/workspace.h"
#include "ui/text/glossary.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

constexpr const char *kSlaveRegisterKey = "slave.N.register.K", *kMasterRegisterKey = "master.register.K";
/// What Add appends sends nothing before the user says what.
constexpr const char* kFreshRegister = "PS write 0x0000=00 off";
constexpr int kLowestInitTable = 200;

enum InitColumn : int {
  kInitSlave,
  kInitTransition,
  kInitCommand,
  kInitTarget,
  kInitData,
  kInitAnswer,
  kInitOrigin,
  kInitComment
};

QString dataText(const exports::InitCommandRow& row) {
  if (row.length) return InitCommandsPage::tr("%n zero byte(s)", nullptr, *row.length);
  return QString::fromStdString(value_text(kBytesType, row.data));
}

/// What has to come back, how long it may take, and what is done when it does not.
QString answerText(const exports::InitCommandRow& row) {
  QStringList parts;
  if (row.expected_wkc) parts << InitCommandsPage::tr("counter %1").arg(*row.expected_wkc);
  if (!row.validate.empty()) parts << QString::fromStdString(row.validate);
  if (row.timeout_ms > 0) parts << InitCommandsPage::tr("within %1 ms").arg(row.timeout_ms);
  if (row.retries > 0) parts << InitCommandsPage::tr("%n repeat(s)", nullptr, static_cast<int>(row.retries));
  return parts.join(QStringLiteral(", "));
}

/// What of the project it is there for: there it is changed.
QString originText(exports::InitCommandOrigin origin) {
  using enum exports::InitCommandOrigin;
  switch (origin) {
    case kStateMachine:
      return InitCommandsPage::tr("State machine");
    case kAddresses:
      return InitCommandsPage::tr("Addresses");
    case kDeviceCheck:
      return InitCommandsPage::tr("Check of the device");
    case kSyncManagers:
      return InitCommandsPage::tr("SyncManagers");
    case kFmmus:
      return InitCommandsPage::tr("Process image");
    case kClocks:
      return InitCommandsPage::tr("Distributed clocks");
    case kWatchdogs:
      return InitCommandsPage::tr("Watchdogs");
    case kPorts:
      return InitCommandsPage::tr("Ports");
    case kPdoAssignment:
      return InitCommandsPage::tr("PDO assignment");
    case kPdoMapping:
      return InitCommandsPage::tr("PDO mapping");
    case kEsi:
      return InitCommandsPage::tr("ESI");
    case kStartup:
      return InitCommandsPage::tr("Page Start-up");
    case kOwn:
      return InitCommandsPage::tr("Own, below");
    case kSettings:
      break;
  }
  return InitCommandsPage::tr("Settings");
}

QStringList lineOf(const exports::InitCommandRow& row, const Project& project) {
  auto command = QString::fromStdString(row.protocol + " " + row.command);
  if (!row.enabled) command += u' ' + InitCommandsPage::tr("(off)");
  return {nodeName(project, row.slave),
          QString::fromStdString(row.transitions),
          command,
          QString::fromStdString(row.target),
          dataText(row),
          answerText(row),
          originText(exports::origin_of(row, project)),
          QString::fromStdString(row.comment)};
}

}  // namespace

InitCommandsPage::InitCommandsPage(Workspace& workspace)
    : Page(workspace, "initCommandsPage", tr("Init Commands (Expert)")) {
  model_ = new RecordModel(
      {tr("Slave"), tr("Transition"), tr("Command"), tr("To"), tr("Data"), tr("Answer"), tr("Origin"), tr("Comment")},
      this);
  filter_ = new WordFilter(RecordModel::kWordsRole, this);
  filter_->setSourceModel(model_);
  words_ = named(new QLineEdit, "initCommandSearch", tr("Search init commands"));
  words_->setPlaceholderText(tr("Transition, register, object, or comment"));
  words_->setClearButtonEnabled(true);
  table_ = named(new QTableView, "initCommandTable", tr("Init commands"));
  table_->setModel(filter_);
  setUpTable(*table_);
  const std::pair<InitColumn, int> widths[] = {{kInitSlave, 120},  {kInitTransition, 80}, {kInitCommand, 90},
                                               {kInitTarget, 170}, {kInitData, 110},      {kInitAnswer, 120},
                                               {kInitOrigin, 100}};
  for (const auto& [column, width] : widths) table_->setColumnWidth(column, width);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setMinimumHeight(kLowestInitTable);
  count_ = new QLabel;
  count_->setObjectName(QStringLiteral("initCommandCount"));
  count_->setWordWrap(true);
  const auto none = tr("None: the commands above are all.");
  of_slave_ = new RecordEditor(*this, "register", tr("Own register commands"),
                               itemList(*this, kSlaveRegisterKey, tr("register command"), none, kFreshRegister),
                               registerParts(false), true);
  of_master_ = new RecordEditor(*this, "masterRegister", tr("Own register commands to all slaves"),
                                itemList(*this, kMasterRegisterKey, tr("register command"), none, kFreshRegister),
                                registerParts(true), true);
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(12, 12, 12, 12);
  layout->setSpacing(6);
  layout->addWidget(words_);
  layout->addWidget(table_, 1);
  layout->addWidget(count_);
  for (auto* own : {of_slave_, of_master_}) {
    own->foldWhenEmpty();
    layout->addSpacing(8);
    layout->addWidget(own);
  }
  setWidget(content);
  fields().setExpertPage();
  connect(words_, &QLineEdit::textChanged, filter_, &WordFilter::setWords);
}

bool InitCommandsPage::appliesTo(int) const { return expert(); }

void InitCommandsPage::showEvent(QShowEvent* event) {
  refresh();
  Page::showEvent(event);
}

void InitCommandsPage::showPlace(const settings::Setting& setting, const settings::Place& place) {
  if (setting.key == kSlaveRegisterKey) of_slave_->select(static_cast<int>(place.item));
  if (setting.key == kMasterRegisterKey) of_master_->select(static_cast<int>(place.item));
}

void InitCommandsPage::refresh() {
  showOwn();
  if (isVisible()) showAll();
}

void InitCommandsPage::showOwn() {
  of_slave_->setVisible(node() >= 0);
  of_master_->setVisible(node() < 0);
  for (auto* own : {of_slave_, of_master_}) own->showRecords();
  fields().refresh();
  for (auto* own : {of_slave_, of_master_}) own->refreshButtons();
}

/// Thousands of lines are made for those who look at them.
void InitCommandsPage::showAll() {
  const auto* config = workspace().configuration().config();
  table_->setColumnHidden(kInitSlave, node() >= 0);
  if (config == nullptr) {
    model_->setLines({});
    return count_->setText(tr("The project cannot be compiled: the messages say why."));
  }
  RecordModel::Lines lines;
  for (const auto& row : exports::init_commands(*config)) {
    if (node() < 0 || row.slave == node()) lines.push_back(lineOf(row, project()));
  }
  const auto count = static_cast<int>(lines.size());
  count_->setText(
      tr("%n command(s), in the order of the ENI. Those of mailboxes are set on the page Start-up of a slave, "
         "those of registers below.",
         nullptr, count));
  model_->setLines(lines);
}

}  // namespace syncline::ui
