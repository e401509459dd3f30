// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace syncline::ui {

class Card;
class Page;
class PresetEdit;

/// The network's cycle time with the usual ones to choose from, "masterCycle", in a row of the card.
PresetEdit* addCycleField(Page& page, Card& card);

}  // namespace syncline::ui
