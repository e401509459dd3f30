// SPDX-License-Identifier: Apache-2.0
// What is found wrong with a setting stands below its field, whatever kind of field that is.
#include <gtest/gtest.h>

#include <QLabel>
#include <QUndoStack>

#include "settings/settings_table.h"
#include "support/editable_project.h"
#include "support/project_window.h"
#include "ui/editors/field_binder.h"
#include "ui/editors/page.h"

namespace syncline::ui {
namespace {

class NotesOfFields : public test::ProjectWindow {
 protected:
  NotesOfFields() : ProjectWindow(test::editableProject()) {}

  /// The notes that are seen on the page that is in front, with these words.
  QList<QLabel*> seen(const QString& words) {
    QApplication::processEvents();
    QList<QLabel*> found;
    for (auto* label : window_.editor().tabs()->currentWidget()->findChildren<QLabel*>()) {
      const bool is_note = label->objectName().endsWith(QStringLiteral("Note"));
      if (is_note && label->isVisible() && label->text().contains(words)) found.append(label);
    }
    return found;
  }
};

TEST_F(NotesOfFields, StandBesideEveryOne) {
  workspace_.setExpert(true);
  const auto& machine = project();
  // What is found by itself does not come in between.
  static_cast<void>(workspace_.configuration().current());
  workspace_.disconnect(SIGNAL(projectFindingsChanged()));
  int keys = 0;
  for (const auto& setting : settings::table()) {
    const std::size_t slave = setting.of_slave() ? 1 : 0;
    if (setting.applies && !setting.applies(machine.slaves[slave])) continue;
    const auto places = setting.items ? setting.items(machine, slave) : std::vector<settings::Place>{{.slave = slave}};
    if (places.empty()) continue;
    const auto key = settings::key_of(setting, places.back());
    ASSERT_TRUE(window_.editor().showKey(QString::fromStdString(key))) << key;
    for (auto* page : window_.editor().pages())
      page->fields().showNotes({{key, QStringLiteral("may be wrong"), false}, {key, QStringLiteral("is wrong"), true}});
    const auto notes = seen(QStringLiteral("is wrong"));
    ASSERT_EQ(notes.size(), 1) << key;
    const auto* page = static_cast<Page*>(window_.editor().tabs()->currentWidget());
    const auto* field = page->fields().fieldOf(setting, places.back());
    ASSERT_NE(field, nullptr) << key;
    const auto below = field->mapTo(page->widget(), QPoint(0, field->height())).y();
    EXPECT_GE(notes.front()->mapTo(page->widget(), QPoint()).y(), below - 2) << key << ": below its field";
    for (auto* any : window_.editor().pages()) any->fields().showNotes({});
    EXPECT_TRUE(seen(QStringLiteral("is wrong")).isEmpty()) << key;
    ++keys;
  }
  EXPECT_GT(keys, 95);
}

/// Of the checker of the ENI as of the compiler, and without anybody who asks for it.
TEST_F(NotesOfFields, ComeWithTheEdit) {
  show(-1, "masterGeneralPage");
  auto& document = workspace_.document();
  ASSERT_TRUE(document.edit(QStringLiteral("cycle"), [](Project& target) -> Status {
    for (auto& slave : target.slaves) slave.station_address = 1002;
    return {};
  }));
  static_cast<void>(workspace_.configuration().current());
  show(2, "slaveGeneralPage");
  EXPECT_FALSE(seen(QStringLiteral("1002")).isEmpty());
  document.undoStack().undo();
  static_cast<void>(workspace_.configuration().current());
  EXPECT_TRUE(seen({}).isEmpty());
}

}  // namespace
}  // namespace syncline::ui
