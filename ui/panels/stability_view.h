// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "findings/finding.h"
#include "trace/signal_study.h"
#include "trace/stability_mask.h"
#include "ui/panels/sample_range.h"
#include "ui/panels/signal_chooser.h"
#include "ui/plots/log_log_plot.h"
#include "ui/plots/signal_source.h"
#include "ui/session/study_worker.h"

class QComboBox;
class QTextBrowser;

namespace syncline {
class RunRecord;
}  // namespace syncline

namespace syncline::ui {

class CursorSet;
class TimeView;

class MaskChooser;
class ValueLabel;

/// How signals behave over observation times: Allan deviation, time deviation, MTIE, or the spectrum, of up to four
/// times or up to four variables, with what that means in words. Samples are copied a portion a tick, figures are made
/// in a thread of their own: the window never waits.
class StabilityView final : public QWidget {
  Q_OBJECT

 public:
  enum class Figure { kAdev, kTdev, kMtie, kSpectrum };

  StabilityView(const TimeView* view, const CursorSet* cursors, QWidget* parent = nullptr);
  /// Null: nothing. It must outlive the view or be replaced.
  void setRecord(const RunRecord* record, bool recorded = false);
  void setSources(std::vector<SignalSource> sources);
  [[nodiscard]] const std::vector<SignalSource>& sources() const { return signals_->sources(); }
  void setFigure(Figure figure);
  [[nodiscard]] MaskChooser* mask() const { return mask_; }
  /// Goes on with what is wanted and draws what there is; once a tick while it is seen.
  void refresh();
  /// The figures are of all that is wanted.
  [[nodiscard]] bool complete() const;
  [[nodiscard]] LogLogPlot* plot() const { return plot_; }
  /// What the chosen curve says, in plain words.
  [[nodiscard]] QString words() const;
  /// What is drawn, as a table; C locale.
  [[nodiscard]] std::string csv() const;

 Q_SIGNALS:
  /// Variables to be watched besides those that are.
  void variablesWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  using Stretch = SampleRange::Stretch;
  /// A signal with its figures and what they are of.
  struct Studied {
    SignalSource source;
    Stretch stretch;
    std::shared_ptr<const SignalStudy> study;  // null: none yet
  };
  void chooseFirst();
  void forget();
  void follow(const Stretch& wanted);
  void startNext(const Stretch& wanted);
  void take(std::shared_ptr<const SignalStudy> study);
  [[nodiscard]] bool suits(const Stretch& done, const Stretch& wanted, Nanoseconds slack) const;
  [[nodiscard]] Figure figure() const;
  [[nodiscard]] LogLogPlot::Curve curveOf(const Studied& studied, int number) const;
  [[nodiscard]] LogLogPlot::Curve spectrumOf(const Studied& studied, int number) const;
  [[nodiscard]] bool ofVariables() const;
  [[nodiscard]] Quantity quantity() const;
  [[nodiscard]] LogLogPlot::Axes axes() const;
  [[nodiscard]] LogLogPlot::Limit limit() const;
  static constexpr double kNanosecond = 1e-9;  // of the signals that are times, in s
  [[nodiscard]] static QString paragraphText(const QString& html);
  [[nodiscard]] static bool isVariable(const SignalSource& source);
  /// Of the spectrum it is MTIE, which nobody asks for then.
  [[nodiscard]] StabilityFigure maskedFigure() const;
  [[nodiscard]] StabilityMask maskOf(const SignalSource& source) const;
  [[nodiscard]] QString maskText(const Studied& studied) const;
  [[nodiscard]] double bound(const SignalSource& source) const;
  [[nodiscard]] QString limitName(const SignalSource& source) const;
  [[nodiscard]] std::vector<KnownFrequency> knownFrequencies(const Studied& studied) const;
  [[nodiscard]] QStringList sentences(const Studied& studied) const;
  [[nodiscard]] QString linesTable(const Studied& studied) const;
  [[nodiscard]] QString wordsOf(const Studied& studied) const;
  void draw();
  void showState();

  const RunRecord* record_ = nullptr;
  std::vector<Studied> studied_;  // as the sources
  std::optional<Studied> job_;    // what is gathered or made
  Stretch wanted_;
  SampleGathering gathering_;
  bool signals_chosen_ = false, dirty_ = true;
  int chosen_ = 0;
  QString html_;
  SignalChooser* signals_;
  QComboBox* figure_;
  MaskChooser* mask_;
  SampleRange* range_;
  ValueLabel* state_;
  LogLogPlot* plot_;
  QTextBrowser* words_;
  StudyWorker worker_;  // last: its thread ends first
};

}  // namespace syncline::ui
