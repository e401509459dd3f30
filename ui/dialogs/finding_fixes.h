// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QMenu;

namespace syncline {
struct Finding;
}  // namespace syncline

namespace syncline::ui {

struct Message;

class Workspace;

/// What the menu of a finding about the project offers: to go to its field, and values with which it is gone, each one
/// undo step. The values are tried when the menu is wanted.
class FindingFixes final : public QObject {
  Q_OBJECT

 public:
  /// `commit`: hands in what is being typed; false: a field holds what cannot be a value.
  FindingFixes(Workspace& workspace, std::function<bool()> commit, QObject* parent);
  void fill(QMenu& menu, const Message& message);
  /// The same of a finding, which may also be about what runs.
  void fillFor(QMenu& menu, const Finding& finding);
  /// Asks for the place that a finding leads to: its setting, or its slave.
  void go(const Finding& finding);

 Q_SIGNALS:
  void placeWanted(int slave, const QString& key);

 private:
  [[nodiscard]] Message lineFor(const Finding& finding) const;
  void addWay(QMenu& menu, const Message& message);
  /// False: there is none.
  bool addFixes(QMenu& menu, const Message& message);

  Workspace& workspace_;
  std::function<bool()> commit_;
};

}  // namespace syncline::ui
