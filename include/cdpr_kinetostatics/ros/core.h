// The core's API as the ROS layer sees it.
//
// The message SolveReport lives in the same namespace as the core's report of the same name.
#pragma once

#define SolveReport CoreSolveReport
#include "cdpr_kinetostatics/robot/forward.h"
#include "cdpr_kinetostatics/robot/inverse.h"
#undef SolveReport
