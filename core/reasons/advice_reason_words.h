// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// Reasons why a device or the bus does not take a cycle; see reason_words.h.
namespace syncline::words {

inline constexpr std::string_view kAdviceReasons[] = {
    "{limit} is the shortest cycle that {family} {devices} take",
    "{limit} is the longest cycle that {family} {devices} take",
    "{family} {devices} take multiples of {step}",
    "{family} {devices} need multiples of {step}; {otherwise}",
    "{limit} is the shortest cycle that its object 0x1C32:05 names",
    "its operation mode {mode} has a SYNC0 every {cycle}, which is neither a multiple nor a part of it",
    "its operation mode {mode} divides the cycle by {divisor}, which leaves a rest",
    "its object 0x60C2 (interpolation time) cannot express it",
    "the bus cycle is {shortest} to {longest}",
    "the cyclic frames take {time} of wire time",
    "the cyclic frames take {time} of wire time and about {travel} through the slaves",
};

}  // namespace syncline::words
