// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QLabel>

namespace syncline::ui {

/// A value that can be selected and copied. What does not fit gives way to its shorter form, or ends in an ellipsis,
/// behind a whole figure where several stand in a row with three spaces or a dot in the middle between; the tool tip
/// has all of it.
class ValueLabel final : public QLabel {
  Q_OBJECT

 public:
  using QLabel::QLabel;
  /// As many characters of it are always painted, where it has so many; 48 unless said otherwise, which cards widen for
  /// and every ordinary value has.
  void setLeastCharacters(int count);
  /// The text and what stands for it where it does not fit, a figure without its moment: an ellipsis within a number
  /// would make another one of it.
  void setText(const QString& text, const QString& shorter);
  using QLabel::setText;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// What is painted at the label's width.
  [[nodiscard]] QString shown() const;
  /// Tool tip, with the whole text in front where that is not painted.
  [[nodiscard]] QString hint() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  int least_characters_ = 48;
  QString shorter_, shortened_;  // and the text whose shorter form it is
};

}  // namespace syncline::ui
