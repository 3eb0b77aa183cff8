// ~forward_kinetostatics: lengths and load to pose and tensions.
#pragma once

#include "cdpr_kinetostatics/ForwardKinetostatics.h"
#include "ros/parameters.h"

namespace cdpr_kinetostatics {

ForwardKinetostatics::Response serveForward(const NodeParameters& parameters,
                                            const ForwardKinetostatics::Request& request);

}  // namespace cdpr_kinetostatics
