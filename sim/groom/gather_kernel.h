// kLanes hairs of one tie laid at once: taut over the skin to its ring, and from there on as a tail.
#pragma once

#include "sim/base/strand_blocks.h"
#include "sim/groom/skin_distance.h"
#include "sim/groom/taut_string.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::sim {

/// A point of a tail's middle.
struct TailPoint
{
    glm::vec3 middleHd;
    glm::vec3 uHd, vHd; ///< Unit: the ring's axes, carried along without turning about the tail.
};

inline constexpr std::size_t kTailPoints = 96;
inline constexpr float kTailStepM = 0.01F; ///< From a point of a tail to the next.

/// A tail is wider than the ring by a factor of 1 + kTailOpens x / (x + kTailHalfOpenM), x m behind it.
inline constexpr float kTailOpens = 1.3F;
inline constexpr float kTailHalfOpenM = 0.07F;

/// kLanes hairs. Lanes of none may hold anything but strings: those must be some of the tie's.
struct GatherLanes
{
    using Row = std::array<float, kLanes>;
    std::array<Row, 3> rootHd{};
    /// Those of the vertices of its face: indices of their first numbers among the tie's strings.
    std::array<std::array<std::int32_t, kLanes>, 3> strings{};
    Row chance{};     ///< 0..1, the hair's own.
    Row isCore{};     ///< 1: it goes through the middle of the ring. 0: through its own point there.
    Row cutM{};       ///< Its length.
    Row seen{};       ///< Length behind the ring over what is left there of `cutM`.
    Row givenFreeM{}; ///< Length along which it is laid behind the ring; 0: its own, `freeM`.
    // What the kernel finds.
    Row tautM{}; ///< Length of the curve to the ring; `cutM` where it does not get there.
    Row freeM{}; ///< Length behind the ring; 0 or less: the hair ends before it.
    Row lineM{}; ///< Length of the line through the nodes behind the ring, which is what the solver keeps.
};

/// What all hair of a tie has in common, and where it goes. Hd, m.
struct GatherTask
{
    const SkinDistance* distance = nullptr;
    const TautString* strings = nullptr;
    const TailPoint* tail = nullptr; ///< [kTailPoints], kTailStepM apart.
    glm::vec3 centreHd{0.0F};        ///< About the middle of the head.
    glm::vec3 outwardHd{0.0F};       ///< Unit: the skin's normal below the ring,
    glm::vec3 directionHd{0.0F};     ///< and the ring's axis.
    glm::vec3 uHd{0.0F};             ///< Unit: across that,
    glm::vec3 vHd{0.0F};             ///< and across both.
    float radiusM = 0.0F;            ///< Of the ring.
    float coatM = 0.0F;              ///< Height that hair rises to between root and ring, as it is not taut.
    int nodes = 0;
    int ring = 0; ///< See ringNode().
    /// Least length behind the ring. 0: hair that is too short ends before it, evenly along the first of its course.
    float leastFreeM = 0.0F;
    GatherLanes* lanes = nullptr;
    float* nodesHd = nullptr; ///< [nodes][3][kLanes]
};

/// Hair goes through the ring at the side from which it comes, and the further out the longer its course: so that hair
/// from near the ring lies below hair from far away, on the skin and in the ring, and none crosses another. Nodes are
/// even on each side of the ring. Behind it the curve is `freeM` long. Allocates nothing; the same bytes with every
/// instruction set.
void gatherLanes(const GatherTask& task);

} // namespace hairpaint::sim
