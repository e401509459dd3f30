// SPDX-License-Identifier: Apache-2.0
#include "ui/session/file_kind.h"

#include <QByteArray>
#include <QFile>
#include <QRegularExpression>
#include <string_view>

#include "record/import_run.h"
#include "record/recording_reader.h"

namespace syncline::ui {
namespace {

constexpr qint64 kBeginning = 64 * 1024;

/// Of pcap in both byte orders and both resolutions, and of pcapng.
bool isCapture(const QByteArray& begin) {
  for (const char* magic :
       {"\xa1\xb2\xc3\xd4", "\xd4\xc3\xb2\xa1", "\xa1\xb2\x3c\x4d", "\x4d\x3c\xb2\xa1", "\x0a\x0d\x0d\x0a"})
    if (begin.startsWith(QByteArray(magic, 4))) return true;
  return false;
}

/// Name of the first element, without its prefix; files in UTF-16 lose their zeros for that.
QString rootElement(QByteArray begin) {
  begin.replace('\0', "");
  static const QRegularExpression element(QStringLiteral("<(?:[A-Za-z_][\\w.-]*:)?([A-Za-z_][\\w.-]*)[\\s/>]"));
  static const QRegularExpression comment(QStringLiteral("<!--.*?-->"), QRegularExpression::DotMatchesEverythingOption);
  auto text = QString::fromLatin1(begin);
  return element.match(text.remove(comment)).captured(1);
}

}  // namespace

FileKind fileKind(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return FileKind::kUnreadable;
  const auto begin = file.read(kBeginning);
  if (isCapture(begin)) return FileKind::kCapture;
  if (begin.startsWith("SQLite format 3") || path.endsWith(QStringLiteral(".slrec"), Qt::CaseInsensitive))
    return FileKind::kRecording;
  const auto root = rootElement(begin);
  if (root == QStringLiteral("SynclineProject")) return FileKind::kProject;
  if (root == QStringLiteral("EtherCATConfig")) return FileKind::kEni;
  if (root.startsWith(QStringLiteral("EtherCATInfo")) || root == QStringLiteral("EtherCATModule"))
    return FileKind::kEsi;
  if (path.endsWith(QStringLiteral(".toml"), Qt::CaseInsensitive)) return FileKind::kScenario;
  if (path.endsWith(QStringLiteral(".syncline"), Qt::CaseInsensitive)) return FileKind::kProject;  // a damaged one
  if (table_kind(std::string_view(begin.constData(), static_cast<std::size_t>(begin.size()))))
    return FileKind::kRunTable;
  return FileKind::kOther;
}

}  // namespace syncline::ui
