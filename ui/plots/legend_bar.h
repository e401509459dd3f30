// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "ui/plots/series_item.h"
#include "ui/plots/signal_source.h"

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
    std::optional<SignalSource> source{};  // what it is of, of the run or of what lies over it
    bool of_overlay = false;
    bool operator==(const Entry&) const = default;
  };

  explicit LegendBar(QWidget* parent = nullptr);
  void setEntries(std::vector<Entry> entries);
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  /// What else there is to know of an entry; asked when somebody wants to know.
  void setAbout(std::function<QString(const Entry&)> about) { about_ = std::move(about); }
  /// A line an entry: name, value and, below it, what else there is to know.
  [[nodiscard]] QString about() const;
  /// "largest 35 ns; 2 Drive +12 ns".
  [[nodiscard]] QString text() const;
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  [[nodiscard]] QStringList parts() const;
  enum class Names : unsigned char { kWhole, kElided, kShort };
  [[nodiscard]] QString shownName(const Entry& entry, Names names) const;
  [[nodiscard]] int widthOf(std::size_t entry, Names names) const;
  /// The longest names with which all entries have room; else the shortest.
  [[nodiscard]] Names namesThatFit() const;

  std::vector<Entry> entries_;
  /// Of the values of an entry the widest of late, so that its neighbours do not move with its digits.
  struct Room {
    int latest = 0, before = 0;  // of the present stretch of updates, and the one before
    [[nodiscard]] int width() const { return latest > before ? latest : before; }
  };
  std::vector<Room> rooms_;
  int updates_ = 0;
  std::function<QString(const Entry&)> about_;
};

}  // namespace syncline::ui
