// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include "ui/models/dictionary.h"
#include "ui/pages/online_page.h"

class QCheckBox;
class QComboBox;
class QLineEdit;
class QMenu;
class QPushButton;
class QToolButton;
class QTreeView;

namespace syncline::ui {

class DictionaryReader;
class ObjectFilter;
class ObjectModel;
class ObjectWriteBar;
class PollChoice;

/// The object dictionary of a slave: offline as its ESI describes it, online as it tells itself, with values that are
/// read, watched and written while the machine runs.
class SlaveObjectsPage final : public OnlinePage {
  Q_OBJECT

 public:
  explicit SlaveObjectsPage(Workspace& workspace);

  /// Slaves with CoE.
  [[nodiscard]] bool appliesTo(int slave) const override { return speaksCoe(slave); }
  [[nodiscard]] ObjectModel& model() { return *model_; }
  /// Selects it, as the ESI describes it where what is shown has it not; whatever hides it is taken away.
  void showObject(coe::ObjectAddress object);

 protected:
  void slaveChanged() override;
  void machineChanged() override { online_.clear(); }
  void ended() override;
  void projectChanged() override;
  void tick(std::optional<Nanoseconds> now) override;
  [[nodiscard]] QString ownObstacle(const RunningSlave& slave) const override;

 private:
  QWidget* buildChoice();
  QWidget* buildButtons();
  QToolButton* buildFavourites();
  void fillFavourites();
  QTreeView* buildTree();
  void connectReader();

  void showDictionary();
  void readDictionary();
  void showSelected();
  void readSelected();
  void readShown();
  void readWatched();
  void read(const std::vector<coe::ObjectAddress>& objects);
  void takeOfBatch(const RequestOutcome& outcome);
  void readOne(coe::ObjectAddress object, SlaveRequests::Done then = {});
  void write(coe::ObjectAddress object, const std::vector<std::uint8_t>& bytes);
  void readBack(coe::ObjectAddress object, const std::vector<std::uint8_t>& written);
  void stop();
  void keepWatched();
  void exportCsv();
  void copy();
  void showWork();
  [[nodiscard]] std::vector<coe::ObjectAddress> readable(const QModelIndex& parent) const;
  [[nodiscard]] const DictionaryEntry* entryOf(coe::ObjectAddress object) const;
  [[nodiscard]] bool mappedOutput(coe::ObjectAddress object) const;

  DictionaryReader* reader_;
  ObjectModel* model_;
  ObjectFilter* filter_;
  QComboBox* source_;
  PollChoice* poll_;
  QLineEdit* words_;
  QCheckBox* watched_only_;
  QMenu* favourites_;
  QPushButton *read_, *read_shown_, *stop_, *export_;
  QTreeView* tree_;
  ObjectWriteBar* write_;
  Dictionary esi_;
  using Told = std::pair<int, int>;    // position in the run, kind of list
  std::map<Told, Dictionary> online_;  // what slaves have told of themselves in this run
  Told reading_{};
  int batch_ = 0, batch_done_ = 0, batch_failed_ = 0;
  std::size_t polling_ = 0;
};

}  // namespace syncline::ui
