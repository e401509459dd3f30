// SPDX-License-Identifier: Apache-2.0
#include "ui/pages/eni_line_delegate.h"

#include <QPainter>
#include <QTextLayout>
#include <QTextOption>
#include <algorithm>

#include "ui/models/eni_model.h"
#include "ui/pages/eni_text_view.h"
#include "ui/text/xml_spans.h"
#include "ui/theme/theme.h"

namespace syncline::ui {
namespace {

constexpr int kLineMargin = 4;
constexpr int kMarkedAlpha = 90;

theme::Tone toneOf(EniRowKind kind) {
  switch (kind) {
    case EniRowKind::kAdded:
      return theme::Tone::kGood;
    case EniRowKind::kRemoved:
    case EniRowKind::kBefore:
      return theme::Tone::kBad;
    case EniRowKind::kAltered:
      return theme::Tone::kWarning;
    case EniRowKind::kSame:
      break;
  }
  return theme::Tone::kNeutral;
}

QColor colorOf(XmlPiece piece, const QPalette& palette) {
  switch (piece) {
    case XmlPiece::kElement:
      return theme::toneColor(palette, theme::Tone::kAccent);
    case XmlPiece::kAttribute:
      return theme::toneColor(palette, theme::Tone::kWarning);
    case XmlPiece::kValue:
      return theme::toneColor(palette, theme::Tone::kGood);
    case XmlPiece::kPunctuation:
    case XmlPiece::kComment:
      return theme::mutedText(palette);
    case XmlPiece::kText:
      break;
  }
  return palette.color(QPalette::Text);
}

QTextLayout::FormatRange range(qsizetype start, qsizetype length, const QTextCharFormat& format) {
  return {static_cast<int>(start), static_cast<int>(length), format};
}

QList<QTextLayout::FormatRange> xmlFormats(const QString& text, const QPalette& palette) {
  QList<QTextLayout::FormatRange> formats;
  for (const auto& span : xmlSpans(text)) {
    QTextCharFormat format;
    format.setForeground(colorOf(span.piece, palette));
    if (span.piece == XmlPiece::kComment) format.setFontItalic(true);
    formats.append(range(span.start, span.length, format));
  }
  return formats;
}

/// What of `text` is not in `other`: all between the beginning and the end that both have.
QTextLayout::FormatRange altered(const QString& text, const QString& other, QColor color) {
  const auto most = std::min(text.size(), other.size());
  qsizetype front = 0, back = 0;
  while (front < most && text[front] == other[front]) ++front;
  while (back < most - front && text[text.size() - 1 - back] == other[other.size() - 1 - back]) ++back;
  color.setAlpha(kMarkedAlpha);
  QTextCharFormat format;
  format.setBackground(color);
  return range(front, text.size() - front - back, format);
}

QList<QTextLayout::FormatRange> formatsOf(const QModelIndex& index, const QString& text, EniRowKind kind,
                                          const QPalette& palette, bool selected, bool outdated) {
  QList<QTextLayout::FormatRange> formats;
  QTextCharFormat whole;
  const bool ghost = kind == EniRowKind::kRemoved || kind == EniRowKind::kBefore;
  if (selected) {
    whole.setForeground(palette.color(QPalette::HighlightedText));
  } else if (ghost || outdated || index.data(EniModel::kGapRole).toBool()) {
    whole.setForeground(theme::mutedText(palette));
  } else {
    formats = xmlFormats(text, palette);
  }
  whole.setFontStrikeOut(ghost);
  formats.append(range(0, text.size(), whole));
  const auto other = index.data(EniModel::kOtherRole).toString();
  if (!other.isEmpty() && !selected) formats.append(altered(text, other, theme::toneColor(palette, toneOf(kind))));
  return formats;
}

}  // namespace

void EniLineDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto kind = static_cast<EniRowKind>(index.data(EniModel::kKindRole).toInt());
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  const auto& palette = option.palette;
  painter->save();
  painter->setClipRect(option.rect);
  if (selected) {
    painter->fillRect(option.rect, palette.brush(QPalette::Highlight));
  } else if (kind != EniRowKind::kSame) {
    painter->fillRect(option.rect, theme::toneFill(palette, toneOf(kind)));
  }
  const auto text = index.data(Qt::DisplayRole).toString();
  if (index.column() == EniModel::kText) {
    QTextLayout layout(text, option.font);
    QTextOption wrap;
    wrap.setWrapMode(QTextOption::NoWrap);
    wrap.setTabStopDistance(2 * option.fontMetrics.horizontalAdvance(u' '));
    layout.setTextOption(wrap);
    const auto* view = qobject_cast<const EniTextView*>(option.widget);
    layout.setFormats(formatsOf(index, text, kind, palette, selected, view != nullptr && view->isOutdated()));
    layout.beginLayout();
    auto line = layout.createLine();
    layout.endLayout();
    const double free = option.rect.height() - line.height();
    layout.draw(painter, QPointF(option.rect.left() + kLineMargin, option.rect.top() + free / 2));
  } else {
    const bool mark = index.column() == EniModel::kChange;
    painter->setFont(option.font);
    painter->setPen(selected ? palette.color(QPalette::HighlightedText)
                    : mark   ? theme::toneColor(palette, toneOf(kind))
                             : theme::mutedText(palette));
    painter->drawText(option.rect.adjusted(0, 0, mark ? 0 : -kLineMargin, 0),
                      index.data(Qt::TextAlignmentRole).toInt() | Qt::TextSingleLine, text);
  }
  painter->restore();
}

}  // namespace syncline::ui
