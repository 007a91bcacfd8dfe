// Soft pads under a given pressure, turned about a pole until all of their face slides: friction/ says with what.
//
// G = 1 Pa, mean pressure 1 Pa, mu = 0.5, height 0.3 m, the minor radius or half side 1 m; the face is z = 0 and the
// back is held. A rigid plane touches the face and turns by theta about (d, 0), against the bristles that the pad is.
//
// Until all slides, dynamics/return_mapping.h says what bristles in the mean carry that are as stiff as the sheared
// layer, K = (G / h) diag(A, A, I): they stick or slip all at once, the pad from its edge inwards.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <patchgrip/verification/claims/claim.h>

namespace patchgrip::verification {

enum class PadShape { disc, ellipse, rectangle };

struct Pad {
  PadShape shape;
  double half_x, half_y;  // semi-axes or half sides [m]
  double height;          // [m]
  double mu;
  double load;                       // F [N]
  std::string pressure;              // in the language of GetFEM [Pa]
  double pole;                       // (d, 0) [m]
  std::vector<double> turns;         // theta [mu p h / G]
  std::vector<Quantity> quantities;  // force over mu F, moment over mu F: of the last turn, and at all of them
};

Pad pad(PadShape shape, double pole);

}  // namespace patchgrip::verification
