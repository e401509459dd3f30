// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QWidget;

namespace syncline {
struct Machine;
}  // namespace syncline

namespace syncline::ui {

class ImportCommands;
class Workspace;
struct LostWork;

/// New, open, save and export with their dialogs.
class FileCommands final : public QObject {
  Q_OBJECT

 public:
  FileCommands(Workspace& workspace, QWidget& window);

  void create();
  /// A machine that was made here, in place of the present one: unsaved, without a name and without undo steps. Asks as
  /// opening does; false: project and machine are as they were.
  bool takeNew(Machine machine);
  void open();
  /// Opens without asking for a name; errors are shown. Reads first; then asks about unsaved changes, a running machine
  /// and another window that has the file. False: project and machine are as they were.
  bool openFile(const QString& path);
  /// Opens any file that means something here: a project, an ENI (as a project of it), an ESI file (its folder goes
  /// into the catalogue), a recording (shown), a capture or a scenario (scanned as a bus). Says why not where it does
  /// not.
  void openAny(const QString& path);
  /// The same for a file that was dropped: a machine can be compared with the open project instead.
  void openDropped(const QString& path);
  /// Offers the unsaved work of windows that were killed; `then` follows when there is none or the user wants none of
  /// it. `asked`: the file with which the program was started; it is offered behind what was recovered.
  void offerRecovery(const std::function<void()>& then, const QString& asked = {});
  /// Where a dialog that opens files begins; "" where nothing was opened yet.
  [[nodiscard]] QString usualFolder() const;
  bool save();
  bool saveAs();
  void exportEni();
  bool exportTo(const QString& path);
  /// Asks about unsaved changes; false = stay.
  bool mayDiscard();

  /// Name of a file that is made of the network in work, beside the project's; with the network's name where there are
  /// several.
  [[nodiscard]] QString proposedExport(const QString& suffix) const;

 Q_SIGNALS:
  /// The file is to be compared with the project.
  void comparisonWanted(const QString& path);
  /// The file is a bus: scan it.
  void linkWanted(const QString& link);
  void recordingWanted(const QString& path);

 private:
  [[nodiscard]] QString proposedName(const QString& suffix) const;
  bool saveTo(const QString& path);
  bool mayOpenBeside(const QString& path);
  void recover(const LostWork& work);
  void offerAsked(const QString& asked);

  Workspace& workspace_;
  QWidget& window_;
  ImportCommands* imports_;
};

}  // namespace syncline::ui
