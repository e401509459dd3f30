// SPDX-License-Identifier: Apache-2.0
#include "app/cli/recorded_event.h"

#include <string>
#include <utility>

#include "app/cli/event_name.h"
#include "app/cli/event_text.h"
#include "record/recording.h"
#include "record/typed_values.h"

namespace syncline::cli {

std::optional<RecordedEvent> recorded_event(const Event& event) {
  auto words = event_words(event);
  if (words.empty()) return std::nullopt;
  return RecordedEvent{event.time, event.slave, std::string(event_name(event)), std::move(words),
                       encode_event(event.what)};
}

}  // namespace syncline::cli
