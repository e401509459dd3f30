// SPDX-License-Identifier: Apache-2.0
// A machine is made step by step, beside the project of the window.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractItemModelTester>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QRadioButton>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QTreeView>
#include <algorithm>
#include <memory>

#include "eni/project/project_file.h"
#include "settings/settings_table.h"
#include "support/cut_texts.h"
#include "support/project_window.h"
#include "support/speak.h"
#include "ui/dialogs/file_commands.h"
#include "ui/wizard/dc_mode_model.h"
#include "ui/wizard/machine_draft.h"
#include "ui/wizard/new_machine_wizard.h"

namespace syncline::ui {
namespace {

using test::find;
using test::waitFor;

QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Answers the next question with its way on, or with its way back.
void answer(bool on) {
  QTimer::singleShot(0, qApp, [on] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    if (auto* go = box->findChild<QPushButton*>(QStringLiteral("questionGo")); on && go != nullptr) return go->click();
    box->reject();
  });
}

class Wizard : public test::ProjectWindow {
 protected:
  Wizard() : Wizard(test::smallProject()) {}
  explicit Wizard(const Project& machine) : ProjectWindow(machine) {
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
  }
  ~Wizard() override { qputenv("XDG_CACHE_HOME", before_); }

  NewMachineWizard& open() {
    QTest::keyClick(&window_, Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);
    auto* found = window_.findChild<NewMachineWizard*>();
    EXPECT_NE(found, nullptr);
    wizard_ = found;
    // Alt keys are those of the active window.
    found->activateWindow();
    EXPECT_TRUE(waitFor([found] { return QApplication::activeWindow() == found; }));
    return *found;
  }
  template <class Widget>
  Widget& part(const char* name) {
    return *find<Widget>(*wizard_, name);
  }
  /// As a user: keys only.
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    auto* focus = wizard_->focusWidget();
    QTest::keyClick(focus != nullptr ? focus : wizard_.data(), key, modifiers);
    // A button that a key presses is up again a moment later.
    const auto isUp = [this] {
      return wizard_ == nullptr ||
             std::ranges::none_of(wizard_->findChildren<QAbstractButton*>(), &QAbstractButton::isDown);
    };
    EXPECT_TRUE(waitFor(isUp));
  }
  void next() { key(Qt::Key_N, Qt::AltModifier); }
  void back() { key(Qt::Key_K, Qt::AltModifier); }
  void addFromCatalogue(const char* type) {
    auto& words = part<QLineEdit>("catalogueSearch");
    const auto count = wizard_->draft().project().slaves.size();
    words.setFocus();
    words.selectAll();
    QTest::keyClicks(&words, QLatin1String(type));
    QTest::keyClick(&words, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return wizard_->draft().project().slaves.size() == count + 1; })) << type;
  }
  void buildSmall() {
    key(Qt::Key_D, Qt::AltModifier);
    ASSERT_TRUE(part<QRadioButton>("wizardFromCatalogue").isChecked());
    for (const char* type : {"SL-1100", "SL-1002", "SL-SV7"}) addFromCatalogue(type);
  }
  void gone() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }

  QByteArray before_ = qgetenv("XDG_CACHE_HOME");
  QTemporaryDir cache_, out_;
  QPointer<NewMachineWizard> wizard_;
};

TEST_F(Wizard, MakesAMachineFromTheCatalogueByKeysWhoseEniIsThatOfTheSavedProject) {
  open();
  next();
  EXPECT_EQ(wizard_->step(), 0) << "there are no slaves";
  EXPECT_FALSE(part<QLabel>("wizardObstacle").text().isEmpty());
  buildSmall();
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(part<QListWidget>("wizardSlaves").count(), 3);
  EXPECT_EQ(wizard_->step(), 0) << "Enter in the search adds and does not lead on";
  next();
  ASSERT_EQ(wizard_->step(), 1);
  test::type(part<QComboBox>("masterCycle"), QStringLiteral("2000"), false);
  next();
  ASSERT_EQ(wizard_->step(), 2);
  EXPECT_EQ(wizard_->draft().project().master.cycle_time, 2 * kMillisecond);
  next();
  ASSERT_EQ(wizard_->step(), 3);
  EXPECT_EQ(wizard_->draft().project().master.dc.dcm.mode, DcmMode::kMasterShift) << "the proposal for one network";
  EXPECT_TRUE(wizard_->draft().project().master.dc.sync_window.enabled) << "a new machine is watched";
  EXPECT_FALSE(part<QPushButton>("wizardUseProposal").isEnabled()) << "it is in use";
  part<QRadioButton>("dcmBusShift").click();
  key(Qt::Key_K, Qt::AltModifier);
  next();
  EXPECT_EQ(wizard_->draft().project().master.dc.dcm.mode, DcmMode::kBusShift) << "what was said otherwise stays";
  key(Qt::Key_U, Qt::AltModifier);
  EXPECT_EQ(wizard_->draft().project().master.dc.dcm.mode, DcmMode::kMasterShift);
  next();
  ASSERT_EQ(wizard_->step(), 4);
  next();
  ASSERT_EQ(wizard_->step(), 5);
  key(Qt::Key_E, Qt::AltModifier);
  const auto eni = out_.filePath(QStringLiteral("wizard.xml"));
  test::type(part<QLineEdit>("wizardExportPath"), eni, false);
  workspace_.document().undoStack().setClean();
  key(Qt::Key_F, Qt::AltModifier);
  gone();
  EXPECT_EQ(wizard_, nullptr);
  ASSERT_EQ(project().slaves.size(), 3U);
  EXPECT_EQ(project().master.cycle_time, 2 * kMillisecond);
  EXPECT_TRUE(workspace_.document().path().isEmpty());
  EXPECT_TRUE(workspace_.document().isModified()) << "it is not saved";
  EXPECT_EQ(workspace_.document().undoStack().count(), 0) << "one baseline";
  const auto saved = out_.filePath(QStringLiteral("saved.syncline"));
  ASSERT_TRUE(workspace_.document().save(saved));
  ASSERT_TRUE(window_.files().openFile(saved));
  const auto again = out_.filePath(QStringLiteral("again.xml"));
  ASSERT_TRUE(window_.files().exportTo(again));
  EXPECT_FALSE(contentOf(eni).isEmpty());
  EXPECT_EQ(contentOf(eni), contentOf(again));
}

TEST_F(Wizard, LeavesProjectAndUndoStepsAloneWhenItIsCancelled) {
  const auto& row = settings::row("master.cycle_time_us");
  ASSERT_TRUE(workspace_.document().set(QStringLiteral("edit"), {{&row, {}, std::int64_t{500'000}}}));
  const auto before = project();
  const int steps = workspace_.document().undoStack().count();
  open();
  buildSmall();
  ASSERT_FALSE(HasFatalFailure());
  for (int step = 1; step < 6; ++step) next();
  ASSERT_EQ(wizard_->step(), 5);
  answer(false);
  key(Qt::Key_Escape);
  EXPECT_TRUE(wizard_->isVisible()) << "asked, and stayed";
  answer(true);
  key(Qt::Key_Escape);
  gone();
  EXPECT_EQ(wizard_, nullptr);
  EXPECT_EQ(project(), before);
  EXPECT_EQ(workspace_.document().undoStack().count(), steps);
}

TEST_F(Wizard, KeepsWhatWasSetOnTheWayBack) {
  open();
  buildSmall();
  ASSERT_FALSE(HasFatalFailure());
  next();
  test::type(part<QComboBox>("masterCycle"), QStringLiteral("500"), false);
  next();
  next();
  part<QRadioButton>("dcmMasterShift").click();
  back();
  back();
  back();
  EXPECT_EQ(wizard_->step(), 0);
  addFromCatalogue("SL-2002");
  const auto& made = wizard_->draft().project();
  EXPECT_EQ(made.slaves.size(), 4U);
  EXPECT_EQ(made.master.cycle_time, 500 * kMicrosecond);
  EXPECT_EQ(made.master.dc.dcm.mode, DcmMode::kMasterShift);
  answer(true);
  wizard_->reject();
}

TEST_F(Wizard, DoesNotGoOnWithAValueThatIsNone) {
  open();
  buildSmall();
  ASSERT_FALSE(HasFatalFailure());
  next();
  test::type(part<QComboBox>("masterCycle"), QStringLiteral("fast"), false);
  next();
  EXPECT_EQ(wizard_->step(), 1);
  EXPECT_FALSE(part<QLabel>("wizardObstacle").text().isEmpty());
  answer(true);
  wizard_->reject();
}

TEST_F(Wizard, ScansIntoItsDraftAndSaysWhoCannotLead) {
  const auto before = project();
  open();
  wizard_->draft().scan(workspace_.environment().demo_link);
  ASSERT_TRUE(waitFor([this] { return !wizard_->draft().isScanning(); }));
  ASSERT_FALSE(wizard_->draft().project().slaves.empty());
  EXPECT_EQ(project(), before);
  next();
  next();
  const auto& clocks = part<QTableWidget>("wizardClocks");
  ASSERT_EQ(clocks.rowCount(), static_cast<int>(wizard_->draft().project().slaves.size()));
  for (int row = 0; row < clocks.rowCount(); ++row) {
    if (wizard_->draft().project().slaves[static_cast<std::size_t>(row)].device.dc) continue;
    EXPECT_FALSE(clocks.item(row, 2)->text().isEmpty()) << "a reason for slave " << row;
  }
  answer(true);
  wizard_->reject();
}

TEST_F(Wizard, WarnsAtOnceOfACycleThatADriveRefuses) {
  open();
  buildSmall();
  ASSERT_FALSE(HasFatalFailure());
  for (int step = 1; step < 5; ++step) next();
  auto& table = part<QTableView>("wizardModes");
  auto* model = table.model();
  const QAbstractItemModelTester tester(model, QAbstractItemModelTester::FailureReportingMode::Fatal);
  const auto found = [&] { return model->index(2, DcModeModel::kNote).data().toString(); };
  EXPECT_TRUE(found().isEmpty()) << qPrintable(found());
  table.setCurrentIndex(model->index(2, DcModeModel::kFactor));
  QTest::keyClick(&table, Qt::Key_F2);
  auto* box = table.findChild<QComboBox*>(QStringLiteral("wizardFactorEdit"));
  ASSERT_NE(box, nullptr);
  box->setCurrentIndex(box->findData(-16));
  QTest::keyClick(box, Qt::Key_Return);
  // A view takes what Enter closes once the key has been handled.
  EXPECT_TRUE(waitFor([&] { return wizard_->draft().project().slaves[2].dc.sync0.cycle_factor == -16; }));
  EXPECT_FALSE(found().isEmpty()) << "62.5 us is no cycle of the drive";
  EXPECT_EQ(wizard_->step(), 4) << "Enter took the choice";
  answer(true);
  wizard_->reject();
}

TEST_F(Wizard, TakesAProjectAsAPattern) {
  const auto file = out_.filePath(QStringLiteral("pattern.syncline"));
  ASSERT_TRUE(eni::save_project(project(), file.toStdString()));
  const auto content = contentOf(file);
  open();
  wizard_->draft().readProject(out_.filePath(QStringLiteral("none.syncline")));
  EXPECT_TRUE(part<QLabel>("wizardTold").text().contains(QStringLiteral("none.syncline")));
  wizard_->draft().readProject(file);
  EXPECT_EQ(wizard_->draft().project(), project());
  for (int step = 1; step < 6; ++step) next();
  workspace_.document().undoStack().setClean();
  key(Qt::Key_F, Qt::AltModifier);
  gone();
  EXPECT_EQ(wizard_, nullptr);
  EXPECT_TRUE(workspace_.document().path().isEmpty());
  EXPECT_EQ(contentOf(file), content);
}

/// With SYNCLINE_PICTURES=FOLDER each step is also painted there.
class WizardTexts : public ::testing::TestWithParam<const char*> {};

TEST_P(WizardTexts, AreNotCut) {
  const test::Speak speak{QLatin1String(GetParam())};
  Workspace workspace(test::virtualEnvironment());
  NewMachineWizard wizard(workspace, nullptr);
  wizard.show();
  wizard.draft().scan(workspace.environment().demo_link);
  ASSERT_TRUE(waitFor([&] { return !wizard.draft().isScanning(); }));
  for (const QSize size : {QSize(940, 560), QSize(1100, 700)}) {
    wizard.resize(size);
    for (int step = 0; step < 6; ++step) {
      ASSERT_EQ(wizard.step(), step);
      for (int round = 0; round < 3; ++round) QApplication::processEvents();
      EXPECT_LE(wizard.width(), size.width()) << "it does not become so small";
      EXPECT_LE(wizard.height(), size.height());
      if (step == 5) {
        const auto& eni = wizard.draft().workspace().eni();
        ASSERT_TRUE(waitFor([&] { return eni.isCurrent() && eni.check() != nullptr; }));
        QApplication::processEvents();
      }
      const auto pictures = qEnvironmentVariable("SYNCLINE_PICTURES");
      const auto name =
          QStringLiteral("wizard-%1-%2-%3.png").arg(QLatin1String(GetParam())).arg(size.width()).arg(step);
      if (!pictures.isEmpty()) wizard.grab().save(QDir(pictures).filePath(name));
      const test::CutTexts cut(wizard);
      for (const auto& text : cut.found()) ADD_FAILURE() << step << ": " << qPrintable(text);
      if (step < 5) find<QPushButton>(wizard, "wizardNext")->click();
    }
    for (int step = 0; step < 5; ++step) find<QPushButton>(wizard, "wizardBack")->click();
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WizardTexts, ::testing::Values("en", "de", "zh_CN"),
                         [](const auto& language) { return std::string(language.param); });

}  // namespace
}  // namespace syncline::ui
