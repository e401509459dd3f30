// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>

class QWidget;

namespace syncline::ui {

class Workspace;

/// Asks before a running machine is taken offline; true when it may, or when nothing runs. Takes nothing offline.
/// `why`: what needs it, a sentence.
[[nodiscard]] bool mayGoOffline(QWidget& window, Workspace& workspace, const QString& why);
/// The same, for what ends the runs of all networks.
[[nodiscard]] bool mayEndAll(QWidget& window, Workspace& workspace, const QString& why);

/// A master was left behind that did not end: what that means for the slaves.
void tellGivenUp(QWidget& window);

/// Asks where a slave is being written to, which ends unfinished when the bus goes offline; true at once otherwise.
[[nodiscard]] bool mayStopWriting(QWidget& window, Workspace& workspace);

/// A question with one way on and a way back, which is the default. True: on.
[[nodiscard]] bool ask(QWidget& window, const char* object_name, const QString& text, const QString& more,
                       const QString& on);

}  // namespace syncline::ui
