// Where the segments of a bending cable begin and end, chosen from its forces and the accuracy asked for
// (docs/theory.md section 3).
//
// A usual long cable is shot at its two ends and has one quiet interval between them, which has a closed form
// (slow_manifold.h), so that the cost does not grow with kappa L. A loop too sharp for that is shot at its bend, too,
// between two quiet legs. All other cables are shot whole, in segments a few bending layers long.
#pragma once

#include <vector>

#include "cable/shooting_accuracy.h"
#include "cable/shot_cable.h"

namespace cdpr_kinetostatics {

// How the cable between its two ends' bending layers is evaluated.
enum class Middle {
  kQuiet,  // in closed form, where the tolerance allows
  kShot,   // by shots
};

struct MeshInterval {
  double begin = 0.0;  // as shares of the cable's length
  double end = 0.0;
  bool quiet = false;  // has a closed form, is not shot
};

class ShootingMesh {
 public:
  void place(const ShotCable& cable, const ShootingAccuracy& accuracy, Middle middle);

  // False if the forces have changed so much that the mesh has to be placed anew. Otherwise the number of terms of the
  // quiet intervals' series follows the forces. A mesh without quiet intervals always fits.
  bool fits(const ShotCable& cable, const ShootingAccuracy& accuracy);

  const std::vector<MeshInterval>& intervals() const { return intervals_; }

  // Terms of the series that the quiet intervals take; 0 if none is quiet.
  int slowOrder() const { return slow_order_; }
  bool hasQuietMiddle() const { return slow_order_ > 0; }

  // A bend that is shot parts the quiet middle from an end, or in two.
  bool hasShotBend() const { return shot_bend_; }

 private:
  bool placeAroundMiddle(const ShotCable& cable, double error);
  void placeEverywhere(const ShotCable& cable, int fewest);
  int orderThatFits(const ShotCable& cable, double error) const;

  std::vector<MeshInterval> intervals_;
  int slow_order_ = 0;
  bool shot_bend_ = false;
};

}  // namespace cdpr_kinetostatics
