// How hair grows where nobody has combed it.
#pragma once

#include "sim/skin/head_landmarks.h"
#include "sim/skin/skin.h"

#include <functional>
#include <optional>
#include <vector>

namespace hairpaint::sim {

/// Angle by which the stream turns about the whorl, at its middle, rad.
inline constexpr float kSwirlRad = 1.1F;

/// Each vertex's direction of growth projected on its tangent plane, as long as the cosine of its angle to the skin.
/// Hair streams away from one whorl, a little behind and to the right of the crown, where it stands upright and turns
/// clockwise: forward over the top, down the sides, the face and the nape; ever flatter. Followed over the surface as
/// heat flows from the whorl, so that no other point of a closed head is singular but where all streams meet again.
/// Without landmarks the whorl is at the highest point. Empty where `goesOn` returns false. Any thread.
[[nodiscard]] std::vector<glm::vec3> naturalStream(const Skin& skin, const std::optional<HeadLandmarks>& landmarks,
                                                   const std::function<bool()>& goesOn = {});

} // namespace hairpaint::sim
