// SPDX-License-Identifier: Apache-2.0
// No sentence of the window is without its German.
#include <gtest/gtest.h>

#include <QFile>
#include <QLibraryInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <set>

#include "tests/support/source_dir.h"

namespace syncline {
namespace {

using Sentence = std::pair<QString, QString>;  // context and source

/// Sentences of a TS file; `translated`: those with a translation only.
std::set<Sentence> sentences(const QString& path, bool translated) {
  std::set<Sentence> all;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return all;
  QXmlStreamReader xml(&file);
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QStringLiteral("name")) {
      context = xml.readElementText().remove(QStringLiteral("syncline::ui::"));
    } else if (xml.name() == QStringLiteral("source")) {
      source = xml.readElementText();
    } else if (xml.name() == QStringLiteral("translation")) {
      const bool open = xml.attributes().value(QStringLiteral("type")) == QStringLiteral("unfinished");
      const auto text = xml.readElementText(QXmlStreamReader::IncludeChildElements).trimmed();
      if (!translated || (!open && !text.isEmpty())) all.insert({context, source});
    }
  }
  EXPECT_FALSE(xml.hasError()) << path.toStdString();
  return all;
}

TEST(Translations, AreComplete) {
  const auto lupdate = QLibraryInfo::path(QLibraryInfo::BinariesPath) + QStringLiteral("/lupdate");
  if (!QFile::exists(lupdate)) GTEST_SKIP() << "no " << lupdate.toStdString();
  const auto root = QString::fromStdString(test::source_dir());
  QTemporaryDir folder;
  const auto found = folder.filePath(QStringLiteral("found.ts"));
  QProcess process;
  process.setWorkingDirectory(root);
  process.start(lupdate, {QStringLiteral("-silent"), QStringLiteral("ui"), QStringLiteral("-I"), QStringLiteral("."),
                          QStringLiteral("-ts"), found});
  ASSERT_TRUE(process.waitForFinished());
  const auto wanted = sentences(found, false);
  ASSERT_GT(wanted.size(), 900U) << process.readAllStandardError().toStdString();
  const auto german = sentences(root + QStringLiteral("/translations/syncline_de.ts"), true);
  for (const auto& [context, source] : wanted)
    EXPECT_TRUE(german.contains({context, source})) << qPrintable(context) << ": " << qPrintable(source);
}

}  // namespace
}  // namespace syncline
