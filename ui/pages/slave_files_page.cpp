// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/slave_files_page.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <utility>

#include "support/whole_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/dialogs/questions.h"
#include "ui/files/save_name.h"
#include "ui/models/record_model.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"
#include "ui/text/glossary.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kMostTransfers = 200;

QString sizeText(std::size_t bytes) { return QLocale().formattedDataSize(static_cast<qint64>(bytes)); }

}  // namespace

SlaveFilesPage::SlaveFilesPage(Workspace& workspace) : OnlinePage(workspace, "slaveFilesPage", tr("Files")) {
  auto* layout = build();
  layout->addWidget(buildFields());
  auto* about = new QLabel(
      tr("Most devices take firmware in BOOT only, where the buttons above lead the slave; other files are served in "
         "PREOP and above. What a name means, and which password opens it, says the device's manual."));
  about->setWordWrap(true);
  about->setForegroundRole(QPalette::PlaceholderText);
  layout->addWidget(about);
  lines_ = new RecordModel(
      {tr("Slave"), tr("What"), tr("File in the slave"), tr("Size"), tr("File here"), tr("Outcome")}, this);
  auto* table = named(new QTableView, "fileTransfers", tr("Files that were transferred"));
  setUpTable(*table);
  table->setModel(lines_);
  table->setColumnWidth(0, 170);
  table->setColumnWidth(2, 150);
  table->setColumnWidth(4, 220);
  stretchColumn(*table, 5);
  layout->addWidget(table, 1);
  progress_ = named(new QProgressBar, "fileProgress", tr("How much of the file has been transferred"));
  progress_->setTextVisible(false);
  progress_->setVisible(false);
  layout->addWidget(progress_);
  layout->addWidget(buildStatus("fileStatus"));
}

QWidget* SlaveFilesPage::buildFields() {
  auto* area = new QWidget;
  auto* layout = new QGridLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  name_ = named(new QLineEdit, "fileName", tr("Name of the file in the slave"));
  name_->setMaxLength(255);
  password_ = named(new QLineEdit, "filePassword", tr("Password of the slave, a number"));
  password_->setPlaceholderText(tr("none"));
  read_ = named(new QPushButton(tr("&Read into File…")), "fileRead", tr("Copy the slave's file into a file here"));
  write_ = named(new QPushButton(tr("&Write from File…")), "fileWrite", tr("Give a file to the slave"));
  cancel_ = named(new QPushButton(tr("&Cancel")), "fileCancel", tr("End the transfer"));
  const auto caption = [&](const QString& text, QWidget* of, int row) {
    auto* label = new QLabel(text);
    label->setBuddy(of);
    layout->addWidget(label, row, 0);
    layout->addWidget(of, row, 1);
  };
  caption(tr("File in the slave"), name_, 0);
  caption(tr("Password"), password_, 1);
  layout->addWidget(read_, 0, 2);
  layout->addWidget(write_, 0, 3);
  layout->addWidget(cancel_, 1, 2);
  layout->setColumnStretch(1, 1);
  connect(name_, &QLineEdit::textChanged, this, &SlaveFilesPage::enable);
  connect(read_, &QPushButton::clicked, this, &SlaveFilesPage::askWhereTo);
  connect(write_, &QPushButton::clicked, this, &SlaveFilesPage::askWhereFrom);
  connect(cancel_, &QPushButton::clicked, this, [this] { this->workspace().requests().cancel(request_); });
  return area;
}

bool SlaveFilesPage::appliesTo(int slave) const {
  const auto at = static_cast<std::size_t>(slave);
  if (slave < 0 || at >= project().slaves.size()) return false;
  const auto& mailbox = project().slaves[at].device.mailbox;
  return mailbox && mailbox->foe;
}

void SlaveFilesPage::slaveChanged() { enable(); }

/// What was transferred was of another run.
void SlaveFilesPage::machineChanged() {
  done_.clear();
  lines_->setLines({});
}

void SlaveFilesPage::tick(std::optional<Nanoseconds>) {
  showProgress();
  enable();
}

QString SlaveFilesPage::ownObstacle(const RunningSlave& slave) const {
  if (!slave.config->mailbox || !slave.config->mailbox->foe)
    return tr("The machine was started without files (FoE) for this slave: restart it with the project as it is now.");
  const auto state = slave.state();
  if (state == AlState::kInit || state == AlState::kNone)
    return tr("The slave is in %1: lead it to PREOP, or to BOOT.").arg(stateName(state));
  return {};
}

void SlaveFilesPage::enable() {
  const bool idle = possible() && !going_ && !name_->text().trimmed().isEmpty();
  read_->setEnabled(idle);
  write_->setEnabled(idle);
  cancel_->setEnabled(going_.has_value());
}

void SlaveFilesPage::showProgress() {
  progress_->setVisible(going_.has_value());
  if (!going_) return;
  const auto so_far = workspace().requests().progress(request_);
  // How long a file is, the slave does not say before its end.
  progress_->setMaximum(static_cast<int>(going_->bytes));
  progress_->setValue(static_cast<int>(so_far));
  const auto text = going_->writes
                        ? tr("%1: \"%2\" is being written, %3 of %4.")
                              .arg(going_->slave, going_->name, sizeText(so_far), sizeText(going_->bytes))
                        : tr("%1: \"%2\" is being read, %3 so far.").arg(going_->slave, going_->name, sizeText(so_far));
  say(text);
}

std::optional<std::uint32_t> SlaveFilesPage::password() {
  const auto text = password_->text().trimmed();
  if (text.isEmpty()) return 0;
  bool good = false;
  const auto number = text.toUInt(&good, 0);
  if (good) return number;
  say(tr("The password is a number of 32 bits, such as 1234 or 0x12AB: \"%1\" is none.").arg(text), true);
  password_->setFocus();
  password_->selectAll();
  return std::nullopt;
}

// ---- reading ------------------------------------------------------------------------------------

void SlaveFilesPage::askWhereTo() {
  if (!password()) return;
  // A name in the slave may be a path there.
  const auto proposed = QFileInfo(name_->text().trimmed()).fileName();
  const auto path = askSaveName(this, tr("Read File of the Slave"), proposed, tr("All files (*)"));
  if (!path.isEmpty()) readInto(path);
}

void SlaveFilesPage::readInto(const QString& path) {
  const auto slave = running();
  if (!slave || !possible() || going_) return;
  const auto opens = password();
  if (!opens) return;
  const auto name = name_->text().trimmed();
  begin({slave->position, nodeName(project(), node()), name, path, false, 0},
        requests::FileRead{slave->position, name.toStdString(), *opens, requests::FileRead::kMost});
}

// ---- writing ------------------------------------------------------------------------------------

void SlaveFilesPage::askWhereFrom() {
  if (!password()) return;
  const auto path = QFileDialog::getOpenFileName(this, tr("Write File to the Slave"), {}, tr("All files (*)"));
  if (!path.isEmpty()) writeFrom(path);
}

void SlaveFilesPage::writeFrom(const QString& path) {
  const auto slave = running();
  if (!slave || !possible() || going_) return;
  const auto opens = password();
  if (!opens) return;
  const auto content = read_whole_file(path.toStdString());
  if (!content) return showError(window(), tr("The file could not be read."), content.error());
  const auto name = name_->text().trimmed();
  const auto question =
      tr("Write %1 (%2) into %3 as \"%4\"?")
          .arg(QFileInfo(path).fileName(), sizeText(content->size()), nodeName(project(), node()), name);
  auto more =
      tr("Nothing brings back what the slave has under this name now, and a wrong firmware can leave a slave that "
         "no longer comes up. The slave must keep its power until it is done.");
  if (slave->drives())
    more.prepend(tr("The slave is in %1: taking a file may stop it.").arg(stateName(slave->state())) + u' ');
  if (!ask(*window(), "fileQuestion", question, more, tr("Write"))) return;
  const auto now = running();
  if (!now || now->position != slave->position) return say(obstacle(), true);
  begin({slave->position, nodeName(project(), node()), name, path, true, content->size()},
        requests::FileWrite{slave->position, name.toStdString(), *opens, {content->begin(), content->end()}});
}

/// Asked for by the workspace and not by this page: whoever looks at another slave meanwhile does not end it.
void SlaveFilesPage::begin(const Transfer& transfer, SlaveRequest request) {
  going_ = transfer;
  request_ = workspace().requests().post(std::move(request), workspace(),
                                         [page = QPointer(this), transfer](const RequestOutcome& outcome) {
                                           if (page) page->settle(transfer, outcome);
                                         });
  showProgress();
  enable();
}

void SlaveFilesPage::settle(const Transfer& transfer, const RequestOutcome& outcome) {
  going_.reset();
  auto ended = transfer;
  QString became;
  bool bad = false;
  if (outcome.end == RequestEnd::kCancelled) {
    became = transfer.writes ? tr("Cancelled: the slave has a part of it, or nothing") : tr("Cancelled");
    bad = transfer.writes;
  } else if (!outcome.ok()) {
    became = outcome.why;
    bad = true;
  } else if (transfer.writes) {
    became = tr("Written");
  } else {
    ended.bytes = outcome.answer.data.size();
    const auto status = write_whole_file(transfer.path.toStdString(), outcome.answer.data);
    became = status ? tr("Read") : errorText(status.error());
    bad = !status;
  }
  note(ended, became);
  const auto text = tr("\"%1\": %2").arg(transfer.name, became);
  workspace().inform(transfer.slave, text);
  showProgress();
  say(position() == transfer.position ? text : transfer.slave + QStringLiteral(", ") + text, bad);
  enable();
}

void SlaveFilesPage::note(const Transfer& transfer, const QString& became) {
  done_.push_front({transfer.slave, transfer.writes ? tr("write") : tr("read"), transfer.name,
                    transfer.bytes > 0 ? sizeText(transfer.bytes) : QString(), transfer.path, became});
  if (done_.size() > kMostTransfers) done_.pop_back();
  lines_->setLines({done_.begin(), done_.end()});
}

}  // namespace syncline::ui
