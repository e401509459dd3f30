// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/overlay_figures.h"

#include <QTextDocumentFragment>
#include <algorithm>
#include <cmath>

#include "record/run_record.h"
#include "ui/plots/signal_source.h"
#include "ui/plots/small_font.h"
#include "ui/text/units.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kOverlayPortion = 300'000;         // samples a tick, of all together: some milliseconds
constexpr int kNameWidth = 110, kLeastPlotHeight = 190;  // pixels
constexpr std::array kCompared{Signal::kDeviation, Signal::kDcmError};

}  // namespace

OverlayFigures::OverlayFigures(const TimeView* view, QWidget* parent) : QLabel(parent), view_(view) {
  setObjectName(QStringLiteral("overlayFigures"));
  setAccessibleName(tr("Figures of both recordings over the range shown"));
  setToolTip(tr("Of every cycle of the range shown, at the places where the two lie over each other"));
  setTextFormat(Qt::RichText);
  setTextInteractionFlags(Qt::TextSelectableByMouse);
  setFont(smallFont(font()));
  hide();
}

void OverlayFigures::setSources(const RunRecord* own, const TracePanel::Overlay& overlay) {
  own_ = own;
  overlay_ = overlay;
  for (auto& figures : figures_) figures.aim(nullptr, 0, 0);
  setVisible(own_ != nullptr && overlay_.record != nullptr);
  clear();
}

bool OverlayFigures::complete() const {
  return isHidden() || std::ranges::all_of(figures_, [](const StretchFigures& figures) { return figures.complete(); });
}

QString OverlayFigures::cells(const StretchFigures& figures, bool is_signed, bool is_estimate) const {
  const auto& statistics = figures.statistics();
  const auto ns = [](double value) { return static_cast<Nanoseconds>(std::llround(value)); };
  const auto text = [&](const QString& value) {
    return QStringLiteral("<td align=right>&nbsp;&nbsp;%1</td>").arg(value.toHtmlEscaped());
  };
  const auto magnitude = [is_estimate](Nanoseconds value) {
    return is_estimate ? atMostText(timeText(value)) : timeText(value);
  };
  if (statistics.count() == 0) return text(noText()) + text(noText()) + text(noText()) + text(noText());
  return text(is_signed ? signedTimeText(ns(statistics.mean())) : magnitude(ns(statistics.mean()))) +
         text(magnitude(ns(statistics.rms()))) + text(magnitude(figures.magnitudes().percentile(0.9999))) +
         text(magnitude(ns(statistics.max_magnitude())));
}

void OverlayFigures::refresh() {
  if (own_ == nullptr || overlay_.record == nullptr) return;
  // Where the plots have little room they have all of it.
  setVisible(parentWidget() == nullptr || parentWidget()->height() >= kLeastPlotHeight);
  if (!isVisible()) return;
  auto room = kOverlayPortion;
  for (std::size_t i = 0; i < figures_.size(); ++i) {
    const bool other = i >= kCompared.size();
    const auto& record = other ? *overlay_.record : *own_;
    const auto shift = other ? overlay_.shift : 0;
    const auto& series = record.samples().series(kCompared[i % kCompared.size()]);
    figures_[i].aim(&series, view_->begin() - shift, view_->end() + 1 - shift);
    (void)figures_[i].work(std::max<std::size_t>(room / (figures_.size() - i), 1));
  }
  const auto head = [](const QString& text) {
    return QStringLiteral("<td align=right>&nbsp;&nbsp;%1</td>").arg(text.toHtmlEscaped());
  };
  const auto names = head(tr("rms")) + head(tr("p99.99")) + head(tr("max"));
  const auto row = [this](const QString& name, const RunRecord& record, std::size_t first) {
    const bool is_estimate = isUpperEstimate(record, Signal::kDeviation);
    const auto shown = fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth).toHtmlEscaped();
    return QStringLiteral("<tr><td><b>%1</b></td>%2%3</tr>")
        .arg(shown, cells(figures_[first], false, is_estimate), cells(figures_[first + 1], true, false));
  };
  const auto now = QStringLiteral("<table cellspacing=0 cellpadding=0><tr><td></td>%1%3%2%3</tr>%4%5</table>")
                       .arg(head(tr("DC deviation: mean")), head(tr("DCM error: mean")), names,
                            row(overlay_.own, *own_, 0), row(overlay_.other, *overlay_.record, kCompared.size()));
  if (now == text()) return;
  setText(now);
  setAccessibleDescription(QTextDocumentFragment::fromHtml(now).toPlainText());
}

}  // namespace syncline::ui
