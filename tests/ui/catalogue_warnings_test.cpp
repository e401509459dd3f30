// SPDX-License-Identifier: Apache-2.0
// What is wrong in ESI files is said in the user's language, down to the error within the warning.
#include <gtest/gtest.h>

#include <QFile>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "eni/esi/esi_reader.h"
#include "sqlite/sqlite_database.h"
#include "support/speak.h"
#include "support/ui_test_support.h"
#include "tests/support/sloppy_esi.h"
#include "ui/main_window.h"
#include "ui/models/message_model.h"
#include "ui/session/device_catalogue.h"
#include "ui/session/workspace.h"
#include "ui/text/error_text.h"

namespace syncline::ui {
namespace {

using test::waitFor;

/// The little words of English sentences that neither German has nor a file's names are.
QStringList englishIn(QString text) {
  static const auto kWords = QStringLiteral(
                                 "the is are of out not and to as read taken which should though here other another "
                                 "known cannot used value left "
                                 "counts too many with by for it that no missing from has does exist check there "
                                 "instead begin begins file "
                                 "again")
                                 .split(u' ');
  static const QRegularExpression kTheirs(QStringLiteral("\"[^\"]*\"|<[^>]*>|(/[^\\s:]+)+"));
  text.remove(kTheirs);  // what stands in the file, and its path
  QStringList found;
  for (const auto& word : text.toLower().split(QRegularExpression(QStringLiteral("[^a-z]+")), Qt::SkipEmptyParts)) {
    if (kWords.contains(word)) found << word;
  }
  return found;
}

class CatalogueWarnings : public ::testing::Test {
 protected:
  CatalogueWarnings() : before_(qgetenv("XDG_CACHE_HOME")) {
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
    for (const auto& [name, text] : sample::sloppy_esi_files()) {
      QFile file(esi_.filePath(QString::fromStdString(name)));
      EXPECT_TRUE(file.open(QIODevice::WriteOnly));
      file.write(QByteArray::fromStdString(text));
    }
  }
  ~CatalogueWarnings() override { qputenv("XDG_CACHE_HOME", before_); }

  /// All that the message window says of these files, when they are added, and again when their devices were read.
  QStringList told() {
    Workspace workspace(test::virtualEnvironment());
    MainWindow window(workspace);
    auto& catalogue = workspace.catalogue();
    int ended = 0;
    QObject::connect(&catalogue, &DeviceCatalogue::added, &window, [&] { ++ended; });
    catalogue.add({esi_.path()});
    EXPECT_TRUE(waitFor([&] { return ended == 2; }));  // what is there at the start, and these
    eni::CatalogueSearch all;
    std::vector<eni::CatalogueEntry> entries;
    catalogue.search(all, &window, [&](const Result<CatalogueAnswer>& answer) { entries = answer->entries; });
    EXPECT_TRUE(waitFor([&] { return !entries.empty(); }));
    std::size_t read = 0;
    for (const auto& entry : entries) catalogue.read(entry, &window, [&](const Result<DeviceDescription>&) { ++read; });
    EXPECT_TRUE(waitFor([&] { return read == entries.size(); }));
    catalogue.add({esi_.path()});
    EXPECT_TRUE(waitFor([&] { return ended == 3; }));
    QStringList texts;
    const auto& messages = workspace.messages();
    for (int row = 0; row < messages.rowCount(); ++row) {
      if (messages.message(row).severity == Severity::kWarning)
        texts << messages.index(row, MessageModel::kText).data().toString();
    }
    workspace.document().undoStack().setClean();
    return texts;
  }

  QTemporaryDir cache_, esi_;

 private:
  QByteArray before_;
};

/// The second time out of the database, which was made while the window spoke another language.
TEST_F(CatalogueWarnings, AreSaidInTheUsersLanguage) {
  const auto english = told();
  EXPECT_GE(english.size(), 27);
  for (const auto& text : english) EXPECT_FALSE(englishIn(text).isEmpty()) << qPrintable(text);
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    const auto texts = told();
    EXPECT_EQ(texts.size(), english.size()) << qPrintable(code);
    for (const auto& text : texts)
      EXPECT_TRUE(englishIn(text).isEmpty()) << qPrintable(englishIn(text).join(u' ')) << ": " << qPrintable(text);
  }
}

/// That an index was made again is nothing that anybody has to mend.
TEST_F(CatalogueWarnings, OfAnIndexOfAnotherVersionAreInformation) {
  static_cast<void>(told());
  const auto path = (cache_.path() + QStringLiteral("/syncline/esi-catalogue.sqlite")).toStdString();
  ASSERT_TRUE(SqlDatabase::open(path)->execute("PRAGMA user_version=3"));
  const test::Speak speak(QStringLiteral("de"));
  Workspace workspace(test::virtualEnvironment());
  const MainWindow window(workspace);
  QString text;
  QObject::connect(&workspace.catalogue(), &DeviceCatalogue::noted, &window,
                   [&](const eni::FileWarning& note) { text = warningText(note); });
  workspace.catalogue().add({esi_.path()});
  ASSERT_TRUE(waitFor([&] { return !text.isEmpty(); }));
  EXPECT_TRUE(text.contains(QStringLiteral("wird neu angelegt: er hat die Version 3"))) << qPrintable(text);
  const auto& messages = workspace.messages();
  const auto last = messages.message(messages.rowCount() - 1);
  EXPECT_EQ(last.text, text);
  EXPECT_EQ(last.severity, Severity::kNote);
}

TEST_F(CatalogueWarnings, OfAFileThatIsReadAloneToo) {
  const auto alone = eni::parse_esi(sample::sloppy_device(), "text.xml");
  ASSERT_TRUE(alone);
  for (const auto& code : test::translatedLanguages()) {
    const test::Speak speak(code);
    for (const auto& warning : alone->warnings) {
      const auto text = warningText(warning);
      EXPECT_TRUE(englishIn(text.mid(8)).isEmpty()) << qPrintable(text);
      EXPECT_TRUE(text.contains(QStringLiteral("text.xml:%1").arg(warning.line))) << qPrintable(text);
      EXPECT_EQ(text.count(QStringLiteral("text.xml:%1").arg(warning.line)), 1) << qPrintable(text);
    }
  }
}

}  // namespace
}  // namespace syncline::ui
