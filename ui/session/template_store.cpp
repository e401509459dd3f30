// SPDX-License-Identifier: Apache-2.0
#include "ui/session/template_store.h"

#include <QDir>
#include <QFileInfo>
#include <QUrl>
#include <utility>

#include "config/project.h"
#include "eni/project/project_file.h"

namespace syncline::ui {
namespace {

const QString kTemplateSuffix = QStringLiteral(".syncline");

}  // namespace

TemplateStore::TemplateStore(QString folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) {}

/// Characters that some file system does not take stand as %XX; so does a dot in front, which would hide the file.
QString TemplateStore::fileOf(const QString& name) const {
  QString file;
  for (const auto c : name) {
    const bool plain = c >= u' ' && !QStringView(u"/\\%:*?\"<>|").contains(c) && !(c == u'.' && file.isEmpty());
    file += plain ? QString(c) : QStringLiteral("%%1").arg(int{c.unicode()}, 2, 16, QLatin1Char('0'));
  }
  return QDir(folder_).filePath(file + kTemplateSuffix);
}

QList<TemplateStore::Entry> TemplateStore::entries() const {
  QList<Entry> all;
  if (!isKept()) return all;
  const auto files = QDir(folder_).entryInfoList({u'*' + kTemplateSuffix}, QDir::Files, QDir::Name | QDir::IgnoreCase);
  for (const auto& file : files)
    all.append({QUrl::fromPercentEncoding(file.completeBaseName().toUtf8()), file.filePath()});
  return all;
}

bool TemplateStore::has(const QString& name) const { return isKept() && QFileInfo::exists(fileOf(name)); }

Status TemplateStore::save(const QString& name, const Machine& machine) {
  QDir().mkpath(folder_);  // what keeps it from being made keeps the file from being written, too
  auto status = eni::save_machine(machine, fileOf(name).toStdString());
  if (status) Q_EMIT changed();
  return status;
}

Status TemplateStore::remove(const Entry& entry) {
  QFile file(entry.path);
  const bool removed = !file.exists() || file.remove();
  Q_EMIT changed();
  if (removed) return {};
  Error error{ErrorCode::kFileNotWritable};
  error.file = entry.path.toStdString();
  return fail(std::move(error));
}

}  // namespace syncline::ui
