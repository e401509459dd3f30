// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <array>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "trace/distribution.h"
#include "ui/plots/cursor_item.h"
#include "ui/plots/histogram_plot.h"
#include "ui/plots/time_view.h"

class QComboBox;
class QLabel;
class QMenu;
class QTableWidget;
class QToolButton;

namespace syncline::ui {

/// How often which value came: histograms of up to four signals over the range that the plots show, between the
/// cursors, or since the figures were armed. Every sample counts. It counts a portion a tick, so that the window never
/// waits.
class DistributionView final : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = 4;
  struct Source {
    Signal signal = Signal::kDeviation;
    std::size_t slave = 0;
    bool operator==(const Source&) const = default;
  };
  enum class Range { kShown, kCursors, kArmed };

  DistributionView(const TimeView* view, const CursorSet* cursors, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the view or be replaced.
  void setRecord(const RunRecord* record);
  void setSources(std::vector<Source> sources);
  [[nodiscard]] const std::vector<Source>& sources() const { return sources_; }
  /// Counts a portion and draws what there is; once a tick while it is seen.
  void refresh();
  /// All that is wanted is counted.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] HistogramPlot* plot() const { return plot_; }
  /// Bins as a table; C locale.
  [[nodiscard]] std::string csv() const;

 Q_SIGNALS:
  /// The moment of a sample that was chosen.
  void momentChosen(syncline::Nanoseconds time);

 private:
  [[nodiscard]] const MinMaxSeries& series(const Source& source) const;
  [[nodiscard]] QString name(const Source& source) const;
  [[nodiscard]] double limit() const;
  [[nodiscard]] std::pair<Nanoseconds, Nanoseconds> range() const;
  [[nodiscard]] BinGrid gridFor(Nanoseconds begin, Nanoseconds end) const;
  void fillMenu();
  void addSource(QMenu& menu, const QString& text, const Source& source);
  void showFigures();
  void listBin(qint64 bin);

  const TimeView* view_;
  const CursorSet* cursors_;
  const RunRecord* record_ = nullptr;
  std::vector<Source> sources_;
  std::array<Distribution, kMost> counts_;
  BinGrid grid_;
  QToolButton* signals_;
  QComboBox *range_, *axis_;
  QLabel* state_;
  HistogramPlot* plot_;
  QTableWidget *figures_, *moments_;
};

}  // namespace syncline::ui
