// SPDX-License-Identifier: Apache-2.0
// No sentence of the window is without its words in any language of translations/, and none loses what is put into it.
#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QLibraryInfo>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>
#include <set>
#include <utility>

#include "support/speak.h"
#include "tests/support/source_dir.h"
#include "ui/text/finding_text.h"

namespace syncline {
namespace {

using Sentence = std::pair<QString, QString>;  // context and source

struct Translation {
  QStringList forms;  // one, or one a number form
  bool numbered = false, open = false;
};

using Sentences = std::map<Sentence, Translation>;

Translation readTranslation(QXmlStreamReader& xml, bool numbered) {
  Translation result;
  result.numbered = numbered;
  result.open = xml.attributes().value(QStringLiteral("type")) == QStringLiteral("unfinished");
  if (!numbered) {
    result.forms.append(xml.readElementText());
    return result;
  }
  while (xml.readNextStartElement()) result.forms.append(xml.readElementText());
  return result;
}

/// Sentences of a TS file.
Sentences sentences(const QString& path) {
  Sentences all;
  QFile file(path);
  EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << qPrintable(path);
  QXmlStreamReader xml(&file);
  QString context, source;
  bool numbered = false;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QStringLiteral("name")) {
      context = xml.readElementText().remove(QStringLiteral("syncline::ui::"));
    } else if (xml.name() == QStringLiteral("message")) {
      numbered = xml.attributes().value(QStringLiteral("numerus")) == QStringLiteral("yes");
    } else if (xml.name() == QStringLiteral("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QStringLiteral("translation")) {
      all[{context, source}] = readTranslation(xml, numbered);
    }
  }
  EXPECT_FALSE(xml.hasError()) << qPrintable(path);
  return all;
}

QDir translations() { return QDir(QString::fromStdString(test::source_dir()) + QStringLiteral("/translations")); }

QStringList filesOf(const QString& folder, const QString& pattern) {
  QStringList paths;
  const QDir dir(translations().filePath(folder));
  for (const auto& name : dir.entryList({pattern}, QDir::Files, QDir::Name)) paths.append(dir.filePath(name));
  return paths;
}

bool isEnglish(const QString& path) { return path.endsWith(QStringLiteral("_en.ts")); }

/// %1, %n and {name} of a sentence; {name:words} is one, too.
std::set<QString> placeholders(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("%L?\\d|%n|\\{\\w+(?=[:}])"));
  std::set<QString> names;
  for (auto it = pattern.globalMatch(text); it.hasNext();) names.insert(it.next().captured());
  return names;
}

/// Names of the counts that choose words.
std::set<QString> choices(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("\\{(\\w+):[^|}]*\\|[^}]*\\}"));
  std::set<QString> names;
  for (auto it = pattern.globalMatch(text); it.hasNext();) names.insert(it.next().captured(1));
  return names;
}

TEST(Translations, AreComplete) {
  const auto lupdate = QLibraryInfo::path(QLibraryInfo::BinariesPath) + QStringLiteral("/lupdate");
  if (!QFile::exists(lupdate)) GTEST_SKIP() << "no " << lupdate.toStdString();
  QTemporaryDir folder;
  const auto found = folder.filePath(QStringLiteral("found.ts"));
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(test::source_dir()));
  process.start(lupdate, {QStringLiteral("-silent"), QStringLiteral("ui"), QStringLiteral("-I"), QStringLiteral("."),
                          QStringLiteral("-ts"), found});
  ASSERT_TRUE(process.waitForFinished());
  const auto wanted = sentences(found);
  ASSERT_GT(wanted.size(), 600U) << process.readAllStandardError().toStdString();
  const auto files = filesOf({}, QStringLiteral("syncline_*.ts"));
  ASSERT_GE(files.size(), 3);
  for (const auto& path : files) {
    const auto known = sentences(path);
    for (const auto& [sentence, translation] : wanted) {
      if (isEnglish(path) && !translation.numbered) continue;  // English is in the sources, but for the plurals
      EXPECT_TRUE(known.contains(sentence))
          << qPrintable(path) << " lacks " << qPrintable(sentence.first) << ": " << qPrintable(sentence.second);
    }
  }
}

/// The words of core, which lupdate does not see.
TEST(Translations, AreCompleteForFindings) {
  const auto files = filesOf(QStringLiteral("words"), QStringLiteral("words_*.ts"));
  ASSERT_GE(files.size(), 1);
  for (const auto& path : files) {
    const auto known = sentences(path);
    for (const auto text : ui::translatableFindings()) {
      const auto source = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
      EXPECT_TRUE(known.contains({QStringLiteral("Finding"), source})) << qPrintable(path) << " lacks " << text;
    }
  }
}

TEST(Translations, SayWhatTheSourceSays) {
  for (const auto& path :
       filesOf({}, QStringLiteral("*.ts")) + filesOf(QStringLiteral("words"), QStringLiteral("*.ts"))) {
    SCOPED_TRACE(qPrintable(path));
    qsizetype number_forms = 0;
    for (const auto& [sentence, translation] : sentences(path)) {
      const auto& source = sentence.second;
      EXPECT_FALSE(translation.open) << qPrintable(source) << ": unfinished";
      if (translation.numbered) {
        if (number_forms == 0) number_forms = translation.forms.size();
        EXPECT_EQ(translation.forms.size(), number_forms) << qPrintable(source);
      }
      for (const auto& form : translation.forms) {
        EXPECT_FALSE(form.trimmed().isEmpty()) << qPrintable(source) << ": empty";
        EXPECT_EQ(placeholders(form), placeholders(source)) << qPrintable(source) << ": " << qPrintable(form);
        EXPECT_EQ(form.contains(u'\u2026'), source.contains(u'\u2026'))
            << qPrintable(source) << ": " << qPrintable(form);
      }
    }
  }
}

/// Chinese nouns have one form.
TEST(Translations, HaveAFormForOneWhereEnglishHas) {
  for (const auto& [sentence, translation] : sentences(translations().filePath(QStringLiteral("words/words_de.ts")))) {
    const auto& german = translation.forms.front();
    for (const auto& name : choices(sentence.second)) {
      const bool invariant = german.contains(QStringLiteral("{%1}-mal").arg(name)) ||
                             german.contains(QStringLiteral("statt {%1}").arg(name));
      EXPECT_TRUE(invariant || choices(german).contains(name)) << qPrintable(german) << ": " << qPrintable(name);
    }
  }
}

TEST(Translations, AreOfferedInTheirOwnWords) {
  QStringList names;
  for (const auto& language : ui::languages()) {
    names.append(language.name);
    EXPECT_TRUE(QFile::exists(translations().filePath(QStringLiteral("syncline_%1.ts").arg(language.code))));
  }
  EXPECT_EQ(names.size(), filesOf({}, QStringLiteral("syncline_*.ts")).size());
  EXPECT_TRUE(names.contains(QStringLiteral("English"))) << "not that of a country";
  EXPECT_TRUE(names.contains(QStringLiteral("Deutsch")));
  EXPECT_TRUE(names.contains(QStringLiteral("简体中文"))) << qPrintable(names.join(u' '));
}

}  // namespace
}  // namespace syncline
