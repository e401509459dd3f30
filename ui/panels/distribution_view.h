// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QColor>
#include <QComboBox>
#include <QWidget>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "trace/distribution.h"
#include "ui/panels/signal_chooser.h"
#include "ui/plots/trace_panel.h"

class QComboBox;
class QLabel;
class QTableWidget;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;
class HistogramPlot;
class SampleRange;

/// How often which value came: histograms of up to four signals over the range that the plots show, between the
/// cursors, or since the figures were armed. Every sample counts. It counts a portion a tick, so that the window never
/// waits.
class DistributionView final : public QWidget {
  Q_OBJECT

 public:
  static constexpr std::size_t kMost = SignalChooser::kMost;
  using Source = SignalSource;

  DistributionView(const TimeView* view, const CursorSet* cursors, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the view or be replaced.
  void setRecord(const RunRecord* record, bool recorded = false);
  /// The same signals of another recording beside them, as far as it tells them; see TracePanel.
  void setOverlay(const TracePanel::Overlay& overlay);
  void setSources(std::vector<Source> sources) { signals_->setSources(std::move(sources)); }
  [[nodiscard]] const std::vector<Source>& sources() const { return signals_->sources(); }
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
  /// Variables to be watched besides those that are.
  void variablesWanted();

 private:
  [[nodiscard]] double limit() const;
  /// The series of a source in the other recording; null: it has none.
  [[nodiscard]] const MinMaxSeries* otherSeries(const Source& source) const;
  [[nodiscard]] BinGrid gridFor(Nanoseconds begin, Nanoseconds end) const;
  struct Column {
    QString name;
    QColor color;
    Source source;
    const Distribution* count;
    bool is_estimate;  // from above
  };
  [[nodiscard]] std::vector<Column> columns() const;
  void showFigures();
  [[nodiscard]] QString binText() const;
  void listBin(qint64 bin);

  const TimeView* view_;
  const RunRecord* record_ = nullptr;
  std::array<Distribution, kMost> counts_;
  TracePanel::Overlay overlay_;
  std::vector<Distribution> others_;  // of the overlay, by source; empty: there is none
  BinGrid grid_;
  SignalChooser* signals_;
  SampleRange* range_;
  QComboBox* axis_;
  QLabel* state_;
  HistogramPlot* plot_;
  QTableWidget *figures_, *moments_;
};

}  // namespace syncline::ui
