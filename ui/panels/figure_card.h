// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QFrame>
#include <QString>
#include <QStringList>
#include <vector>

#include "ui/theme/theme.h"

class QGridLayout;
class QLabel;

namespace syncline::ui {

class ValueLabel;

/// One quantity of the overview: a big figure, what is left of its limit, and small ones below.
class FigureCard final : public QFrame {
  Q_OBJECT

 public:
  FigureCard(const char* name, const QString& title, const QString& tool_tip, QWidget* parent = nullptr);
  /// A small figure; its number.
  std::size_t addFigure(const QString& label, const QString& tool_tip);
  void setMain(const QString& text);
  void setNote(theme::Tone tone, const QString& text);
  /// `shorter`: what is shown where the card has no room for all of it.
  void setFigure(std::size_t number, const QString& text, const QString& shorter = {});
  [[nodiscard]] QString mainText() const;
  [[nodiscard]] QString noteText() const;
  [[nodiscard]] QString figureText(std::size_t number) const;
  /// Name, big figure and note, then each small figure with its name: parted by tabulators.
  [[nodiscard]] QStringList lines() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void colorText();
  void say();

  QLabel *title_, *main_, *note_;
  QGridLayout* grid_;
  std::vector<QLabel*> labels_;
  std::vector<ValueLabel*> figures_;
  theme::Tone tone_ = theme::Tone::kNeutral;
};

}  // namespace syncline::ui
