// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <QVariant>
#include <memory>

class QSettings;

namespace syncline::ui {

/// What the window remembers from one start to the next. Without a file it remembers nothing beyond its end.
class WindowMemory final : public QObject {
  Q_OBJECT

 public:
  struct Recent {
    QString path;
    bool pinned = false;
    bool operator==(const Recent&) const = default;
  };

  explicit WindowMemory(const QString& file, QObject* parent = nullptr);
  ~WindowMemory() override;

  /// Pinned ones first, then the latest first.
  [[nodiscard]] const QList<Recent>& recent() const { return recent_; }
  void remember(const QString& path);
  void forget(const QString& path);
  void pin(const QString& path, bool pinned);
  void clearUnpinned();

  [[nodiscard]] QVariant value(const QString& name) const;
  void setValue(const QString& name, const QVariant& value);

 Q_SIGNALS:
  void recentChanged();

 private:
  void store();

  std::unique_ptr<QSettings> settings_;  // none: nothing stays
  QVariantHash held_;                    // without them
  QList<Recent> recent_;
};

}  // namespace syncline::ui
