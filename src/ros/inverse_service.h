// ~inverse_kinetostatics: pose and load to lengths and tensions.
#pragma once

#include "cdpr_kinetostatics/InverseKinetostatics.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

InverseKinetostatics::Response serveInverse(const NodeParameters& parameters,
                                            const InverseKinetostatics::Request& request);

}  // namespace cdpr_kinetostatics
