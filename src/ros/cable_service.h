// ~solve_cable: the three problems of one cable.
#pragma once

#include "cdpr_kinetostatics/SolveCable.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

SolveCable::Response serveCable(const NodeParameters& parameters, const SolveCable::Request& request);

}  // namespace cdpr_kinetostatics
