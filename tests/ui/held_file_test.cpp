// SPDX-License-Identifier: Apache-2.0
// The window writes over nothing that is open in it.
#include "ui/files/held_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QTimer>
#include <filesystem>

#include "reasons/because.h"
#include "support/whole_file.h"
#include "tests/support/temporary_folder.h"
#include "ui/files/save_name.h"
#include "ui/session/exporter.h"
#include "ui/session/opened_recording.h"
#include "ui/session/project_document.h"
#include "ui/session/workspace.h"

namespace syncline::ui {
namespace {

using testing::HasSubstr;

class HeldFiles : public testing::Test {
 protected:
  HeldFiles() { EXPECT_TRUE(write_whole_file(folder_.file("a"), "content")); }
  [[nodiscard]] QString path(const std::string& name) const { return QString::fromStdString(folder_.file(name)); }
  [[nodiscard]] std::string content(const std::string& name) const { return *read_whole_file(folder_.file(name)); }
  test::TemporaryFolder folder_;
};

TEST_F(HeldFiles, AreNotWrittenUnderAnyName) {
  std::filesystem::create_symlink("a", folder_.file("link"));
  std::filesystem::create_hard_link(folder_.file("a"), folder_.file("hard"));
  {
    HeldFile held(because("the project that is open here"));
    EXPECT_TRUE(mayWrite(path("a")));
    held.hold(path("a"));
    for (const std::string name : {"a", "./a", "link", "hard"}) {
      const auto status = mayWrite(path(name));
      ASSERT_FALSE(status) << name;
      EXPECT_EQ(status.error().code, ErrorCode::kFileNotWritable);
      EXPECT_THAT(status.error().detail.text(), HasSubstr("the project that is open here"));
      EXPECT_TRUE(mayWrite(path(name), &held)) << "its own";
    }
    EXPECT_TRUE(mayWrite(path("b")));
    EXPECT_TRUE(mayWrite({}));
    held.hold(path("b"));
    EXPECT_TRUE(mayWrite(path("a")));
  }
  EXPECT_TRUE(mayWrite(path("b"))) << "nobody has it any more";
}

TEST_F(HeldFiles, OfTheProjectAreNotExportedOnto) {
  Environment environment;
  Workspace workspace(std::move(environment));
  ASSERT_TRUE(workspace.document().save(path("m.syncline")));
  const auto before = content("m.syncline");
  const auto exported = exportEni(workspace, path("m.syncline"));
  ASSERT_FALSE(exported);
  EXPECT_THAT(exported.error().detail.text(), HasSubstr("choose another name"));
  EXPECT_EQ(content("m.syncline"), before);
  EXPECT_TRUE(workspace.document().save(path("m.syncline"))) << "it is its own";
}

TEST_F(HeldFiles, OfARecordingAreNotSavedOnto) {
  OpenedRecording recording;
  recording.read(path("a"));  // whether it is one or not: it is being read
  ProjectDocument document;
  const auto saved = document.save(path("a"));
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().detail.text(), HasSubstr("a recording that is shown here"));
  EXPECT_EQ(content("a"), "content");
}

/// The dialog has asked about the name as it was typed, which is another file.
TEST_F(HeldFiles, ANameWithoutASuffixReplacesNothingUnasked) {
  const auto complete = [this](const char* name, int answer) {
    QTimer::singleShot(0, [answer] {
      auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (box != nullptr) box->button(static_cast<QMessageBox::StandardButton>(answer))->click();
    });
    const auto result = withSuffix(nullptr, QStringLiteral("Save"), path(name), QStringLiteral(".csv"));
    QApplication::processEvents();
    return result;
  };
  EXPECT_TRUE(write_whole_file(folder_.file("old.csv"), "content"));
  EXPECT_EQ(complete("new", QMessageBox::No), path("new.csv"));
  EXPECT_EQ(complete("new.txt", QMessageBox::No), path("new.txt"));
  EXPECT_EQ(complete("old.csv", QMessageBox::No), path("old.csv")) << "asked by the dialog";
  EXPECT_EQ(complete("old", QMessageBox::No), QString());
  EXPECT_EQ(complete("old", QMessageBox::Yes), path("old.csv"));
  EXPECT_EQ(withSuffix(nullptr, QString(), QString(), QStringLiteral(".csv")), QString());
}

}  // namespace
}  // namespace syncline::ui
