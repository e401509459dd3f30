// SPDX-License-Identifier: Apache-2.0
#include <QAction>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>

#include "support/whole_file.h"
#include "ui/files/save_name.h"
#include "ui/panels/csv_export.h"
#include "ui/panels/cycle_view.h"
#include "ui/panels/distribution_view.h"
#include "ui/panels/free_plot.h"
#include "ui/panels/free_view.h"
#include "ui/panels/live_strip.h"
#include "ui/panels/picture_file.h"
#include "ui/panels/slaves_view.h"
#include "ui/panels/stability_view.h"
#include "ui/plots/series_csv.h"
#include "ui/text/error_text.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

void tellUnwritten(QWidget* parent, const Status& status) {
  if (!status) QMessageBox::warning(parent, LiveStrip::tr("Export"), errorText(status.error()));
}

}  // namespace

std::string LiveStrip::csv() const {
  if (body_ == Body::kDistribution) return distribution_->csv();
  if (body_ == Body::kStability) return stability_->csv();
  if (body_ == Body::kSlaves) return slaves_->csv();
  if (body_ == Body::kCycle) return cycle_->csv();
  return series_csv(table(view_.begin(), view_.end()));
}

CsvTable LiveStrip::table(Nanoseconds from, Nanoseconds to) const {
  if (body_ == Body::kFree) return free_->table(from, to);
  return tableOfAll(from, to);
}

CsvTable LiveStrip::tableOfAll(Nanoseconds from, Nanoseconds to) const {
  std::vector<CsvColumn> columns;
  if (record_ == nullptr) return {columns, {}, 0, 0, 0};
  const auto& samples = record_->samples();
  using Scope = SignalInfo::Scope;
  for (const auto& signal : signals()) {
    // Made for all slaves at once it would take as much room as everything else; the distribution saves it.
    if (signal.form == SignalInfo::Form::kCell || signal.form == SignalInfo::Form::kDerived) continue;
    const auto count = signal.scope == Scope::kSlave      ? samples.slave_count()
                       : signal.scope == Scope::kVariable ? samples.watched().variables().size()
                                                          : 1;
    for (std::size_t number = 0; number < count; ++number) {
      const auto& series = samples.series(signal.id, number);
      if (series.empty()) continue;
      auto name = std::string(signal.key);
      if (signal.scope == Scope::kSlave) name += " " + record_->slave_name(number);
      if (signal.scope == Scope::kVariable) name = samples.watched().variables()[number].name;
      columns.push_back({std::move(name), &series});
    }
  }
  const auto cycle = [&samples](Nanoseconds time) { return samples.cycle_at(time); };
  return {std::move(columns), cycle, view_.origin(), from, to + 1};
}

Picture LiveStrip::picture() {
  const auto title = captionOf(record_, view_.begin(), view_.end());
  auto* shown = body_ == Body::kFree ? free_->canvas() : body();
  return captioned(*shown, title, [this, shown](QPainter& painter, const QPoint& place) {
    const auto colours = shown->palette();
    shown->setPalette(picturePalette());
    for (auto* panel : all_panels_) panel->applyTheme();
    if (body_ == Body::kDistribution) distribution_->refresh();
    if (body_ == Body::kStability) stability_->refresh();
    if (body_ == Body::kSlaves) slaves_->refresh();
    if (body_ == Body::kCycle) cycle_->refresh();
    if (body_ == Body::kFree) free_->setForPicture(true);
    renderWithoutControls(*shown, painter, place);
    if (body_ == Body::kFree) free_->setForPicture(false);
    shown->setPalette(colours);
    for (auto* panel : all_panels_) panel->applyTheme();
  });
}

void LiveStrip::exportCsv() {
  const auto path = askSaveName(this, tr("Export the range shown"), QStringLiteral("syncline.csv"),
                                tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  // A line a moment may be millions of lines; figures and cells are as many as are shown.
  if (body_ == Body::kPlots || body_ == Body::kFree) return exportTable(path, table(view_.begin(), view_.end()));
  tellUnwritten(this, write_whole_file(path.toStdString(), csv()));
}

void LiveStrip::exportTable(const QString& path, CsvTable table) {
  if (csv_export_ == nullptr) {
    csv_export_ = new CsvExport(this);
    connect(csv_export_, &CsvExport::failed, this, [this](const Error& error) {
      if (error.code != ErrorCode::kCancelled) tellUnwritten(this, tl::unexpected(error));
    });
  }
  csv_export_->start(path, std::move(table));
}

void LiveStrip::exportRange(Nanoseconds from, Nanoseconds to) {
  const auto path =
      askSaveName(this, tr("Export the episode"), QStringLiteral("episode.csv"), tr("Comma-separated values (*.csv)"));
  if (path.isEmpty()) return;
  exportTable(path, tableOfAll(from, to));
}

void LiveStrip::exportPicture() {
  ui::exportPicture(this, tr("Export the plots"), QStringLiteral("syncline.png"), [this] { return picture(); });
}

void LiveStrip::copyPicture() { ui::copyPicture(picture()); }

}  // namespace syncline::ui
