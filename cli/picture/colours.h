// Colours that colour-blind readers tell apart: Okabe and Ito, Color Universal Design (2008).
#pragma once

#include <patchgrip/cli/picture/svg.h>

namespace patchgrip::cli {

inline constexpr Colour black{0, 0, 0};
inline constexpr Colour white{1, 1, 1};
inline constexpr Colour vermilion{0.835, 0.369, 0};
inline constexpr Colour orange{0.902, 0.624, 0};
inline constexpr Colour blue{0, 0.447, 0.698};
inline constexpr Colour green{0, 0.62, 0.451};

}  // namespace patchgrip::cli
