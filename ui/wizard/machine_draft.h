// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>

#include "ui/session/workspace.h"

namespace syncline::ui {

/// The machine that a wizard makes: a project in a workspace of its own, so that nothing of the window's project, its
/// undo steps or its running machine is touched before somebody takes it. Where its slaves come from is asked anew as
/// often as the user likes; what was set for the master stays, unless a file says it otherwise.
class MachineDraft final : public QObject {
  Q_OBJECT

 public:
  explicit MachineDraft(Workspace& window, QObject* parent = nullptr);

  [[nodiscard]] Workspace& workspace() { return draft_; }
  [[nodiscard]] TemplateStore& templates() { return window_.templates(); }
  [[nodiscard]] DeviceCatalogue& catalogue() { return window_.catalogue(); }
  [[nodiscard]] const Project& project() { return draft_.document().project(); }
  /// The master is as a file has it: nothing is to be proposed for it.
  [[nodiscard]] bool masterIsGiven() const { return master_is_given_; }
  [[nodiscard]] Machine machine() { return draft_.document().machine(); }
  /// LINK of the bus that was scanned; "" = none was.
  [[nodiscard]] const QString& link() const { return draft_.link(); }
  [[nodiscard]] QString usualLink() const { return window_.usualLink(); }

  /// Looks first: a bus whose slaves run is not written to.
  void scan(const QString& link);
  /// The same bus with all that a scan asks of it.
  void scanFully();
  void cancelScan();
  [[nodiscard]] bool isScanning() const { return scanning_; }
  /// Slaves that were beyond INIT, so that they were only looked at; 0: there were none.
  [[nodiscard]] int lookedAt() const { return looked_at_; }
  void readEni(const QString& path);
  /// A project file as a pattern: what it holds, without its name.
  void readProject(const QString& path);
  /// Behind the last slave.
  void add(const eni::CatalogueEntry& device);
  void remove(int slave);

 Q_SIGNALS:
  /// What there is to say of the last source, a sentence; `bad`: it gave nothing.
  void told(const QString& text, bool bad);
  void scanChanged();

 private:
  void take(Project project);
  void tellError(const Error& error);

  Workspace& window_;
  Workspace draft_;
  bool scanning_ = false;
  bool master_is_given_ = false;
  int looked_at_ = 0;
};

}  // namespace syncline::ui
