// SPDX-License-Identifier: Apache-2.0
#pragma once

class QWidget;

namespace syncline::ui {

class Card;
class Page;
class PresetEdit;

/// The network's cycle time with the usual ones to choose from, "masterCycle", in a row of the card; `beside` stands
/// behind it.
PresetEdit* addCycleField(Page& page, Card& card, QWidget* beside = nullptr);

}  // namespace syncline::ui
