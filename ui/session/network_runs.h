// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "channels/event.h"
#include "ui/session/dcm_log_keeper.h"
#include "ui/session/disk_recording.h"
#include "ui/session/frame_keeper.h"
#include "ui/session/live_session.h"
#include "ui/session/network_run.h"
#include "ui/session/run_findings.h"

namespace syncline::ui {

class ProjectDocument;

/// What one network of the machine runs, is found to mean and keeps on disk, whichever network is in work.
struct NetworkSession final : QObject {
  /// `file_name`: what the files of its black box and its logs begin with.
  NetworkSession(const Environment& environment, const std::function<QString(const NetworkSession&)>& file_name,
                 QObject* parent);

  NetworkRun run;
  RunFindings findings;
  DiskRecording disk;
  FrameKeeper frames;
  DcmLogKeeper dcm_log;
  QString link;    // LINK that going online uses; empty until one was chosen
  int number = 0;  // of its run in the window, which goes on or was the last one; 0: none
  int begun = 0;   // the last one of which there is a sample
};

/// A session for each network of the document. Several run at once; one is shown, that of the network in work. Those of
/// a machine that was replaced end, and what they have for the disk is written.
class NetworkRuns final : public QObject {
  Q_OBJECT

 public:
  NetworkRuns(ProjectDocument& document, const Environment& environment);

  /// Of the network in work; of any network.
  [[nodiscard]] NetworkSession& current() { return *sessions_[shown_at_]; }
  [[nodiscard]] const NetworkSession& current() const { return *sessions_[shown_at_]; }
  [[nodiscard]] const NetworkSession& of(int network) const { return *sessions_[static_cast<std::size_t>(network)]; }
  [[nodiscard]] int count() const { return static_cast<int>(sessions_.size()); }
  /// The run of the network in work.
  [[nodiscard]] LiveSession& shown() { return shown_; }

  /// LINK of the network in work.
  void setLink(const QString& link);
  /// Which variables are watched in all of them, also in those that come.
  Status watch(const std::vector<VariableName>& names);
  /// Another network that runs on this link, which is a network card; -1: none.
  [[nodiscard]] int userOf(const QString& link) const;
  /// Which network the run of this number is of; -1: none any more.
  [[nodiscard]] int networkOf(int run) const;
  /// What is kept of the frames of each network, those that run and all later ones.
  void setBlackBox(const BlackBoxWish& wish);
  [[nodiscard]] const BlackBoxWish& blackBox() const { return black_box_; }
  /// Of each network, see DiskRecording::setMemoryMib().
  void setMemoryMib(int mib);
  [[nodiscard]] int memoryMib() const { return memory_mib_; }
  /// A network's last run left a master behind that did not end.
  [[nodiscard]] bool givenUp() const;
  /// Something runs, or comes or goes.
  [[nodiscard]] bool any() const;
  /// Begins to take all of them offline; with shutDown() all are when it returns.
  void goOffline();
  void shutDown();
  /// Waits for the disk: for closing the window.
  void finish();

 Q_SIGNALS:
  /// Of any network.
  void phaseChanged(int network);
  void snapshotChanged(int network);
  void eventArrived(int network, const syncline::Event& event);
  void signSeen(int network, syncline::RunSession::Sign sign);
  void noteAdded(int network, const syncline::RunNote& note);
  /// The first cycle of a run has come, at this moment of its clock.
  void begun(int run, qint64 moment);
  void recordingEnded(const QString& path, const QString& why, const std::optional<syncline::Error>& error);
  /// Of any network: where its last frames lie, or why they do not.
  void framesKept(const syncline::BlackBox::Report& report);
  /// Of any network: the log of its master synchronisation.
  void dcmLogBegan(const QString& path);
  void dcmLogEnded(const QString& path, const std::optional<syncline::Error>& error);
  void stretchSaved(const QString& path, const std::optional<syncline::Error>& error);
  /// Of the network in work, or because another one is.
  void linkChanged();
  void findingsChanged();
  void diskChanged();

 private:
  NetworkSession* make();
  void listen(NetworkSession& session);
  [[nodiscard]] int indexOf(const NetworkSession& session) const;
  [[nodiscard]] QString fileName(const NetworkSession& session) const;
  void retire(NetworkSession& session);
  void replaceAll();
  void follow();
  void tell();

  ProjectDocument& document_;
  const Environment& environment_;
  BlackBoxWish black_box_;
  int memory_mib_ = DiskRecording::kUsualMemoryMib;
  std::vector<VariableName> watched_;      // before the sessions, which are told
  std::vector<NetworkSession*> of_run_;    // of each run there was in the window, by its number - 1; null: gone
  std::vector<NetworkSession*> sessions_;  // of each network; children of this
  std::size_t shown_at_ = 0;
  LiveSession shown_;
  bool other_ = false;  // another one is shown, and nobody was told yet
};

}  // namespace syncline::ui
