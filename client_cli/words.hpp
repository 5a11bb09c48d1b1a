// What the rules and the match say, in plain English: the one place where any command takes its
// sentences from.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/match/match.hpp"
#include "common/record/record.hpp"
#include "common/rules/ruling.hpp"

namespace breakshot::client {

/// The names of the players, by seat.
using Names = std::vector<std::string>;

Names names_of(const record::Header& header);
/// A seat without a name is "player 1", "player 2", ...
std::string name_of(const Names& names, rules::Seat seat);

// ---- Words

/// "cue ball", "8 ball".
std::string words_of(physics::BallId ball);
/// "foot right corner", "left side". Left and right are those of somebody who looks from the head
/// to the foot of the table.
std::string words_of(physics::PocketId pocket);
std::string words_of(rules::Group group);
std::string words_of(rules::Foul foul);
/// What a player who takes it would say: "accept the table".
std::string words_of(rules::Option option);
std::string words_of(match::GameKind game);

/// The sixteen digits of a match's id.
std::string words_of(match::MatchId id);

/// "3 ball in the foot right corner", "safety", or nothing where nothing is called.
std::string words_of(const rules::Call& call);
/// "0.20 R left of and 0.10 R above the centre", R being the radius; nothing for the centre.
std::string words_of(const physics::Tip& tip);

/// "1, 9 and the cue ball".
std::string balls_in_words(const std::vector<physics::BallId>& balls);

/// One event of a shot: "2 ball and 8 ball collide".
std::string words_of(const physics::Event& event);

// ---- Sentences

/// What a referee says after a shot or a choice of `seat`; several sentences, or none where there
/// is nothing to say.
std::string ruling_text(const rules::Ruling& ruling, rules::Seat seat, const Names& names);

/// What is to happen next: "Ada has stripes and ball in hand.", "Bob wins the match."
std::string status_text(const match::Status& status, const Names& names);

/// "Ada 1 : 0 Bob"; empty where nobody counts racks.
std::string score_text(const match::Status& status, const Names& names);

/// What `entry` did, without what it led to: "Ada shoots at 2.50 m/s and 31.4 degrees, calling the
/// 3 ball in the left side pocket." `before` is the status that it met.
std::string command_text(const match::Author& author, const match::Command& command,
                         const match::Status& before, const Names& names);

/// "8-ball, race to 3, on the club table: Ada against Bob".
std::string match_text(const record::Header& header);

}  // namespace breakshot::client
