// The mesh of a cable that is many layers long and bends too sharply somewhere for a quiet middle: the two ends and the
// bend are shot, the legs between them are quiet (docs/theory.md section 3, "The quiet middle").
#pragma once

#include <vector>

#include "cable/shooting_mesh.h"

namespace cdpr_kinetostatics {

// Appends the intervals of such a mesh, and returns the number of terms that the series takes on its quiet legs, whose
// angles may be wrong by error [rad]. 0: there is no such mesh, and nothing was appended.
int placeAroundBend(const ShotCable& cable, double error, std::vector<MeshInterval>* intervals);

// The number of terms under other forces; 0 if the mesh no longer fits them.
int bendOrder(const std::vector<MeshInterval>& intervals, const ShotCable& cable, double error);

}  // namespace cdpr_kinetostatics
