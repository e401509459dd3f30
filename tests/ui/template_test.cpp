// SPDX-License-Identifier: Apache-2.0
// The user's own templates: kept, replaced and removed after a question, and begun with.
#include <gtest/gtest.h>

#include <QDir>
#include <QInputDialog>
#include <QListWidget>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QUndoStack>

#include "eni/project/project_file.h"
#include "support/ui_test_support.h"
#include "tests/support/sample_devices.h"
#include "ui/dialogs/template_commands.h"
#include "ui/main_window.h"
#include "ui/session/workspace.h"
#include "ui/wizard/machine_draft.h"
#include "ui/wizard/new_machine_wizard.h"

namespace syncline::ui {
namespace {

/// Answers the next question of this name; what it asked.
class TemplateAnswer {
 public:
  TemplateAnswer(const char* question, bool on) : name_(question), on_(on) {
    QObject::connect(&timer_, &QTimer::timeout, [this] { answer(); });
    timer_.start(5);
  }
  [[nodiscard]] bool wasAsked() const { return asked_; }

 private:
  void answer() {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr || box->objectName() != QLatin1String(name_)) return;
    asked_ = true;
    timer_.stop();
    if (on_) return box->findChild<QPushButton*>(QStringLiteral("questionGo"))->click();
    box->button(QMessageBox::Cancel)->click();
  }
  const char* name_;
  bool on_, asked_ = false;
  QTimer timer_;
};

class Templates : public ::testing::Test {
 protected:
  Templates() : workspace_(environment()), window_(workspace_) {
    workspace_.document().replace(QStringLiteral("load"), sample::small_machine());
    workspace_.document().undoStack().setClean();
    window_.show();
    window_.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window_));
  }
  ~Templates() override { workspace_.document().undoStack().setClean(); }

  Environment environment() {
    auto environment = test::virtualEnvironment();
    environment.templates_folder = folder_.filePath(QStringLiteral("data/templates"));
    return environment;
  }
  TemplateStore& store() { return workspace_.templates(); }
  QStringList names() {
    QStringList all;
    for (const auto& entry : store().entries()) all.append(entry.name);
    return all;
  }
  template <class Widget>
  Widget* part(const char* name) {
    return window_.findChild<Widget*>(QLatin1String(name));
  }
  void settle() {
    QApplication::processEvents();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  QTemporaryDir folder_;
  Workspace workspace_;
  MainWindow window_;
};

TEST_F(Templates, TheProjectIsKeptAndBegunWith) {
  auto* action = part<QAction>("actionSaveTemplate");
  ASSERT_TRUE(action->isEnabled());
  EXPECT_TRUE(names().isEmpty());
  action->trigger();
  auto* dialog = part<QInputDialog>("templateName");
  ASSERT_NE(dialog, nullptr);
  dialog->setTextValue(QStringLiteral("  Press & Co: 4/2 \u538b  "));
  dialog->accept();
  settle();
  EXPECT_EQ(names(), QStringList{QStringLiteral("Press & Co: 4/2 \u538b")})
      << "as it was typed, whatever the file is called";
  const auto kept = workspace_.document().project();
  EXPECT_TRUE(workspace_.document().path().isEmpty()) << "keeping a template is no saving";
  workspace_.document().reset();
  settle();
  EXPECT_FALSE(action->isEnabled()) << "nothing to keep";
  auto* begin = part<QToolButton>("templateBegin0");
  ASSERT_NE(begin, nullptr);
  ASSERT_TRUE(begin->isVisible());
  begin->click();
  EXPECT_EQ(workspace_.document().project(), kept);
  EXPECT_TRUE(workspace_.document().path().isEmpty()) << "a new project, not the template's file";
  EXPECT_TRUE(workspace_.document().isModified());
  EXPECT_EQ(workspace_.document().undoStack().count(), 0);
}

TEST_F(Templates, ANameThatIsTakenIsAsked) {
  ASSERT_TRUE(window_.templates().saveAs(QStringLiteral("Press")));
  const auto first = workspace_.document().project();
  ASSERT_TRUE(workspace_.document().edit(QStringLiteral("name"), [](Project& project) -> Status {
    project.master.name = "Other";
    return {};
  }));
  const auto held = [this] { return eni::load_machine(store().entries().front().path.toStdString()).value(); };
  {
    const TemplateAnswer no("templateQuestion", false);
    EXPECT_FALSE(window_.templates().saveAs(QStringLiteral("Press")));
    EXPECT_TRUE(no.wasAsked());
  }
  EXPECT_EQ(held().networks.front().master.name, first.master.name) << "as it was";
  {
    const TemplateAnswer yes("templateQuestion", true);
    EXPECT_TRUE(window_.templates().saveAs(QStringLiteral("Press")));
    EXPECT_TRUE(yes.wasAsked());
  }
  EXPECT_EQ(held().networks.front().master.name, "Other");
  EXPECT_EQ(names().size(), 1);
  EXPECT_FALSE(window_.templates().saveAs(QStringLiteral("   "))) << "no name";
}

TEST_F(Templates, OneIsRemovedAfterAQuestion) {
  for (const char* name : {"b", "a", "..", "C"}) ASSERT_TRUE(window_.templates().saveAs(QString::fromLatin1(name)));
  EXPECT_EQ(names().size(), 4);
  workspace_.document().reset();
  settle();
  const auto first = names().front();
  const auto press = [this] {
    auto* remove = part<QToolButton>("templateRemove0");
    ASSERT_NE(remove, nullptr);
    remove->click();
    settle();
  };
  {
    const TemplateAnswer no("templateRemoveQuestion", false);
    press();
  }
  EXPECT_EQ(names().size(), 4);
  {
    const TemplateAnswer yes("templateRemoveQuestion", true);
    press();
  }
  EXPECT_EQ(names().size(), 3);
  EXPECT_FALSE(names().contains(first));
  EXPECT_EQ(QDir(folder_.path()).entryList(QDir::Files).size(), 0) << "no name leads out of the folder";
}

TEST_F(Templates, ABadFileSaysSoAndTheListStays) {
  ASSERT_TRUE(window_.templates().saveAs(QStringLiteral("good")));
  const auto good = store().entries().front();
  QFile bad(QFileInfo(good.path).dir().filePath(QStringLiteral("bad.syncline")));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("<Project");
  bad.close();
  workspace_.document().reset();
  Q_EMIT store().changed();
  settle();
  ASSERT_EQ(names(), (QStringList{QStringLiteral("bad"), QStringLiteral("good")}));
  part<QToolButton>("templateBegin0")->click();
  auto* error = part<QMessageBox>("errorDialog");
  ASSERT_NE(error, nullptr);
  EXPECT_TRUE(error->text().contains(QStringLiteral("bad")));
  EXPECT_TRUE(error->informativeText().contains(QStringLiteral("bad.syncline")));
  error->accept();
  EXPECT_TRUE(workspace_.document().project().slaves.empty()) << "as it was";
  settle();
  part<QToolButton>("templateBegin1")->click();
  EXPECT_EQ(workspace_.document().project().slaves.size(), 4U);
}

TEST_F(Templates, TheWizardOffersThem) {
  ASSERT_TRUE(window_.templates().saveAs(QStringLiteral("Press")));
  part<QAction>("actionNewMachine")->trigger();
  const QPointer wizard = window_.findChild<NewMachineWizard*>();
  ASSERT_NE(wizard, nullptr);
  test::find<QRadioButton>(*wizard, "wizardFromProject")->setChecked(true);
  auto* list = test::find<QListWidget>(*wizard, "wizardTemplates");
  auto* use = test::find<QPushButton>(*wizard, "wizardUseTemplate");
  ASSERT_EQ(list->count(), 1);
  EXPECT_FALSE(use->isEnabled()) << "none is chosen";
  list->setCurrentRow(0);
  use->click();
  EXPECT_EQ(wizard->draft().project().slaves.size(), 4U);
  {
    const TemplateAnswer yes("templateRemoveQuestion", true);
    test::find<QPushButton>(*wizard, "wizardRemoveTemplate")->click();
    EXPECT_TRUE(yes.wasAsked());
  }
  EXPECT_EQ(list->count(), 0);
  EXPECT_EQ(wizard->draft().project().slaves.size(), 4U) << "what was begun stays";
  const TemplateAnswer yes("wizardQuestion", true);
  wizard->reject();
}

TEST_F(Templates, WhatCannotBeWrittenIsTold) {
  QFile in_the_way(folder_.filePath(QStringLiteral("data")));
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  EXPECT_FALSE(window_.templates().saveAs(QStringLiteral("Press")));
  auto* error = part<QMessageBox>("errorDialog");
  ASSERT_NE(error, nullptr);
  error->accept();
  EXPECT_TRUE(names().isEmpty());
}

}  // namespace
}  // namespace syncline::ui
