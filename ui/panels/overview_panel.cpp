// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/overview_panel.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QStringList>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "record/recording.h"
#include "record/run_record.h"
#include "trace/slaves_standing.h"
#include "trace/sync_overview.h"
#include "ui/panels/fault_banner.h"
#include "ui/panels/figure_card.h"
#include "ui/panels/picture_file.h"
#include "ui/plots/signal_source.h"
#include "ui/text/glossary.h"
#include "ui/text/joined_text.h"
#include "ui/text/overview_text.h"
#include "ui/text/recorded_text.h"
#include "ui/text/sync_text.h"
#include "ui/text/units.h"
#include "ui/widgets/named.h"
#include "ui/widgets/pill.h"

namespace syncline::ui {
namespace {

constexpr int kOverviewTickMs = 200;  // faster cannot be read
constexpr double kThinMargin = 0.25;
enum : std::size_t { kMean, kRms, kQuantile, kMax };
enum : std::size_t { kWorst, kLast, kSince };

void addFigures(FigureCard& card) {
  card.addFigure(OverviewPanel::tr("mean"), OverviewPanel::tr("Since it was armed"));
  card.addFigure(OverviewPanel::tr("rms"), OverviewPanel::tr("Root mean square about zero, since it was armed"));
  card.addFigure(OverviewPanel::tr("p99.99"),
                 OverviewPanel::tr("Of 10,000 cycles one is larger; magnitude, since it was armed"));
  card.addFigure(OverviewPanel::tr("max"), OverviewPanel::tr("Largest magnitude of all cycles since it was armed"));
}

}  // namespace

OverviewPanel::OverviewPanel(QWidget* parent)
    : QWidget(parent),
      slaves_(named(new Pill, "overviewSlaves", tr("Slaves in sync"))),
      master_(named(new Pill, "overviewMaster", tr("Master in sync"))),
      slaves_text_(named(new QLabel, "overviewSlavesText", tr("Slaves: since when"))),
      master_text_(named(new QLabel, "overviewMasterText", tr("Master: since when"))),
      standing_(named(new QLabel, "overviewStanding", tr("Slaves in OP"))),
      banner_(new FaultBanner),
      deviation_(new FigureCard(
          "overviewDeviation", tr("DC deviation"),
          tr("Register 0x092C of the slaves that follow the reference clock: the largest. With \u2264 it is what the "
             "wire has or-ed of all of them: none is off by more, and perhaps none by so much"))),
      missed_(new FigureCard("overviewMissed", tr("SM2 events missed"),
                             tr("Object 0x1C32:0B or 0x1C32:0C of the slaves that have one, since it was armed"))),
      dcm_(new FigureCard("overviewDcm", tr("DCM error (raw)"),
                          tr("Time of the frame at the reference clock minus its wanted time in the cycle. The margin "
                             "is that of the filtered error as far as it has lasted for 200 ms: what is over before "
                             "is no loss of synchronisation"))),
      arm_(named(new QPushButton(tr("Re-arm")), "overviewArm", tr("Begin figures and faults anew"))),
      menu_(named(new QToolButton, "overviewMenuButton", tr("Export and copy"))) {
  setObjectName(QStringLiteral("overviewPanel"));
  setAccessibleName(tr("Overview"));
  addFigures(*deviation_);
  addFigures(*dcm_);
  missed_->addFigure(tr("worst"), tr("The slave that has missed most"));
  missed_->addFigure(tr("last"), tr("When one was missed last"));
  missed_->addFigure(tr("counted"), tr("For how long figures and faults have been counted"));
  auto* verdict = new FigureCard("overviewVerdict", tr("In sync?"), tr("The verdicts on slaves and master"));
  buildVerdict(*verdict);
  auto* cards = new QHBoxLayout;
  cards->setSpacing(8);
  // By what each has to say: shares that stay, whatever the figures are.
  cards->addWidget(verdict, 5);
  cards->addWidget(deviation_, 5);
  cards->addWidget(missed_, 3);
  cards->addWidget(dcm_, 6);
  connect(banner_, &FaultBanner::momentWanted, this, &OverviewPanel::momentWanted);
  connect(banner_, &FaultBanner::turned, this, &OverviewPanel::refresh);
  arm_->setAutoDefault(false);
  connect(arm_, &QPushButton::clicked, this, &OverviewPanel::armWanted);
  banner_->addButton(arm_);
  menu_->setText(QStringLiteral("\u22EF"));
  menu_->setToolTip(tr("Export and copy"));
  menu_->setAutoRaise(true);
  connect(menu_, &QToolButton::clicked, this, [this] { openMenu(menu_->mapToGlobal(menu_->rect().bottomLeft())); });
  banner_->addButton(menu_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 4);
  layout->setSpacing(6);
  layout->addWidget(banner_);
  layout->addLayout(cards, 1);
  tick_.setInterval(kOverviewTickMs);
  connect(&tick_, &QTimer::timeout, this, [this] {
    if (!window()->isMinimized()) refresh();
  });
  refresh();
}

void OverviewPanel::buildVerdict(QWidget& card) {
  auto* layout = qobject_cast<QVBoxLayout*>(card.layout());
  layout->setSpacing(0);  // it has the most lines, and a small window must hold them
  int place = 1;
  // Both lamps below each other, however long their names are.
  QLabel* const names[] = {new QLabel(tr("Slaves")), new QLabel(tr("Master"))};
  const int widest = std::max(names[0]->sizeHint().width(), names[1]->sizeHint().width());
  const auto add = [&](QLabel* name, Pill* pill, QLabel* text) {
    auto* row = new QHBoxLayout;
    name->setMinimumWidth(widest);
    row->addWidget(name);
    row->addWidget(pill);
    row->addStretch(1);
    text->setWordWrap(true);
    text->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->insertLayout(place++, row);
    layout->insertWidget(place++, text);
  };
  add(names[0], slaves_, slaves_text_);
  add(names[1], master_, master_text_);
  standing_->setWordWrap(true);
  standing_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  layout->insertWidget(place, standing_);
}

void OverviewPanel::setRecord(const RunRecord* record, bool recorded) {
  record_ = record;
  recorded_ = recorded;
  refresh();
}

void OverviewPanel::setLive(bool live) {
  live_ = live;
  refresh();
}

/// Now is the running machine's, or that of the moment of a recording that is shown.
bool OverviewPanel::hasNow() const { return live_ || (record_ != nullptr && record_->shown_at()); }

void OverviewPanel::showLamp(Pill& pill, QLabel& text, const SyncLamp& lamp,
                             const std::optional<SlavesStanding>& standing) {
  const bool any = record_ != nullptr && !record_->samples().empty();
  if (!any) {
    pill.setState(theme::Tone::kNeutral, live_ ? syncStateText(SyncState::kNotReady) : tr("Offline"));
    return text.clear();
  }
  const StateText verdict{syncTone(lamp.state), syncStateText(lamp.state)};
  const auto state = withSilent(verdict, standing);
  // What has ended says nothing about now.
  const bool silent = state.text != verdict.text;
  pill.setState(live_ || recorded_ ? state.tone : theme::Tone::kNeutral,
                hasNow() || silent ? state.text : tr("At the end: %1").arg(state.text));
  const auto since = lampText(lamp, record_->overview());
  text.setText(silent ? tr("the others: %1").arg(joinedParts({verdict.text, since})) : since);
}

void OverviewPanel::showStanding(const std::optional<SlavesStanding>& standing) {
  standing_->setVisible(standing.has_value());
  if (!standing) return;
  auto text = tr("%1 of %2 slaves in OP").arg(standing->in_op).arg(standing->slaves);
  if (standing->silent > 0)
    text = joinedParts({text, tr("%n do(es) not answer", nullptr, static_cast<int>(standing->silent))});
  if (standing_->text() != text) standing_->setText(text);
  const auto tone = standing->silent > 0                 ? theme::Tone::kBad
                    : standing->in_op < standing->slaves ? theme::Tone::kWarning
                                                         : theme::Tone::kGood;
  standing_tone_ = live_ || recorded_ ? tone : theme::Tone::kNeutral;
  colorStanding();
}

void OverviewPanel::colorStanding() {
  QPalette colors;  // of nothing else: the rest follows the theme, or a picture
  colors.setColor(QPalette::WindowText, theme::toneColor(palette(), standing_tone_));
  standing_->setPalette(colors);
}

void OverviewPanel::showFigure(FigureCard& card, const OverviewFigure& figure, Signal signal) {
  const bool is_signed = signal == Signal::kDcmError;
  const bool is_estimate = isUpperEstimate(*record_, signal);
  const auto magnitude = [is_estimate](double value) {
    const auto figure_text = timeText(wholeNs(value));
    return is_estimate ? atMostText(figure_text) : figure_text;
  };
  const auto text = [&](double value) { return is_signed ? signedTimeText(wholeNs(value)) : magnitude(value); };
  const auto last = record_->samples().last_time();
  const bool fresh = hasNow() && figure.now && last - figure.now->time <= record_->samples().longest_gap(signal);
  card.setMain(fresh ? text(static_cast<double>(figure.now->value)) : noText());
  const auto& statistics = figure.statistics;
  const bool any = statistics.count() > 0;
  const auto mean = any ? text(statistics.mean()) : noText();
  card.setFigure(kMean, any ? withSpreadText(mean, statistics.mean_half_width()) : mean, mean);
  card.setFigure(kRms, any ? magnitude(statistics.rms()) : noText());
  card.setFigure(kQuantile, any ? magnitude(static_cast<double>(figure.magnitudes.percentile(0.9999))) : noText());
  if (!figure.largest) return card.setFigure(kMax, noText());
  const auto largest = text(static_cast<double>(figure.largest->value));
  card.setFigure(kMax, tr("%1 at %2").arg(largest, momentText(figure.largest->time, *record_)), largest);
}

void OverviewPanel::showMargin(FigureCard& card, const std::optional<double>& margin, std::int64_t limit,
                               const SyncLamp& lamp, bool lasting) {
  if (limit <= 0) return card.setNote(theme::Tone::kNeutral, tr("no limit is set"));
  const bool lost = lamp.times_any_lost() > 0;
  const auto note = [&](theme::Tone tone, const QString& words) {
    const auto times = static_cast<int>(std::min<std::uint64_t>(lamp.times_any_lost(), INT32_MAX));
    card.setNote(lost ? theme::Tone::kBad : tone,
                 lost ? joinedParts({tr("lost %n time(s)", nullptr, times), words}) : words);
  };
  if (!margin) return note(theme::Tone::kNeutral, tr("limit \u00B1%1").arg(timeText(limit)));
  const auto judged = [&](theme::Tone tone, const QString& words) {
    note(tone, lasting ? tr("filtered, lasting: %1").arg(words) : words);
  };
  const auto percent = QLocale().toString(std::floor(std::abs(*margin) * 100), 'f', 0);
  if (*margin <= -1)
    return judged(theme::Tone::kBad,
                  tr("%1 times the limit \u00B1%2")
                      .arg(QLocale().toString(1 - *margin, 'f', *margin > -9 ? 1 : 0), timeText(limit)));
  if (*margin < 0) return judged(theme::Tone::kBad, tr("%1 % over the limit \u00B1%2").arg(percent, timeText(limit)));
  judged(*margin < kThinMargin ? theme::Tone::kWarning : theme::Tone::kGood,
         tr("%1 % margin to \u00B1%2").arg(percent, timeText(limit)));
}

void OverviewPanel::showMissed() {
  const auto& overview = record_->overview();
  const auto& missed = overview.missed;
  if (!missed.known) {
    missed_->setMain(noText());
    missed_->setNote(theme::Tone::kNeutral, tr("no slave has this counter"));
  } else if (!overview.armed) {
    missed_->setMain(noText());
    missed_->setNote(theme::Tone::kNeutral, tr("not counted yet"));
  } else {
    missed_->setMain(countText(missed.count));
    missed_->setNote(missed.count == 0 ? theme::Tone::kGood : theme::Tone::kWarning,
                     missed.count == 0 ? tr("none") : tr("SYNC0 came without new outputs"));
  }
  const auto worst = std::ranges::max_element(missed.by_slave);
  missed_->setFigure(kWorst, missed.count == 0 ? noText()
                                               : QString::fromStdString(record_->slave_name(
                                                     static_cast<std::size_t>(worst - missed.by_slave.begin()))) +
                                                     QStringLiteral(" ") + countText(*worst));
  missed_->setFigure(kLast, missed.last ? momentText(*missed.last, *record_) : noText());
  missed_->setFigure(kSince, overview.armed ? spanText(overview.end - *overview.armed) : noText());
}

void OverviewPanel::setFindings(std::vector<Finding> findings) {
  findings_ = std::move(findings);
  if (isVisible()) refresh();
}

void OverviewPanel::refresh() {
  const bool any = record_ != nullptr && !record_->samples().empty();
  arm_->setEnabled(any && !recorded_);
  arm_->setToolTip(recorded_ ? tr("A recording stays as it is")
                             : tr("Mean, rms, quantile, maximum, missed events and faults begin anew now"));
  static const SyncLamp kDark;
  const auto standing =
      any ? slaves_standing(record_->config(), record_->samples(), record_->overview()) : std::nullopt;
  showLamp(*slaves_, *slaves_text_, any ? record_->overview().slaves : kDark, standing);
  showLamp(*master_, *master_text_, any ? record_->overview().master : kDark, {});
  showStanding(standing);
  if (any) {
    const auto& overview = record_->overview();
    const auto& limits = record_->limits();
    showFigure(*deviation_, overview.deviation, Signal::kDeviation);
    showMargin(*deviation_, overview.deviation.margin(limits.deviation_ns), limits.deviation_ns, overview.slaves,
               false);
    showFigure(*dcm_, overview.dcm_error, Signal::kDcmError);
    showMargin(*dcm_, overview.dcm_lasting.margin(limits.dcm_error_ns), limits.dcm_error_ns, overview.master, true);
    showMissed();
    return banner_->show(*record_, findings_);
  }
  for (auto* card : {deviation_, missed_, dcm_}) {
    card->setMain(noText());
    card->setNote(theme::Tone::kNeutral, {});
    for (std::size_t i = 0; i < (card == missed_ ? kSince + 1 : kMax + 1); ++i) card->setFigure(i, noText());
  }
  banner_->showNothing(tr("Nothing has run yet: go online."));
}

Picture OverviewPanel::picture() {
  const bool any = record_ != nullptr && !record_->samples().empty();
  const auto begin = any ? record_->overview().armed.value_or(record_->overview().begin) : 0;
  const auto title = captionOf(any ? record_ : nullptr, begin, any ? record_->overview().end : 0);
  return captioned(
      *this, title,
      [this](QPainter& painter, const QPoint& place) {
        const auto colours = palette();
        const bool explicitly = testAttribute(Qt::WA_SetPalette);
        const QPointer<QWidget> focus = QApplication::focusWidget();
        setPalette(picturePalette());
        refresh();
        // What can be pressed is no part of it; its room stays, so that nothing moves.
        auto buttons = banner_->findChildren<QAbstractButton*>();
        buttons.removeIf([](const QAbstractButton* button) { return button->isHidden(); });
        for (auto* button : buttons) {
          auto keep = button->sizePolicy();
          keep.setRetainSizeWhenHidden(true);
          button->setSizePolicy(keep);
          button->hide();
        }
        render(&painter, place, {}, QWidget::DrawChildren);
        setPalette(explicitly ? colours : QPalette());
        refresh();
        for (auto* button : buttons) {
          auto usual = button->sizePolicy();
          usual.setRetainSizeWhenHidden(false);
          button->setSizePolicy(usual);
          button->show();
        }
        if (focus) focus->setFocus();
      },
      layout()->contentsMargins().left());
}

QString OverviewPanel::text() const {
  const auto plain = [](const QString& html) { return QTextDocumentFragment::fromHtml(html).toPlainText(); };
  QStringList lines{plain(banner_->text())};
  lines << QStringList{tr("Slaves"), slaves_->text(), slaves_text_->text()}.join(u'\t');
  lines << QStringList{tr("Master"), master_->text(), master_text_->text()}.join(u'\t');
  if (!standing_->isHidden()) lines << standing_->text();
  for (const auto* card : {deviation_, missed_, dcm_}) lines << card->lines();
  return lines.join(u'\n') + u'\n';
}

void OverviewPanel::openMenu(const QPoint& global) {
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("overviewMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  auto* whole = menu->addAction(tr("Export picture…"), this, [this] {
    exportPicture(this, tr("Export the overview"), QStringLiteral("overview.png"), [this] { return picture(); });
  });
  whole->setObjectName(QStringLiteral("actionExportOverview"));
  menu->addAction(tr("Copy picture"), this, [this] { copyPicture(picture()); });
  auto* figures = menu->addAction(tr("Copy figures"), this, [this] { QApplication::clipboard()->setText(text()); });
  figures->setObjectName(QStringLiteral("actionCopyFigures"));
  menu->popup(global);
}

void OverviewPanel::contextMenuEvent(QContextMenuEvent* event) { openMenu(event->globalPos()); }

/// Lines that wrap in a narrow window need their height, which a splitter does not ask for.
bool OverviewPanel::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
    setMinimumHeight(layout()->totalMinimumHeightForWidth(width()));
  if (event->type() == QEvent::PaletteChange) colorStanding();
  return done;
}

void OverviewPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
  tick_.start();
}

void OverviewPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  tick_.stop();
}

}  // namespace syncline::ui
