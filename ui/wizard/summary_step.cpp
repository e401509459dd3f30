// SPDX-License-Identifier: Apache-2.0
#include "ui/wizard/summary_step.h"

#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>
#include <algorithm>

#include "eni/check/eni_check.h"
#include "findings/fold.h"
#include "protocol/system_time_difference.h"
#include "settings/settings_table.h"
#include "ui/editors/field_binder.h"
#include "ui/files/held_file.h"
#include "ui/files/save_name.h"
#include "ui/models/finding_model.h"
#include "ui/text/error_text.h"
#include "ui/text/joined_text.h"
#include "ui/text/setting_text.h"
#include "ui/text/units.h"
#include "ui/widgets/card.h"
#include "ui/widgets/named.h"
#include "ui/widgets/tables.h"
#include "ui/wizard/machine_draft.h"

namespace syncline::ui {
namespace {

QString modeText(DcmMode mode) {
  const auto& options = std::get<settings::Choice>(settings::row("master.dc.mode").type).options;
  const auto found =
      std::ranges::find(options, settings::Value{static_cast<std::int64_t>(mode)}, &settings::Option::value);
  return found == options.end() ? noText() : optionText(*found);
}

}  // namespace

SummaryStep::SummaryStep(MachineDraft& draft)
    : WizardStep(draft, "wizardSummaryStep", tr("Summary"),
                 tr("Finish puts the machine into the window, where everything can be changed further. It is not saved "
                    "yet.")) {
  auto* area = new QWidget;
  auto* layout = new QVBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(10);
  auto* card = new Card(tr("The new machine"));
  slaves_ = card->addValue("wizardSumSlaves", tr("Slaves"));
  cycle_ = card->addValue("wizardSumCycle", tr("Cycle"));
  clock_ = card->addValue("wizardSumClock", tr("Reference clock"));
  mode_ = card->addValue("wizardSumMode", tr("Master synchronisation"));
  window_ = card->addValue("wizardSumWindow", tr("Sync window"));
  layout->addWidget(card);
  verdict_ = named(new QLabel, "wizardVerdict", tr("What the check found"));
  verdict_->setWordWrap(true);
  layout->addWidget(verdict_);
  findings_ = new FindingModel(this);
  table_ = named(new QTableView, "wizardFindings", tr("Findings"));
  setUpTable(*table_);
  table_->setModel(findings_);
  table_->setColumnWidth(FindingModel::kSeverity, 90);
  table_->setColumnWidth(FindingModel::kWhere, 90);
  table_->setColumnWidth(FindingModel::kAdvice, 260);
  stretchColumn(*table_, FindingModel::kFinding);
  layout->addWidget(table_, 1);
  layout->addWidget(buildExport());
  setWidget(area);
  auto& eni = draft.workspace().eni();
  connect(&eni, &EniPreview::changed, this, &SummaryStep::showFindings);
  connect(&eni, &EniPreview::progressed, this, &SummaryStep::showFindings);
}

QWidget* SummaryStep::buildExport() {
  auto* area = new QWidget;
  auto* layout = new QHBoxLayout(area);
  layout->setContentsMargins(0, 0, 0, 0);
  export_ = named(new QCheckBox(tr("&Export the ENI to")), "wizardExport", tr("Export the ENI, too"));
  path_ = named(new QLineEdit, "wizardExportPath", tr("File of the ENI"));
  browse_ = named(new QPushButton(tr("Bro&wse…")), "wizardExportBrowse", tr("Choose the file of the ENI"));
  browse_->setAutoDefault(false);
  layout->addWidget(export_);
  layout->addWidget(path_, 1);
  layout->addWidget(browse_);
  for (auto* field : {static_cast<QWidget*>(path_), static_cast<QWidget*>(browse_)}) {
    field->setEnabled(false);
    connect(export_, &QCheckBox::toggled, field, &QWidget::setEnabled);
  }
  connect(export_, &QCheckBox::toggled, this, [this](bool on) {
    if (on && path_->text().isEmpty()) path_->setText(QStringLiteral("machine.eni.xml"));
  });
  connect(browse_, &QPushButton::clicked, this, &SummaryStep::browse);
  return area;
}

QWidget* SummaryStep::firstField() const { return table_; }

bool SummaryStep::keepsEnter() const { return browse_->hasFocus(); }

QString SummaryStep::exportPath() const {
  if (!export_->isChecked()) return {};
  auto path = path_->text().trimmed();
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".xml");
  return path;
}

QString SummaryStep::whyNotOn() const {
  if (!export_->isChecked()) return {};
  if (path_->text().trimmed().isEmpty()) return tr("The ENI needs a file name.");
  const QFileInfo file(exportPath());
  if (const auto status = mayWrite(exportPath()); !status) return errorText(status.error());
  return file.absoluteDir().exists() ? QString() : tr("There is no folder %1.").arg(file.absolutePath());
}

void SummaryStep::browse() {
  const auto path = askSaveName(this, tr("Export ENI"), path_->text(), tr("EtherCAT network information (*.xml)"));
  if (!path.isEmpty()) path_->setText(path);
}

void SummaryStep::showEvent(QShowEvent* event) {
  WizardStep::showEvent(event);
  workspace().eni().setWatched(true);
}

void SummaryStep::hideEvent(QHideEvent* event) {
  WizardStep::hideEvent(event);
  workspace().eni().setWatched(false);
}

void SummaryStep::refresh() {
  const auto& master = project().master;
  const auto* config = workspace().configuration().config();
  std::ptrdiff_t with_dc = 0;
  auto leader = tr("none");
  for (const auto& slave : config != nullptr ? config->slaves : std::vector<SlaveConfig>{}) {
    if (!slave.dc) continue;
    ++with_dc;
    if (slave.dc->reference_clock) leader = QString::fromStdString(slave.name);
  }
  slaves_->setText(tr("%1, with DC %2").arg(project().slaves.size()).arg(with_dc));
  cycle_->setText(cycleText(master.cycle_time));
  clock_->setText(master.dc.enabled ? leader : tr("distributed clocks are off"));
  mode_->setText(master.dc.enabled ? modeText(master.dc.dcm.mode) : noText());
  window_->setText(master.dc.enabled && master.dc.sync_window.enabled
                       ? tr("monitored, limit %1").arg(timeText(sync_window_limit_ns(master.dc.sync_window.exponent)))
                       : tr("not monitored"));
  fields().refresh();
  showFindings();
}

/// What the compiler says of the project, and the checker of the ENI that comes of it.
void SummaryStep::showFindings() {
  std::vector<Finding> all;
  const auto add = [&all](const std::vector<Finding>& findings) {
    for (auto& [finding, slaves] : folded(findings)) all.push_back(std::move(finding));
  };
  const auto& result = workspace().configuration().result();
  if (result) add(result->findings);
  const auto& eni = workspace().eni();
  if (eni.isCurrent() && eni.check()) add(eni.check()->findings);
  std::ranges::stable_sort(all, std::ranges::greater{}, &Finding::severity);
  findings_->setFindings(all);
  const auto errors = findings_->count(Severity::kError);
  const auto warnings = findings_->count(Severity::kWarning);
  if (!result) return verdict_->setText(errorText(result.error()));
  if (!eni.isCurrent() || !eni.check()) return verdict_->setText(tr("The ENI is being checked…"));
  if (all.empty()) return verdict_->setText(tr("The check of project and ENI found nothing."));
  const auto parts = QStringList{tr("%n error(s)", nullptr, errors), tr("%n warning(s)", nullptr, warnings),
                                 tr("%n note(s)", nullptr, static_cast<int>(all.size()) - errors - warnings)};
  verdict_->setText(tr("The check of project and ENI found: %1.").arg(joinedParts(parts)));
}

}  // namespace syncline::ui
