// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <vector>

#include "ui/plots/series_item.h"

namespace syncline::ui {

/// One line: a swatch, a name and the present value of each trace. What does not fit is left out and
/// counted; the tool tip and the accessible description hold everything.
class LegendBar final : public QWidget {
  Q_OBJECT

 public:
  struct Entry {
    QString name, short_name, value;  // the short name where room is scarce; may be empty
    QColor color;
    SeriesItem::Shape shape = SeriesItem::Shape::kLine;
    bool operator==(const Entry&) const = default;
  };

  explicit LegendBar(QWidget* parent = nullptr);
  void setEntries(std::vector<Entry> entries);
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// "largest 35 ns; 2 Drive +12 ns".
  [[nodiscard]] QString text() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QStringList parts() const;
  enum class Names : unsigned char { kWhole, kElided, kShort };
  [[nodiscard]] QString shownName(const Entry& entry, Names names) const;
  [[nodiscard]] int widthOf(const Entry& entry, Names names) const;
  /// The longest names with which all entries have room; else the shortest.
  [[nodiscard]] Names namesThatFit() const;

  std::vector<Entry> entries_;
};

}  // namespace syncline::ui
