// SPDX-License-Identifier: Apache-2.0
#include <QComboBox>
#include <algorithm>

#include "record/run_record.h"
#include "trace/stability.h"
#include "ui/panels/mask_chooser.h"
#include "ui/panels/stability_view.h"
#include "ui/text/joined_text.h"
#include "ui/text/stability_text.h"
#include "ui/text/units.h"

/// What the stability is held against, and what its curves say.
namespace syncline::ui {

QString StabilityView::paragraphText(const QString& html) {
  return QStringLiteral("<p style=\"margin:2px 0 2px 0\">") + html + QStringLiteral("</p>");
}

bool StabilityView::isVariable(const SignalSource& source) { return source.signal == Signal::kVariable; }

StabilityFigure StabilityView::maskedFigure() const {
  if (figure() == Figure::kAdev) return StabilityFigure::kAdev;
  return figure() == Figure::kTdev ? StabilityFigure::kTdev : StabilityFigure::kMtie;
}

/// The most that the figure can be while every value keeps the limit; 0 without one. A magnitude has half the room.
double StabilityView::bound(const SignalSource& source) const {
  const double limit = limitOf(record_->limits(), source.signal) * (isMagnitude(source.signal) ? 0.5 : 1);
  if (limit <= 0 || (figure() != Figure::kMtie && figure() != Figure::kTdev)) return 0;
  return figure_of(stability_bound(limit, 1, kNanosecond), maskedFigure());
}

/// "\u00B1127 ns"; of a magnitude without the signs.
QString StabilityView::limitName(const SignalSource& source) const {
  const auto text = quantityText(Quantity::kNanoseconds, limitOf(record_->limits(), source.signal));
  return isMagnitude(source.signal) ? text : u'\u00B1' + text;
}

StabilityMask StabilityView::maskOf(const SignalSource& source) const {
  if (figure() == Figure::kSpectrum) return {};
  switch (mask_->kind()) {
    case MaskChooser::Kind::kLimit: {
      const double most = bound(source);
      return most > 0 ? StabilityMask{{{0, most}}} : StabilityMask{};
    }
    case MaskChooser::Kind::kCycle: {
      if (isVariable(source)) return {};
      const double room = static_cast<double>(record_->limits().cycle_time) / MaskChooser::kPartOfCycle;
      return mask_of_limit(room * (isMagnitude(source.signal) ? 0.5 : 1), maskedFigure(), kNanosecond);
    }
    case MaskChooser::Kind::kOwn:
      return mask_->own(maskedFigure());
  }
  return {};
}

/// Over the observation times that are drawn.
LogLogPlot::Limit StabilityView::limit() const {
  const auto& studied = studied_[static_cast<std::size_t>(chosen_)];
  if (mask_->kind() == MaskChooser::Kind::kLimit) {
    const double most = bound(studied.source);
    if (most <= 0) return {};
    return {most,
            tr("at most %1, limit %2").arg(quantityText(Quantity::kNanoseconds, most), limitName(studied.source))};
  }
  const auto mask = maskOf(studied.source);
  if (mask.empty() || studied.study == nullptr || studied.study->points.empty()) return {};
  LogLogPlot::Limit limit{0, mask_->kind() == MaskChooser::Kind::kCycle ? tr("1/25 of the cycle") : tr("own mask")};
  const auto add = [&](double tau) {
    if (const auto value = mask.at(tau)) limit.line.emplace_back(tau, *value);
  };
  const double from = studied.study->points.front().tau, to = studied.study->points.back().tau;
  add(from);
  for (const auto& point : mask.points) {
    if (point.tau > from && point.tau < to) add(point.tau);
  }
  if (to > from) add(to);
  for (const auto& point : limit.line) limit.value = std::max(limit.value, point.y());
  return limit.line.empty() ? LogLogPlot::Limit{} : limit;
}

/// What comes out where the figure is held against a mask that somebody chose.
QString StabilityView::maskText(const Studied& studied) const {
  if (figure() == Figure::kSpectrum || mask_->kind() == MaskChooser::Kind::kLimit) return {};
  const auto problem = mask_->kind() == MaskChooser::Kind::kOwn ? mask_->problem(maskedFigure()) : QString();
  if (!problem.isEmpty()) return problem;
  const auto mask = maskOf(studied.source);
  if (mask.empty()) return tr("There is no mask yet.");
  const auto verdict = hold_against(studied.study->points, maskedFigure(), mask);
  if (!verdict.tightest) return tr("The mask asks nothing at the observation times that are shown.");
  const auto what = figure() == Figure::kAdev ? Quantity::kRatio : quantity();
  const auto tau = [](const MaskVerdict::Place& place) { return quantityText(Quantity::kSeconds, place.tau); };
  const auto& tightest = *verdict.tightest;
  const auto value = quantityText(what, tightest.value), allowed = quantityText(what, tightest.allowed);
  if (verdict.beyond.empty()) {
    return tr("Keeps the mask; closest to it at \u03C4 %1: %2 of %3.").arg(tau(tightest), value, allowed);
  }
  return tr("Beyond the mask at %1 of %2 observation times, from \u03C4 %3 on; furthest at %4: %5 where %6 is allowed.")
      .arg(countText(verdict.beyond.size()), countText(verdict.compared), tau(verdict.beyond.front()), tau(tightest),
           value, allowed);
}

QString StabilityView::linesTable(const Studied& studied) const {
  const auto& spectrum = studied.study->spectrum;
  if (spectrum.step <= 0) return paragraphText(tr("Too few samples without a gap for a spectrum."));
  if (spectrum.peaks.empty()) return paragraphText(tr("No line stands out."));
  const auto known = knownFrequencies(studied);
  auto html = QStringLiteral("<table cellspacing=\"0\" cellpadding=\"1\">");
  int number = 0;
  for (const auto& peak : spectrum.peaks) {
    const auto cause = causeText(peak, known, *studied.study);
    html += QStringLiteral(
                "<tr><td>%1&nbsp;</td><td align=\"right\">%2&nbsp;</td><td align=\"right\">%3&nbsp;&nbsp;"
                "</td><td>%4</td></tr>")
                .arg(++number)
                .arg(quantityText(Quantity::kHertz, peak.frequency), quantityText(quantity(), peak.amplitude),
                     cause.isEmpty() ? noText() : cause.toHtmlEscaped());
  }
  return html + QStringLiteral("</table>") +
         paragraphText(tr("Lines are named by their frequency alone: a hint, no proof."));
}

QStringList StabilityView::sentences(const Studied& studied) const {
  const auto& study = *studied.study;
  QStringList said;
  if (figure() != Figure::kSpectrum || study.used == 0) said << verdictText(study, quantity());
  const double limit = limitOf(record_->limits(), studied.source.signal);
  said << maskText(studied);
  const bool by_limit = figure() == Figure::kMtie && mask_->kind() == MaskChooser::Kind::kLimit;
  if (by_limit && limit > 0) said << limitText(study, bound(studied.source), limitName(studied.source));
  if (by_limit && limit <= 0) said << tr("No limit is set that this signal could be held against.");
  if (isMagnitude(studied.source.signal) && study.used > 0)
    said << tr("A magnitude, without a sign: a swing about zero shows at half its period.");
  said << asSentence(sampleText(study));
  if (figure() == Figure::kSpectrum && study.spectrum.step > 0) {
    said << tr("%1 windows averaged, one amplitude each %2.")
                .arg(countText(study.spectrum.windows), quantityText(Quantity::kHertz, study.spectrum.step));
  } else if (const auto range = tauText(study); !range.isEmpty() && figure() != Figure::kSpectrum) {
    said << tr("%1; what is hollow rests on few windows of \u03C4.").arg(range);
  }
  said.removeAll(QString());
  return said;
}

QString StabilityView::wordsOf(const Studied& studied) const {
  if (studied.study == nullptr) return {};
  QString html;
  if (figure() == Figure::kSpectrum) html += linesTable(studied);
  for (const auto& sentence : sentences(studied)) html += paragraphText(sentence.toHtmlEscaped());
  return html;
}

}  // namespace syncline::ui
