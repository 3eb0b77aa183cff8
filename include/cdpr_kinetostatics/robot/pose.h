// The pose belongs to geometry/, which robots are built on. Programs that include it by this name go on working.
#pragma once

#include "cdpr_kinetostatics/geometry/pose.h"
