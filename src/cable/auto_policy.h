// How AUTO chooses among models: every number of its policy, for a cable, a robot and the estimator (docs/models.md).
#pragma once

#include <array>

#include "cdpr_kinetostatics/cable/model.h"

namespace cdpr_kinetostatics {

// The models that AUTO chooses from, coarsest first. Those without stretch cost as much as those with it.
inline constexpr int kAutoRungCount = 4;
inline constexpr std::array<Model, kAutoRungCount> kAutoRungs = {Model::kStraightElastic, Model::kCatenary,
                                                                 Model::kCatenaryCorrected, Model::kBending};

// Before it solves, AUTO lets a model's estimated error take this share of the accuracy asked for: estimates are to
// leading order.
inline constexpr double kAutoShare = 0.5;

// At a robot's solution this share is enough: the estimate there is a little other than the one before it, and need not
// send the solver back. Sag is no small effect for a nearly slack line, whose estimate is the rougher.
inline constexpr double kEnough = 0.75;
inline constexpr double kEnoughOnLines = 0.4;

// The effects of a robot's cables on its platform are added with their signs; this share of each one's size is added
// on top, as it may be wrong by that much. A line's is known worse.
inline constexpr double kUncertain = 0.2;
inline constexpr double kUncertainLine = 0.5;

// While a robot is followed, a cable goes to a coarser model only where this share of the error that it may take is
// enough: else models would change back and forth.
inline constexpr double kKeptShare = 0.5;

// A follower goes on for so many poses with models finer than necessary before it starts anew: a cold start, which is
// dear, may end on the same again.
inline constexpr int kNeedlesslyFine = 50;

// The estimator: an error of a model below this many standard deviations of what is measured does not show; that of a
// model coarser than the one in use must be below this share of it, for the same reason as with a follower.
inline constexpr double kInvisible = 0.1;
inline constexpr double kCoarserShare = 0.5;

}  // namespace cdpr_kinetostatics
