// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/stability_view.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "record/run_record.h"
#include "ui/panels/mask_chooser.h"
#include "ui/panels/signal_chooser.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/plot_colors.h"
#include "ui/plots/time_view.h"
#include "ui/text/stability_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/spoken_value.h"
#include "ui/widgets/value_label.h"

namespace syncline::ui {
namespace {

constexpr std::size_t kCopiedATick = 500'000;  // samples: some milliseconds, into memory that nobody has touched
constexpr int kWordsWidth = 300;

/// Times that come at even distances, and variables. What comes only when something is late has none.
bool isEven(const SignalInfo& row) {
  return (row.unit == "ns" && row.id != Signal::kFrameLateBy) || row.id == Signal::kVariable;
}

}  // namespace

StabilityView::StabilityView(const TimeView* view, const CursorSet* cursors, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("stabilityView"));
  setAccessibleName(tr("Stability"));
  signals_ = named(new SignalChooser(isEven), "stabilitySignals", tr("Signals of the stability"));
  figure_ = named(new QComboBox, "stabilityFigure", tr("Figure"));
  figure_->addItems({tr("ADEV"), tr("TDEV"), tr("MTIE"), tr("Spectrum")});
  const QStringList tips{tr("Allan deviation: how much the rate changes from one observation time to the next"),
                         tr("Time deviation: how far averages over an observation time stray from an even course"),
                         tr("Maximum time interval error: the largest peak-to-peak value in any observation time"),
                         tr("Amplitude of each frequency")};
  for (int i = 0; i < figure_->count(); ++i) figure_->setItemData(i, tips[i], Qt::ToolTipRole);
  mask_ = new MaskChooser;
  range_ = named(new SampleRange(view, cursors), "stabilityRange", tr("Samples that count"));
  state_ = named(new ValueLabel, "stabilityState", tr("State of the stability"));
  state_->setLeastCharacters(4);
  plot_ = named(new LogLogPlot, "stabilityPlot", tr("Stability"));
  words_ = named(new QTextBrowser, "stabilityWords", tr("What the curves say"));
  words_->setOpenLinks(false);
  words_->setFrameShape(QFrame::NoFrame);
  words_->setFixedWidth(kWordsWidth);
  words_->viewport()->setAutoFillBackground(false);
  words_->document()->setDocumentMargin(2);
  connect(signals_, &SignalChooser::changed, this, [this] {
    signals_chosen_ = true;
    // Times and variables have no axis in common: what was chosen last stays.
    const auto kind = sources().empty() || isVariable(sources().back());
    const auto other = [kind](const SignalSource& source) { return isVariable(source) != kind; };
    if (!sources().empty() && std::ranges::any_of(sources(), other)) {
      auto alike = sources();
      std::erase_if(alike, other);
      return signals_->setSources(std::move(alike));
    }
    refresh();
  });
  connect(signals_, &SignalChooser::variablesWanted, this, &StabilityView::variablesWanted);
  const auto draw_anew = [this] {
    dirty_ = true;
    refresh();
  };
  connect(figure_, &QComboBox::currentIndexChanged, this, [this, draw_anew] {
    mask_->setEnabled(figure() != Figure::kSpectrum);
    draw_anew();
  });
  connect(mask_, &MaskChooser::changed, this, draw_anew);
  connect(range_, &QComboBox::currentIndexChanged, this, [this] {
    forget();
    refresh();
  });
  const auto choose = [this, draw_anew](int curve) {
    chosen_ = curve;
    draw_anew();
  };
  connect(plot_, &LogLogPlot::curveChosen, this, choose);
  connect(words_, &QTextBrowser::anchorClicked, this, [choose](const QUrl& url) { choose(url.path().toInt()); });
  connect(&worker_, &StudyWorker::finished, this, &StabilityView::take);
  auto* controls = new QHBoxLayout;
  controls->setSpacing(6);
  for (QWidget* widget : {static_cast<QWidget*>(signals_), static_cast<QWidget*>(figure_), static_cast<QWidget*>(mask_),
                          static_cast<QWidget*>(range_)})
    controls->addWidget(widget);
  controls->addWidget(state_, 1);
  auto* body = new QHBoxLayout;
  body->setSpacing(8);
  body->addWidget(plot_, 1);
  body->addWidget(words_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addLayout(controls);
  layout->addLayout(body, 1);
}

void StabilityView::setRecord(const RunRecord* record, bool recorded) {
  forget();
  record_ = record;
  signals_->setRecord(record, recorded);
}

void StabilityView::setSources(std::vector<SignalSource> sources) { signals_->setSources(std::move(sources)); }
void StabilityView::setFigure(Figure figure) { figure_->setCurrentIndex(static_cast<int>(figure)); }
StabilityView::Figure StabilityView::figure() const { return static_cast<Figure>(figure_->currentIndex()); }

/// Until somebody chooses: a slave's deviation, which has a sign; where no slave tells one, the largest of all.
void StabilityView::chooseFirst() {
  if (signals_chosen_ && !sources().empty()) return;
  SignalSource first;
  for (std::size_t slave = 0; slave < record_->samples().slave_count(); ++slave) {
    const SignalSource source{Signal::kSlaveDeviation, slave};
    if (seriesOf(*record_, source).empty()) continue;
    first = source;
    break;
  }
  if (sources() == std::vector{first}) return;
  const QSignalBlocker quiet(signals_);
  signals_->setSources({first});
}

void StabilityView::forget() {
  gathering_.drop();
  worker_.drop();
  job_.reset();
  studied_.clear();
  dirty_ = true;
}

/// Figures are of one stretch, or of one that has moved on since by less than `slack`.
bool StabilityView::suits(const Stretch& done, const Stretch& wanted, Nanoseconds slack) const {
  return std::abs(done.begin - wanted.begin) <= slack && std::abs(done.end - wanted.end) <= slack;
}

/// Figures of signals that are still wanted stay; what is being made of others is dropped.
void StabilityView::follow(const Stretch& wanted) {
  std::vector<Studied> studied;
  for (const auto& source : sources()) {
    const auto known = std::ranges::find(studied_, source, &Studied::source);
    studied.push_back(known == studied_.end() ? Studied{source, {}, nullptr} : *known);
  }
  const bool same = std::ranges::equal(studied, studied_, {}, &Studied::source, &Studied::source);
  if (!same) dirty_ = true;
  studied_ = std::move(studied);
  chosen_ = std::clamp(chosen_, 0, std::max(static_cast<int>(studied_.size()) - 1, 0));
  if (!job_) return;
  const bool asked = std::ranges::find(sources(), job_->source) != sources().end();
  if (asked && suits(job_->stretch, wanted, std::max(2 * kSecond, (wanted.end - wanted.begin) / 5))) return;
  gathering_.drop();
  worker_.drop();
  job_.reset();
}

void StabilityView::startNext(const Stretch& wanted) {
  // While time goes on, figures are made anew once in a while; where it stands, they are of all that is wanted.
  const auto slack = wanted == wanted_ ? 0 : std::max(kSecond, (wanted.end - wanted.begin) / 20);
  wanted_ = wanted;
  if (job_ || worker_.isBusy() || wanted.end <= wanted.begin) return;
  const auto stale = std::ranges::find_if(studied_, [&](const Studied& studied) {
    return studied.study == nullptr || !suits(studied.stretch, wanted, slack);
  });
  if (stale == studied_.end()) return;
  job_ = Studied{stale->source, wanted, nullptr};
  gathering_.aim(seriesOf(*record_, job_->source), wanted.begin, wanted.end,
                 record_->samples().longest_gap(job_->source.signal));
}

void StabilityView::refresh() {
  if (record_ == nullptr || record_->samples().empty()) return;
  chooseFirst();
  const auto wanted = range_->of(*record_);
  // The cursors between which it was are gone.
  if (wanted.end <= wanted.begin && !studied_.empty()) forget();
  follow(wanted);
  startNext(wanted);
  if (job_ && !worker_.isBusy() && gathering_.work(kCopiedATick)) {
    const auto longest = gathering_.longest();
    worker_.start(gathering_.take(), longest, isVariable(job_->source) ? 1 : kNanosecond);
  }
  if (std::exchange(dirty_, false)) draw();
  showState();
}

void StabilityView::take(std::shared_ptr<const SignalStudy> study) {
  if (!job_) return;
  for (auto& studied : studied_) {
    if (studied.source == job_->source) studied = {job_->source, job_->stretch, std::move(study)};
  }
  job_.reset();
  dirty_ = true;
}

bool StabilityView::complete() const {
  return !job_ && !dirty_ && std::ranges::all_of(studied_, [this](const Studied& studied) {
    return studied.study != nullptr && suits(studied.stretch, wanted_, 0);
  });
}

bool StabilityView::ofVariables() const { return !sources().empty() && isVariable(sources().front()); }

/// Of what varies.
Quantity StabilityView::quantity() const { return ofVariables() ? Quantity::kRatio : Quantity::kNanoseconds; }

LogLogPlot::Axes StabilityView::axes() const {
  switch (figure()) {
    case Figure::kAdev:
      return {Quantity::kSeconds, Quantity::kRatio, tr("ADEV over the observation time \u03C4")};
    case Figure::kTdev:
      return {Quantity::kSeconds, quantity(), tr("TDEV over the observation time \u03C4")};
    case Figure::kMtie:
      return {Quantity::kSeconds, quantity(), tr("MTIE over the observation time \u03C4")};
    case Figure::kSpectrum:
      break;
  }
  return {Quantity::kHertz, quantity(), tr("Amplitude over the frequency")};
}

LogLogPlot::Curve StabilityView::curveOf(const Studied& studied, int number) const {
  LogLogPlot::Curve curve{nameOf(*record_, studied.source), plot_colors::trace(palette(), number), {}, {}, false};
  if (studied.study == nullptr) return curve;
  const auto mask = maskOf(studied.source);
  for (const auto& point : studied.study->points) {
    const double value = figure_of(point, maskedFigure());
    if (!(value > 0)) continue;
    const auto allowed = mask.at(point.tau);
    curve.line.emplace_back(point.tau, value);
    curve.stops.push_back({curve.line.back(), tr("%1 windows of \u03C4").arg(countText(point.windows)),
                           point.windows < kGoodWindows, allowed && value > *allowed});
  }
  return curve;
}

std::vector<KnownFrequency> StabilityView::knownFrequencies(const Studied& studied) const {
  const auto drift = record_->samples().series(Signal::kDrift).at(studied.stretch.end);
  return known_frequencies(record_->config(), record_->limits().cycle_time,
                           drift ? static_cast<double>(drift->value) : 0);
}

LogLogPlot::Curve StabilityView::spectrumOf(const Studied& studied, int number) const {
  LogLogPlot::Curve curve{nameOf(*record_, studied.source), plot_colors::trace(palette(), number), {}, {}, true};
  if (studied.study == nullptr) return curve;
  const auto& spectrum = studied.study->spectrum;
  const auto known = knownFrequencies(studied);
  // The first two amplitudes are what the window leaves of a constant and a slope.
  for (std::size_t i = 2; i < spectrum.amplitudes.size(); ++i) {
    if (spectrum.amplitudes[i] > 0)
      curve.line.emplace_back(static_cast<double>(i) * spectrum.step, spectrum.amplitudes[i]);
  }
  for (const auto& peak : spectrum.peaks)
    curve.stops.push_back({{peak.frequency, peak.amplitude}, causeText(peak, known, *studied.study), false});
  return curve;
}

void StabilityView::draw() {
  std::vector<LogLogPlot::Curve> curves;
  QStringList names;
  for (int i = 0; i < static_cast<int>(studied_.size()); ++i) {
    const auto& studied = studied_[static_cast<std::size_t>(i)];
    curves.push_back(figure() == Figure::kSpectrum ? spectrumOf(studied, i) : curveOf(studied, i));
    const auto name = curves.back().name.toHtmlEscaped().replace(u' ', QStringLiteral("&nbsp;"));
    names << QStringLiteral("<span style=\"color:%1\">\u25A0</span>&nbsp;%2")
                 .arg(curves.back().color.name(), i == chosen_
                                                      ? QStringLiteral("<b>%1</b>").arg(name)
                                                      : QStringLiteral("<a href=\"%1\">%2</a>").arg(i).arg(name));
  }
  auto html = paragraphText(names.join(QStringLiteral("&nbsp; ")));
  if (!studied_.empty()) html += wordsOf(studied_[static_cast<std::size_t>(chosen_)]);
  plot_->setData(axes(), std::move(curves), studied_.empty() ? LogLogPlot::Limit{} : limit(), chosen_);
  if (html == std::exchange(html_, html)) return;
  const int place = words_->verticalScrollBar()->value();
  words_->setHtml(html);
  words_->verticalScrollBar()->setValue(place);
  sayValue(*plot_, words());
}

void StabilityView::showState() {
  auto text = range_->lack(*record_);
  const auto missing = std::ranges::count(studied_, nullptr, &Studied::study);
  const bool far = std::ranges::any_of(studied_, [this](const Studied& studied) {
    return !suits(studied.stretch, wanted_, std::max(2 * kSecond, (wanted_.end - wanted_.begin) / 5));
  });
  if (text.isEmpty() && job_ && (missing > 0 || far)) {
    const auto all = std::max(static_cast<double>(studied_.size()), 1.0);
    const double done = all - static_cast<double>(std::max<std::ptrdiff_t>(missing, 1)) + gathering_.progress() / 2;
    text = tr("Computing, %1 %").arg(static_cast<int>(100 * done / all));
  }
  state_->setText(text);
}

QString StabilityView::words() const { return words_->toPlainText(); }

void StabilityView::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) dirty_ = true;
}

}  // namespace syncline::ui
