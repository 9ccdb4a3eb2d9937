// Finds the landmarks of a head that brings none.
#pragma once

#include "sim/skin/head_landmarks.h"
#include "sim/skin/skin.h"

#include <functional>
#include <optional>

namespace hairpaint::sim {

/// Lays a known head over an unknown one and takes over its landmarks: iterated closest points, first by a turn around
/// y, a scale and a shift, then by an affine map and one of second order, from several sizes and quarter turns, of
/// which the one that lies closest wins. The unknown head stands upright; it may be a head, a bust or a whole body, and
/// face anywhere, but where two turns fit about equally well it faces +z. Hd, m. Some 0.2 s; any thread. `goesOn` is
/// told how far it is (0..1); none where it returns false, for a skin without a surface, and where nothing fits.
/// Source: Besl and McKay, A Method for Registration of 3-D Shapes (1992); Chetverikov et al., The Trimmed Iterative
/// Closest Point Algorithm (2002).
[[nodiscard]] std::optional<HeadLandmarks> findLandmarks(const Skin& unknown, const Skin& known,
                                                         const HeadLandmarks& knownLandmarks,
                                                         const std::function<bool(double)>& goesOn = {});

} // namespace hairpaint::sim
