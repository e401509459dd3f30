// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

class Actions;
class RecordingCommands;
class Workspace;

/// Which actions can be had now: what the project, the run, a scan and a shown recording leave possible.
void updateActionStates(const Actions& actions, Workspace& workspace, const RecordingCommands& recordings);

/// Those that depend on how long the machine has been recorded, too. What a shown recording switches off says why.
void updateRecordingStates(const Actions& actions, Workspace& workspace, const RecordingCommands& recordings);

}  // namespace syncline::ui
