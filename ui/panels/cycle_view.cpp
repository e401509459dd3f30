// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/cycle_view.h"

#include <fmt/format.h>

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "ui/editors/choice_edit.h"
#include "ui/plots/signal_source.h"
#include "ui/session/calc_and_copy.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr unsigned kArrivalsEvery = 6;  // ticks: faster cannot be read

std::optional<Nanoseconds> calcAndCopyOf(const RunRecord& record, std::size_t slave) {
  const auto& told = record.snapshot().slaves;
  return calcAndCopy(record.config().slaves[slave].identity, slave < told.size() ? &told[slave].evidence : nullptr);
}

}  // namespace

CycleView::CycleView(const TimeView* view, QWidget* parent)
    : QWidget(parent),
      view_(view),
      slaves_(named(new ChoiceEdit, "cycleSlave", tr("Slave whose SYNC0 period is shown"))),
      figures_(named(new ValueLabel, "cycleFigures", tr("Margins and setpoint slips"))),
      plot_(named(new CyclePlot, "cyclePlot", tr("Arrivals in the SYNC0 period"))) {
  setObjectName(QStringLiteral("cycleView"));
  setAccessibleName(tr("Cycle"));
  figures_->setLeastCharacters(4);
  slaves_->setMinimumContentsLength(18);
  auto* head = new QHBoxLayout;
  head->setSpacing(12);
  head->addWidget(slaves_);
  head->addWidget(figures_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(head);
  layout->addWidget(plot_, 1);
  connect(slaves_, &ChoiceEdit::currentIndexChanged, this, [this] {
    ticks_ = 0;
    if (isVisible()) refresh();
  });
}

void CycleView::setRecord(const RunRecord* record) {
  record_ = record;
  ticks_ = 0;
  shown_.reset();
  const QSignalBlocker quiet(slaves_);
  slaves_->clear();
  plot_->setPicture({});
  figures_->clear();
  if (record == nullptr) return;
  for (std::size_t i = 0; i < record->samples().slave_count(); ++i) {
    if (record->samples().sync0(i).period > 0)
      slaves_->addItem(nameOf(*record, {Signal::kSlaveDeviation, i}), static_cast<int>(i));
  }
  slaves_->setEnabled(slaves_->count() > 0);
  if (slaves_->count() == 0) figures_->setText(tr("No slave with SYNC0 whose outputs can be followed"));
}

void CycleView::select(int slave) {
  if (const int row = slaves_->findData(slave); row >= 0) slaves_->setCurrentIndex(row);
}

int CycleView::slave() const { return slaves_->count() > 0 ? slaves_->currentData().toInt() : -1; }

void CycleView::refresh() {
  if (record_ == nullptr || slave() < 0 || ticks_++ % kArrivalsEvery != 0) return;
  const auto& samples = record_->samples();
  const auto position = static_cast<std::size_t>(slave());
  // Of a picture that stands nothing is counted again.
  const Shown shown{position, view_->begin(), view_->end(), samples.last_time()};
  if (std::optional(shown) == std::exchange(shown_, shown)) return;
  CyclePlot::Picture picture;
  picture.period = samples.sync0(position).period;
  picture.calc_and_copy = calcAndCopyOf(*record_, position);
  picture.begin = view_->begin();
  picture.end = view_->end() + 1;
  picture.figures = arrival_figures(samples.series(Signal::kArrivalPhase, position), picture.period, picture.begin,
                                    picture.end, CyclePlot::kBins);
  plot_->setPicture(std::move(picture));
  const auto text = figuresText();
  if (text == figures_->text()) return;
  figures_->setText(text);
  plot_->setAccessibleDescription(text);
}

QString CycleView::figuresText() const {
  const auto& picture = plot_->picture();
  const auto position = static_cast<std::size_t>(slave());
  const auto& figures = picture.figures;
  QStringList said;
  said << (figures.margin_min ? tr("margin at least %1").arg(timeText(*figures.margin_min)) : tr("no arrivals"));
  if (figures.margin_p999) said << tr("99.9 %: %1").arg(timeText(*figures.margin_p999));
  said << (picture.calc_and_copy ? tr("calculating and copying %1").arg(timeText(*picture.calc_and_copy))
                                 : tr("calculating and copying not known"));
  const auto slips = record_->samples().value(Signal::kSetpointSlips, position, view_->end());
  said << (slips ? tr("setpoint slips: %1").arg(countText(static_cast<std::uint64_t>(std::llround(slips->value))))
                 : tr("setpoint slips not known"));
  said << tr("SYNC0 %1, shift %2")
              .arg(cycleText(picture.period), signedTimeText(record_->samples().sync0(position).shift));
  return said.join(QStringLiteral(" \u00B7 "));
}

std::string CycleView::csv() const {
  std::string text = "from_ns,to_ns,arrivals\n";
  const auto& picture = plot_->picture();
  const auto bins = static_cast<Nanoseconds>(picture.figures.bins.size());
  for (Nanoseconds i = 0; i < bins; ++i) {
    fmt::format_to(std::back_inserter(text), "{},{},{}\n", i * picture.period / bins, (i + 1) * picture.period / bins,
                   picture.figures.bins[static_cast<std::size_t>(i)].count);
  }
  return text;
}

}  // namespace syncline::ui
