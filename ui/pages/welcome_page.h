// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

#include "ui/session/template_store.h"

class QAction;
class QLabel;

namespace syncline::ui {

class WindowMemory;

/// Stands in the centre while the project has no slaves: the ways to begin, the projects that were open lately, and the
/// user's templates.
class WelcomePage final : public QWidget {
  Q_OBJECT

 public:
  WelcomePage(const QList<QAction*>& beginnings, WindowMemory& memory, TemplateStore& templates,
              QWidget* parent = nullptr);

 Q_SIGNALS:
  void fileWanted(const QString& path);
  void templateWanted(const TemplateStore::Entry& entry);
  void templateRemoveWanted(const TemplateStore::Entry& entry);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void drawMark();
  void showRecent();
  void showTemplates();
  QWidget* makeTemplate(int row, const TemplateStore::Entry& entry);
  QWidget* makeRecent(int row, const QString& path, bool pinned);

  WindowMemory& memory_;
  TemplateStore& templates_;
  QWidget *recent_ = nullptr, *own_ = nullptr;
  QLabel* mark_;
};

}  // namespace syncline::ui
