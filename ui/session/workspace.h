// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>

#include "ui/models/cable_counters.h"
#include "ui/models/finding_model.h"
#include "ui/models/message_model.h"
#include "ui/models/network_model.h"
#include "ui/session/autosave.h"
#include "ui/session/bus_connection.h"
#include "ui/session/configuration_monitor.h"
#include "ui/session/device_catalogue.h"
#include "ui/session/eeprom_repair.h"
#include "ui/session/eni_preview.h"
#include "ui/session/network_runs.h"
#include "ui/session/opened_recording.h"
#include "ui/session/project_document.h"
#include "ui/session/recording_overlay.h"
#include "ui/session/recording_replay.h"
#include "ui/session/run_difference.h"
#include "ui/session/running_slaves.h"
#include "ui/session/scan_controller.h"
#include "ui/session/slave_requests.h"
#include "ui/session/start_refusal.h"
#include "ui/session/template_store.h"
#include "ui/session/trigger_monitor.h"
#include "ui/session/variable_watch.h"
#include "ui/session/watch_list.h"
#include "ui/session/window_memory.h"

namespace syncline::ui {

/// What one window works on: the document, what is compiled from it, the scan, the running master and
/// the models that show them. It wires them to each other and does nothing itself.
class Workspace final : public QObject {
  Q_OBJECT

 public:
  explicit Workspace(Environment environment, QObject* parent = nullptr);

  [[nodiscard]] const Environment& environment() const { return environment_; }
  [[nodiscard]] ProjectDocument& document() { return document_; }
  [[nodiscard]] Autosave& autosave() { return autosave_; }
  [[nodiscard]] ConfigurationMonitor& configuration() { return configuration_; }
  /// The ENI that the project would export.
  [[nodiscard]] EniPreview& eni() { return eni_; }
  [[nodiscard]] ScanController& scan() { return scan_; }
  [[nodiscard]] DeviceCatalogue& catalogue() { return catalogue_; }
  [[nodiscard]] EepromRepair& eepromRepair() { return eeprom_repair_; }
  /// What runs, network by network.
  [[nodiscard]] NetworkRuns& runs() { return runs_; }
  /// The run of the network in work.
  [[nodiscard]] LiveSession& live() { return runs_.shown(); }
  [[nodiscard]] SlaveRequests& requests() { return requests_; }
  /// Which slave of the project is which of the run.
  [[nodiscard]] const RunningSlaves& runningSlaves() const { return running_slaves_; }
  [[nodiscard]] WatchList& watched() { return watched_; }
  /// Which variables of the process image the monitor watches.
  [[nodiscard]] VariableWatch& variables() { return variables_; }
  /// What the project would do otherwise than what runs.
  [[nodiscard]] RunDifference& runDifference() { return run_difference_; }
  /// Whether the last start of the network in work failed.
  [[nodiscard]] StartRefusal& startRefusal() { return start_refusal_; }
  [[nodiscard]] TriggerMonitor& trigger() { return trigger_; }
  /// What the user begins projects with.
  [[nodiscard]] TemplateStore& templates() { return templates_; }
  [[nodiscard]] WindowMemory& memory() { return memory_; }
  /// What is kept on disk of the run of the network in work.
  [[nodiscard]] DiskRecording& disk() { return runs_.current().disk; }
  /// A recording that is shown in place of the live run, while nothing runs.
  [[nodiscard]] OpenedRecording& recording() { return recording_; }
  /// Plays it.
  [[nodiscard]] RecordingReplay& replay() { return replay_; }
  /// Another one, laid over it.
  [[nodiscard]] RecordingOverlay& overlay() { return overlay_; }
  /// What plots and figures show: the recording that is open, else the run; null before the first.
  [[nodiscard]] const RunRecord* shownRecord() const;
  /// What is wrong with the project, and what was found about what is shown.
  [[nodiscard]] FindingModel& findings() { return findings_; }
  /// What the compiler and the checker of the ENI find wrong with the project, each at its slave.
  [[nodiscard]] std::vector<Finding> settingFindings() const;
  /// What was found about the run that goes on or was last of the network in work, or of the recording in its place.
  [[nodiscard]] std::vector<Finding> shownFindings() const;
  [[nodiscard]] MessageModel& messages() { return messages_; }
  [[nodiscard]] NetworkModel& network() { return network_; }
  /// What the running machine counted at its cables.
  [[nodiscard]] CableCounters& cables() { return cables_; }

  /// LINK that scan and online use for the network in work; empty until one was chosen.
  [[nodiscard]] const QString& link() const { return runs_.current().link; }
  void setLink(const QString& link);
  /// What to propose: the link, or that of the last time.
  [[nodiscard]] QString usualLink() const;

  /// From now on, for every network; the window remembers it.
  void setBlackBox(const BlackBoxWish& wish);

  /// How much of the latest cycles each network keeps in memory, 1 to DiskRecording::kMostMemoryMib; remembered, too.
  void setMemoryMib(int mib);

  /// Whether settings that few machines need are shown.
  [[nodiscard]] bool expert() const { return expert_; }
  void setExpert(bool expert);

  /// kConfiguration where another network runs on this link.
  [[nodiscard]] Status mayUse(const QString& link) const;

  /// Slaves come and go neither while a machine runs nor while a recording is shown. Empty: they may; else why not, a
  /// sentence.
  [[nodiscard]] QString whySlavesStay() const;
  [[nodiscard]] bool mayEditSlaves() const { return whySlavesStay().isEmpty(); }

  /// Compiles and starts; a configuration with errors is refused (the messages name them), and while a recording is
  /// shown, too, or where another network runs on the link.
  Status goOnline();
  /// What the user writes at a moment of what is shown: of the run, or of the recording, into whose file it goes. At
  /// the time of a note of the recording it is put in its place; "" there takes it away. kFileNotWritable.
  Status putNote(const RunNote& note);
  /// A line in the message window.
  void report(const Error& error, Severity severity, const QString& source);
  void inform(const QString& source, const QString& text);
  /// What the checker finds wrong in an ENI that was exported, a line each.
  void tellOfExport(const std::vector<Finding>& wrong);

 Q_SIGNALS:
  void expertChanged();
  void projectFindingsChanged();
  void mayEditSlavesChanged();

 private:
  void appendEvent(int network, const Event& event);
  void appendSign(int network, NetworkRun::Sign sign);
  void appendNote(int network, const RunNote& note);
  void appendOfRun(int network, Message message);
  void showFindings();
  void showEniFindings();
  [[nodiscard]] std::vector<Finding> findingsOfEni() const;
  [[nodiscard]] std::vector<Message> projectLines() const;
  void tellOfScan(const QString& link, const ScanOutcome& outcome);
  void showRunFindings();
  void showRecording();
  void showMoment();
  void showNetworks();
  void showOther(int network);

  Environment environment_;
  WindowMemory memory_;
  TemplateStore templates_;
  bool expert_ = false;
  ProjectDocument document_;
  NetworkRuns runs_;  // hears of another network before all others
  Autosave autosave_;
  ConfigurationMonitor configuration_;
  EniPreview eni_;
  ScanController scan_;
  DeviceCatalogue catalogue_;
  EepromRepair eeprom_repair_;
  SlaveRequests requests_;
  RunningSlaves running_slaves_;
  WatchList watched_;
  VariableWatch variables_;
  RunDifference run_difference_;
  StartRefusal start_refusal_;
  OpenedRecording recording_;
  RecordingReplay replay_{recording_};
  RecordingOverlay overlay_{recording_};
  TriggerMonitor trigger_{memory_};
  std::vector<Finding> project_findings_;  // what slaves have alike once
  FindingModel findings_;
  bool found_shown_ = true;  // of a moment of a recording nothing is found, see RunRecord::findings()
  std::shared_ptr<const eni::EniCheck> shown_check_;  // of the ENI, in the messages
  MessageModel messages_;
  NetworkModel network_;
  CableCounters cables_;
};

}  // namespace syncline::ui
