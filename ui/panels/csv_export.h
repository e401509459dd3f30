// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <thread>

#include "support/result.h"
#include "ui/plots/series_csv.h"

class QDialog;

namespace syncline::ui {

/// Writes a table of samples, with progress and Cancel: the window's thread takes a portion of the samples after the
/// other, between which everything else has its turn; words are made of them and written in a thread of their own. The
/// file is complete or not there.
class CsvExport final : public QObject {
  Q_OBJECT

 public:
  /// `parent`: the widget that asks.
  explicit CsvExport(QWidget* parent);
  ~CsvExport() override;

  /// No-op while one is written.
  void start(const QString& path, CsvTable table);
  /// What is being written is not wanted, or its samples go away: when this returns there is no file but a whole one.
  void cancel();
  [[nodiscard]] bool isBusy() const { return table_.has_value(); }

 Q_SIGNALS:
  void progress(int permille);
  void finished();
  /// kCancelled is told, too.
  void failed(const syncline::Error& error);

 private:
  void openDialog(const QString& path);
  void write(const std::string& path, const std::string& head);
  /// For the writing thread: the next portion; nothing: no more comes.
  [[nodiscard]] std::optional<CsvRows> take();
  void feed();
  void end(const Status& status);

  std::optional<CsvTable> table_;
  QPointer<QDialog> dialog_;
  std::uint64_t number_ = 0;  // of the export: written while no thread runs
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<CsvRows> portion_;       // under the mutex, as the next two
  bool last_ = false, stopped_ = false;  // no portion comes behind it; what was written is not wanted
  std::thread thread_;                   // last: it uses everything above
};

}  // namespace syncline::ui
