// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include "support/result.h"

namespace syncline {
struct Machine;
}  // namespace syncline

namespace syncline::ui {

/// Projects that the user keeps to begin others with: a project file each in a folder of the user's data.
class TemplateStore final : public QObject {
  Q_OBJECT

 public:
  struct Entry {
    QString name, path;
    bool operator==(const Entry&) const = default;
  };
  static constexpr int kLongestName = 60;

  /// `folder`: made when the first one is saved; "": none are kept.
  explicit TemplateStore(QString folder, QObject* parent = nullptr);

  [[nodiscard]] bool isKept() const { return !folder_.isEmpty(); }
  /// As they lie in the folder now, by name; whether they can be read shows when they are.
  [[nodiscard]] QList<Entry> entries() const;
  [[nodiscard]] bool has(const QString& name) const;
  /// Replaces the one of this name; kFileNotWritable.
  [[nodiscard]] Status save(const QString& name, const Machine& machine);
  /// kFileNotWritable where it stays.
  [[nodiscard]] Status remove(const Entry& entry);

 Q_SIGNALS:
  void changed();

 private:
  [[nodiscard]] QString fileOf(const QString& name) const;

  QString folder_;
};

}  // namespace syncline::ui
