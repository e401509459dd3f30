// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "record/black_box.h"

namespace syncline::ui {

struct Environment;

class NetworkRun;

/// What the user wants kept of the frames of every run.
struct BlackBoxWish {
  static constexpr int kUsualMib = 64;
  static constexpr int kMostMib = 1 << 20;

  bool on = false;
  QString folder;
  int mib = kUsualMib;  // of each network
  bool operator==(const BlackBoxWish&) const = default;
};

/// The black box of one network: as long as it is wished for, the last frames of each of its runs lie on disk. A thread
/// of its own writes.
class FrameKeeper final : public QObject {
  Q_OBJECT

 public:
  /// `name`: what the files' names begin with, asked when a run begins.
  FrameKeeper(NetworkRun& run, std::function<QString()> name, const Environment& environment,
              QObject* parent = nullptr);
  ~FrameKeeper() override;

  /// From now on, for the run that goes on, too; another folder or size begins another box.
  void setWish(const BlackBoxWish& wish);
  [[nodiscard]] bool isKeeping() const { return box_ != nullptr; }
  /// Of the run that goes on; without one of the last one.
  [[nodiscard]] BlackBox::Report report() const { return box_ ? box_->report() : last_; }
  /// Something is on its way to the disk.
  [[nodiscard]] bool isWriting() const { return isKeeping() || ending_; }
  /// Ends and waits for the disk: for closing the window.
  void finish();

 Q_SIGNALS:
  void changed();
  /// A run is over, or the wish: where its last frames lie; `error`: what ended it before. Also where it could not
  /// begin.
  void ended(const syncline::BlackBox::Report& report);

 private:
  void start();
  void stop();
  void waitForDisk();
  void onFinished(int number);

  NetworkRun& run_;
  std::function<QString()> name_;
  const Environment& environment_;
  BlackBoxWish wish_;
  BlackBox::Report last_;
  std::unique_ptr<BlackBox> box_;
  std::shared_ptr<BlackBox> finishing_;  // by the thread
  std::thread ender_;
  int number_ = 0;  // of the box that goes on, or was the last one
  bool ending_ = false;
};

}  // namespace syncline::ui
