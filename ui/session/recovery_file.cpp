// SPDX-License-Identifier: Apache-2.0
#include "ui/session/recovery_file.h"

#include <QStringList>

#include "config/project.h"
#include "eni/project/project_file.h"
#include "reasons/because.h"
#include "support/whole_file.h"

namespace syncline::ui {
namespace {

const QString kTitle = QStringLiteral("syncline unsaved work 1");

/// Lines of words up to an empty one; behind it the project file.
Result<std::pair<QStringList, std::string>> parts(const QString& file) {
  auto content = read_whole_file(file.toStdString());
  if (!content) return tl::unexpected(content.error());
  const auto gap = content->find("\n\n");
  auto head = QString::fromStdString(content->substr(0, gap)).split(u'\n');
  if (gap == std::string::npos || head.front() != kTitle) {
    return fail(Error{.code = ErrorCode::kNotThatKindOfFile,
                      .detail = because("unsaved work of Syncline"),
                      .file = file.toStdString()});
  }
  return std::pair(std::move(head), content->substr(gap + 2));
}

QString line(const QStringList& head, const QString& key) {
  for (const auto& text : head) {
    if (text.startsWith(key + u' ')) return text.mid(key.size() + 1);
  }
  return {};
}

QString oneLine(QString text) { return text.replace(u'\n', u' '); }

}  // namespace

Status keepWork(const QString& file, const KeptWork& work, const Machine& machine) {
  const auto head =
      QStringList{kTitle, QStringLiteral("project ") + oneLine(work.path),
                  QStringLiteral("saved ") + work.saved.toUTC().toString(Qt::ISODateWithMs),
                  QStringLiteral("edit ") + oneLine(work.last_edit), QStringLiteral("slaves %1").arg(work.slaves)}
          .join(u'\n') +
      QStringLiteral("\n\n");
  return write_whole_file(file.toStdString(), head.toStdString() + eni::write_machine(machine));
}

Result<KeptWork> readWork(const QString& file) {
  const auto read = parts(file);
  if (!read) return tl::unexpected(read.error());
  const auto& head = read->first;
  return KeptWork{line(head, QStringLiteral("project")),
                  QDateTime::fromString(line(head, QStringLiteral("saved")), Qt::ISODateWithMs).toLocalTime(),
                  line(head, QStringLiteral("edit")), line(head, QStringLiteral("slaves")).toInt()};
}

Result<Machine> readMachine(const QString& file) {
  const auto read = parts(file);
  if (!read) return tl::unexpected(read.error());
  return eni::parse_machine(read->second, file.toStdString());
}

}  // namespace syncline::ui
