// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "ui/theme/theme.h"

namespace syncline::ui {

/// A state as text on a quiet colour with a mark before it, so that it does not live by colour alone.
class Pill final : public QWidget {
  Q_OBJECT

 public:
  explicit Pill(QWidget* parent = nullptr);
  void setState(theme::Tone tone, const QString& text);
  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] theme::Tone tone() const { return tone_; }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  /// What is painted at its width; the tool tip has the rest.
  [[nodiscard]] QString shown() const;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  theme::Tone tone_ = theme::Tone::kNeutral;
  QString text_;
};

}  // namespace syncline::ui
