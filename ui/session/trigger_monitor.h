// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "trace/trigger.h"

namespace syncline::ui {

class WindowMemory;

/// The trigger of the window, and what it found in the run or the recording that is shown. Set it is remembered with
/// the window, armed it is not.
class TriggerMonitor final : public QObject {
  Q_OBJECT

 public:
  explicit TriggerMonitor(WindowMemory& memory, QObject* parent = nullptr);

  /// Null: nothing. It must outlive the monitor or be replaced. An armed trigger looks at all of it, also at what was
  /// before.
  void setRecord(const RunRecord* record, bool recorded);
  [[nodiscard]] const RunRecord* record() const { return record_; }
  [[nodiscard]] bool isRecorded() const { return recorded_; }

  [[nodiscard]] const Trigger& trigger() const { return trigger_; }
  /// What was found with another one is no longer listed; an armed one waits anew. What this one found in the run
  /// before, in whatever mode, is listed again.
  void setTrigger(const Trigger& trigger);
  /// The record has more variables than before.
  void tellVariables() { Q_EMIT recordChanged(); }
  /// Of a run from now on, of a recording from its beginning.
  void arm();
  void disarm();
  /// The recording was set back to an earlier moment, or is shown at one: an armed one looks from its beginning up to
  /// there.
  void setBack();
  [[nodiscard]] bool isArmed() const { return armed_; }
  /// The state in words; empty where nothing is shown.
  [[nodiscard]] QString stateText() const;

  /// The latest, also after it was disarmed, and what was found before it was armed again; of a run or a recording that
  /// is shown anew what was found before.
  [[nodiscard]] const std::vector<TriggerEpisode>& episodes() const;
  [[nodiscard]] std::uint64_t leftOut() const { return watch_ ? watch_->left_out() : 0; }
  [[nodiscard]] QString name(const TriggerEpisode& episode) const;
  void setName(const TriggerEpisode& episode, const QString& name);

  /// What is new, as its tick does; of long recordings a portion.
  void look();

 Q_SIGNALS:
  void triggerChanged();
  /// Another run or recording: other slaves; or other variables are watched.
  void recordChanged();
  /// Episodes, or the state.
  void changed();
  /// Of a run: what was found by now, or named, is to be kept with it.
  void found(const syncline::KeptTrigger& kept);
  /// The newest one is there with the time behind it.
  void completed(const syncline::TriggerEpisode& episode);

 private:
  void begin(Nanoseconds from);
  /// All of it is there at once.
  [[nodiscard]] bool isWhole() const { return recorded_ && !record_->shown_at(); }
  void hearEvents();
  void hearFindings();
  void tellCompleted(bool whole);
  void tellFound();
  /// Shows what the record keeps, found by the trigger that is set or, in a recording, by another one.
  void showKept();
  /// What the trigger that is set has found in the record by now; null: nothing.
  [[nodiscard]] const KeptTrigger* keptOfRecord() const;
  /// Behind those from before the watch.
  void gatherEpisodes();

  WindowMemory& memory_;
  Trigger trigger_;
  const RunRecord* record_ = nullptr;
  bool recorded_ = false, armed_ = false, whole_ = false;
  std::unique_ptr<TriggerWatch> watch_;
  std::vector<TriggerEpisode> earlier_, episodes_;  // from before the watch, and with its own
  std::optional<KeptTrigger> kept_;                 // shown while there is no watch
  std::optional<Trigger> own_;                      // what was set before a recording brought its own
  std::uint64_t heard_ = 0;                         // events
  unsigned looks_ = 0;
  std::uint64_t told_ = 0;  // episodes that were complete
  std::map<Nanoseconds, std::string> names_;
  QTimer tick_;
};

}  // namespace syncline::ui
