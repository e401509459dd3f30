// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

#include "support/result.h"

namespace syncline::ui {

/// A write of an EEPROM that a killed program has left half done.
struct CutShortWrite {
  QString link;      // LINK, as that program was given it
  int position = 0;  // of the slave, 0 is the first
  QString begun;     // UTC, "2026-03-01 12:00:00"
};

/// How the program that hosts the window finds and ends such writes.
struct EepromRepairs {
  std::function<std::vector<CutShortWrite>()> pending;
  /// Finishes it, or with `undo` puts back what was there; called from another thread, seconds long. `cancel` ends it
  /// with kCancelled.
  std::function<Status(const CutShortWrite&, bool undo, const std::atomic<bool>& cancel)> end;
  /// Before the first word is written: what the EEPROM holds from word 0 on and shall hold, alike in length. None:
  /// nothing is kept of it.
  std::function<Status(const QString& link, int position, const std::vector<std::uint8_t>& before,
                       const std::vector<std::uint8_t>& after)>
      keep{};
  /// The write has ended, or all is put back.
  std::function<void(const QString& link, int position)> drop{};
};

/// Ends cut-short writes in the background, one at a time.
class EepromRepair final : public QObject {
  Q_OBJECT

 public:
  explicit EepromRepair(EepromRepairs repairs, QObject* parent = nullptr);
  /// Waits for the one that runs: half a word helps nobody.
  ~EepromRepair() override;

  [[nodiscard]] std::vector<CutShortWrite> pending() const;
  /// No-op while one runs; finished() or failed() follows.
  void start(const CutShortWrite& write, bool undo);
  void cancel() { cancelled_ = true; }
  /// Around a write through the running bus, see EepromRepairs.
  [[nodiscard]] Status keep(const QString& link, int position, const std::vector<std::uint8_t>& before,
                            const std::vector<std::uint8_t>& after) const;
  void drop(const QString& link, int position) const;
  [[nodiscard]] bool isRunning() const { return running_; }

 Q_SIGNALS:
  void finished();
  void failed(const syncline::Error& error);

 private:
  void deliver(const Status& status);

  EepromRepairs repairs_;
  std::thread worker_;
  std::atomic<bool> cancelled_{false};
  bool running_ = false;
};

}  // namespace syncline::ui
