// SPDX-License-Identifier: Apache-2.0
#include "ui/panels/fault_banner.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "findings/finding.h"
#include "record/run_record.h"
#include "trace/fault_log.h"
#include "trace/sync_overview.h"
#include "ui/text/overview_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/named.h"

namespace syncline::ui {
namespace {

/// An outline in the colour of what it tells, on its quiet fill.
void fillBanner(QWidget& banner, theme::Tone tone) {
  QPalette colors;  // of nothing else: the rest follows the theme, or a picture
  colors.setColor(QPalette::Window, theme::toneFill(banner.palette(), tone));
  banner.setPalette(colors);
  banner.setAutoFillBackground(true);
}

QToolButton* episodeButton(const char* name, const QString& text, const QString& tip) {
  auto* button = named(new QToolButton, name, tip);
  button->setText(text);
  button->setToolTip(tip);
  button->setAutoRaise(true);
  button->hide();
  return button;
}

}  // namespace

FaultBanner::FaultBanner(QWidget* parent)
    : QFrame(parent),
      text_(named(new QLabel, "overviewFault", tr("First fault"))),
      earlier_(episodeButton("overviewEarlier", QStringLiteral("\u2039"), tr("The episode before"))),
      later_(episodeButton("overviewLater", QStringLiteral("\u203A"), tr("The next episode"))),
      row_(new QHBoxLayout(this)) {
  setObjectName(QStringLiteral("overviewBanner"));
  setAccessibleName(tr("First fault"));
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextBrowserInteraction);
  connect(text_, &QLabel::linkActivated, this, [this](const QString& link) { Q_EMIT momentWanted(link.toLongLong()); });
  connect(earlier_, &QToolButton::clicked, this, [this] { turn(-1); });
  connect(later_, &QToolButton::clicked, this, [this] { turn(1); });
  row_->setContentsMargins(10, 5, 8, 5);
  row_->addWidget(text_, 1);
  row_->addWidget(earlier_);
  row_->addWidget(later_);
}

void FaultBanner::addButton(QWidget* button) { row_->addWidget(button); }

void FaultBanner::turn(int by) {
  const auto wanted = by < 0 ? shown_ - 1 : shown_ + 1;
  chosen_ = wanted >= count_ ? std::nullopt : std::optional(wanted);
  Q_EMIT turned();
}

std::size_t FaultBanner::place(const FaultLog& log) {
  const auto size = log.episodes().size();
  // They have begun anew.
  if (log.count() < count_) chosen_.reset();
  count_ = log.count();
  if (size == 0) {
    shown_ = 0;
    return 0;
  }
  const auto oldest = count_ - size + 1;
  shown_ = std::clamp(chosen_.value_or(count_), oldest, count_);
  return static_cast<std::size_t>(shown_ - oldest);
}

void FaultBanner::show(const RunRecord& record, std::span<const Finding> findings) {
  const auto& overview = record.overview();
  const bool found = worstOf(findings, overview.armed.value_or(0)) != nullptr;
  auto tone = found ? theme::Tone::kWarning : theme::Tone::kNeutral;
  if (overview.armed) {
    if (!found) tone = theme::Tone::kGood;
    if (!overview.faults.episodes().empty()) tone = theme::Tone::kBad;
  }
  fillBanner(*this, tone);
  const auto episode = place(overview.faults);
  const auto several = overview.armed && overview.faults.episodes().size() > 1;
  for (auto* button : {earlier_, later_}) button->setVisible(several);
  earlier_->setEnabled(episode > 0);
  later_->setEnabled(shown_ < count_);
  setText(firstFaultText(record, findings, episode));
}

void FaultBanner::showNothing(const QString& text) {
  fillBanner(*this, theme::Tone::kNeutral);
  for (auto* button : {earlier_, later_}) button->hide();
  chosen_.reset();
  shown_ = count_ = 0;
  setText(text);
}

QString FaultBanner::text() const { return text_->text(); }

void FaultBanner::setText(const QString& text) {
  if (text_->text() != text) text_->setText(text);
}

bool FaultBanner::event(QEvent* event) {
  const bool done = QFrame::event(event);
  if (event->type() == QEvent::PaletteChange) {
    // Rich text keeps the colour that links had when it was set.
    const auto text = text_->text();
    text_->clear();
    text_->setText(text);
  }
  return done;
}

}  // namespace syncline::ui
