// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QScrollArea>
#include <QString>
#include <optional>
#include <vector>

#include "support/result.h"

namespace syncline {
struct Project;
struct Snapshot;
}  // namespace syncline

namespace syncline::settings {
struct Place;
struct Setting;
}  // namespace syncline::settings

namespace syncline::ui {

struct SettingEdit;

class FieldBinder;
class Workspace;

/// What a page is for: to say what shall be, to see what is, or both.
enum class PagePurpose { kConfiguration, kDiagnosis, kBoth };

/// A tab of the device editor for one node. A page shows the project and the live values and asks for
/// edits; it keeps no state of its own but what is being typed.
class Page : public QScrollArea {
  Q_OBJECT

 public:
  Page(Workspace& workspace, const char* object_name, const QString& title);

  [[nodiscard]] const QString& title() const { return title_; }
  /// Position of the shown slave, -1 for the master.
  void setNode(int slave);
  [[nodiscard]] int node() const { return slave_; }
  /// Whether the node has something to show here.
  [[nodiscard]] virtual bool appliesTo(int slave) const = 0;
  [[nodiscard]] virtual PagePurpose purpose() const { return PagePurpose::kConfiguration; }
  /// Shows the project and the compiled configuration as they are now.
  virtual void refresh() = 0;
  /// Selects what has to be selected for the field of a setting to be there: a record of a list, a PDO.
  virtual void showPlace(const settings::Setting&, const settings::Place&) {}
  /// Shows the live values; only called while visible.
  virtual void showLive(const Snapshot& snapshot) = 0;

  /// The page's fields that edit settings.
  [[nodiscard]] FieldBinder& fields() { return *fields_; }
  [[nodiscard]] const FieldBinder& fields() const { return *fields_; }
  [[nodiscard]] const Project& project() const;
  /// Settings that few machines need are shown.
  [[nodiscard]] bool expert() const;
  /// One undo step; empty, or why it was refused: then the messages say so and the page shows the project again.
  QString set(const QString& text, std::vector<SettingEdit> edits);

 protected:
  void showEvent(QShowEvent* event) override;
  [[nodiscard]] Workspace& workspace() const { return workspace_; }

 private:
  Workspace& workspace_;
  FieldBinder* fields_;
  QString title_;
  int slave_ = -1;
  std::optional<Error> refused_;  // what the last edit was refused for
};

}  // namespace syncline::ui
