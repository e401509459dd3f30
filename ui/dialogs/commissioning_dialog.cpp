// SPDX-License-Identifier: Apache-2.0
#include "ui/dialogs/commissioning_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "eni/report/reported_eni.h"
#include "reports/commissioning_report.h"
#include "support/output_file.h"
#include "ui/dialogs/error_dialog.h"
#include "ui/files/save_name.h"
#include "ui/session/workspace.h"
#include "ui/text/acceptance_text.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"
#include "ui/widgets/tables.h"

namespace syncline::ui {
namespace {

constexpr int kRefreshInterval = 1000;  // ms
constexpr int kMostCount = 1'000'000'000;
constexpr int kUsualWidth = 980, kWidestReport = 1400;  // pixels, where what is found does not need more
enum CriterionColumn { kVerdict, kCriterion, kRequired, kFound, kCriterionColumns };

Status writeText(const QString& path, const std::string& text) {
  auto file = OutputFile::create(path.toStdString());
  if (!file) return tl::unexpected(file.error());
  if (auto status = file->write(text); !status) return status;
  return file->finish();
}

}  // namespace

CommissioningDialog::CommissioningDialog(Workspace& workspace, QWidget* parent)
    : QDialog(parent), workspace_(workspace) {
  setObjectName(QStringLiteral("commissioningDialog"));
  setWindowTitle(tr("Commissioning Report"));
  build();
  // A project that has no file yet is "Untitled" here as in the title of the window.
  machine_->setText(workspace.recording().isOpen() ? QString::fromStdString(facts().machine)
                                                   : QFileInfo(workspace.document().displayName()).completeBaseName());
  refresh();
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &CommissioningDialog::refresh);
  timer->start(kRefreshInterval);
  resize(std::clamp(wantedWidth(), kUsualWidth, kWidestReport), sizeHint().height());
}

/// In which all that is found stands on one line.
int CommissioningDialog::wantedWidth() {
  auto& header = *criteria_->horizontalHeader();
  header.setSectionResizeMode(kFound, QHeaderView::Interactive);
  criteria_->resizeColumnsToContents();
  const auto margins = layout()->contentsMargins();
  const int wanted = header.length() + 2 * criteria_->frameWidth() + margins.left() + margins.right();
  header.setSectionResizeMode(kFound, QHeaderView::Stretch);
  return wanted;
}

void CommissioningDialog::build() {
  auto* layout = new QVBoxLayout(this);
  auto* columns = new QHBoxLayout;
  auto* left = new QFormLayout;
  auto* right = new QFormLayout;
  machine_ = named(new QLineEdit, "commissioningMachine", tr("Name of the machine"));
  left->addRow(tr("&Machine"), machine_);
  minutes_ = named(new QDoubleSpinBox, "commissioningMinutes", tr("Least time that it was watched for, minutes"));
  minutes_->setRange(0, 100'000);
  minutes_->setDecimals(1);
  minutes_->setSuffix(tr(" min"));
  left->addRow(tr("&Watched for at least"), minutes_);
  const auto count = [&](QFormLayout& form, const char* name, const QString& label, const QString& spoken) {
    auto* box = named(new QSpinBox, name, spoken);
    box->setRange(0, kMostCount);
    form.addRow(label, box);
    connect(box, &QSpinBox::valueChanged, this, &CommissioningDialog::refresh);
    return box;
  };
  margin_ = count(*left, "commissioningMargin", tr("Least m&argin"), tr("Least margin to the limits, percent"));
  margin_->setRange(0, 100);
  margin_->setSuffix(QStringLiteral(" %"));
  missed_ = count(*left, "commissioningMissed", tr("SM2 &events missed at most"), tr("Most SM2 events missed"));
  lost_ = count(*right, "commissioningLost", tr("&Frames lost at most"), tr("Most frames lost"));
  wkc_ = count(*right, "commissioningWkc", tr("Wr&ong working counters at most"), tr("Most wrong working counters"));
  left_out_ = count(*right, "commissioningLeftOut", tr("&Cycles left out at most"), tr("Most cycles left out"));
  columns->addLayout(left);
  columns->addSpacing(16);
  columns->addLayout(right);
  layout->addLayout(columns);
  verdict_ = named(new Pill, "commissioningVerdict", tr("Result"));
  layout->addWidget(verdict_, 0, Qt::AlignLeft);
  criteria_ = named(new QTableWidget(0, kCriterionColumns), "commissioningCriteria", tr("Criteria"));
  criteria_->setHorizontalHeaderLabels({tr("Verdict"), tr("Criterion"), tr("Required"), tr("Found")});
  criteria_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  setUpTable(*criteria_);
  criteria_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  criteria_->horizontalHeader()->setSectionResizeMode(kFound, QHeaderView::Stretch);
  layout->addWidget(criteria_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  write_ = named(buttons->addButton(tr("Write &Page…"), QDialogButtonBox::ActionRole), "commissioningWrite",
                 tr("Write the page"));
  named(buttons->button(QDialogButtonBox::Close), "commissioningClose", tr("Close"))->setAutoDefault(false);
  write_->setDefault(true);
  layout->addWidget(buttons);
  connect(minutes_, &QDoubleSpinBox::valueChanged, this, &CommissioningDialog::refresh);
  connect(write_, &QPushButton::clicked, this, &CommissioningDialog::askFile);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

reports::AcceptanceLimits CommissioningDialog::limits() const {
  const auto most = [](const QSpinBox* box) { return static_cast<std::uint64_t>(box->value()); };
  return {.least_time = static_cast<Nanoseconds>(minutes_->value() * 60e9),
          .least_margin = margin_->value() / 100.0,
          .most_lost_frames = most(lost_),
          .most_wkc_errors = most(wkc_),
          .most_left_out = most(left_out_),
          .most_missed_events = most(missed_)};
}

reports::Acceptance CommissioningDialog::judged() const {
  const auto& record = *workspace_.shownRecord();
  if (workspace_.recording().isOpen()) {
    return reports::judge(record, reports::severities_of(workspace_.recording().run()), limits());
  }
  return reports::judge(record, record.findings(), limits());
}

reports::CommissioningFacts CommissioningDialog::facts() const {
  const auto& recording = workspace_.recording();
  auto facts = recording.isOpen() ? reports::facts_of(recording.run(), recording.path().toStdString())
                                  : reports::facts_of(workspace_.disk().about(), {});
  const auto typed = machine_->text().trimmed();
  if (!typed.isEmpty()) facts.machine = typed.toStdString();
  facts.date = eni::report_date();
  facts.program = QStringLiteral("Syncline %1").arg(workspace_.environment().version).toStdString();
  return facts;
}

void CommissioningDialog::refresh() {
  write_->setEnabled(workspace_.shownRecord() != nullptr);
  if (workspace_.shownRecord() == nullptr) return;
  const auto acceptance = judged();
  const auto tone = [](reports::Verdict verdict) {
    return verdict == reports::Verdict::kKept      ? theme::Tone::kGood
           : verdict == reports::Verdict::kNotKept ? theme::Tone::kBad
                                                   : theme::Tone::kWarning;
  };
  verdict_->setState(tone(acceptance.verdict), acceptanceText(acceptance.verdict));
  criteria_->setRowCount(static_cast<int>(acceptance.criteria.size()));
  // All are seen at once: whether a machine is accepted is nothing to scroll for.
  criteria_->setMinimumHeight(criteria_->horizontalHeader()->sizeHint().height() +
                              criteria_->verticalHeader()->length() + 2 * criteria_->frameWidth());
  for (int row = 0; row < criteria_->rowCount(); ++row) {
    const auto& criterion = acceptance.criteria[static_cast<std::size_t>(row)];
    const QString texts[kCriterionColumns] = {verdictText(criterion.verdict), criterionText(criterion.kind),
                                              requiredText(criterion), foundText(criterion)};
    for (int column = 0; column < kCriterionColumns; ++column) {
      auto* item = criteria_->item(row, column);
      if (item == nullptr) criteria_->setItem(row, column, item = new QTableWidgetItem);
      if (item->text() != texts[column]) item->setText(texts[column]);
      item->setToolTip(texts[column]);
    }
    auto font = criteria_->font();
    font.setBold(criterion.verdict == reports::Verdict::kNotKept);
    criteria_->item(row, kVerdict)->setFont(font);
  }
}

void CommissioningDialog::askFile() {
  const auto name = QString::fromStdString(facts().machine) + QStringLiteral(".commissioning.html");
  const auto path = askSaveName(this, tr("Write Page"), name, tr("Web pages (*.html)"));
  if (!path.isEmpty()) write(path);
}

void CommissioningDialog::write(const QString& path) {
  if (workspace_.shownRecord() == nullptr) return;
  const auto acceptance = judged();
  const auto status = writeText(path, reports::commissioning_report(*workspace_.shownRecord(), facts(), acceptance));
  if (!status) return showError(this, tr("The page could not be written."), status.error());
  workspace_.inform(tr("Commissioning"), tr("%1: %2").arg(acceptanceText(acceptance.verdict), path));
  accept();
}

}  // namespace syncline::ui
