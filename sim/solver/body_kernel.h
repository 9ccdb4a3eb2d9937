// Hair against hair: a grid of how much hair there is and how it moves, splatted from basis hairs and read at their
// nodes (as McAdams and others 2009 and Petrovic and others 2005 treat hair as a continuum).
#pragma once

#include "sim/base/strand_blocks.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace hairpaint::sim {

/// Cells of a box in head space. Whole numbers, so that a sum is the same in any order.
struct BodyGrid
{
    std::array<float, 3> origin{};
    std::array<float, 3> last{};   ///< Positions in cells are kept within 0..last.
    float inverseCell = 1.0F;      ///< 1/m
    std::int32_t row = 0;          ///< Cells from one y to the next.
    std::int32_t slice = 0;        ///< Cells from one z to the next.
    std::int32_t* cells = nullptr; ///< [z][y][x][4]: hair, and hair times velocity / kBodyFastestM.
};

/// Nodes of a group's basis hairs. `positions`, `previous`: [blocks][nodes][3][kLanes], Hd, m.
struct BodyNodes
{
    int nodes = 0;
    const float* positions = nullptr;
    const float* previous = nullptr; ///< Positions less the velocity; `positions` where nothing moves.
    const float* hair = nullptr;     ///< [blocks][kLanes]: what each node of a strand adds to the grid, in its units.
};

struct BodyBounds
{
    std::array<float, 3> least{};
    std::array<float, 3> greatest{};
};

/// What hair around does to a node.
struct BodyGains
{
    float friction = 0.0F; ///< Fraction of the velocity against the hair around that a step takes,
    float contact = 0.0F;  ///< and how much of the velocity into hair that is too dense, 0..1 at the greatest density.
};

inline constexpr int kStepsAGrid = 7;         ///< What hair around does is found anew after so many steps.
inline constexpr float kBodyFastestM = 0.02F; ///< m a step: hair that is faster counts as moving at this speed.
inline constexpr float kBodyLeaveM = 2e-4F;   ///< m a step: so fast hair leaves where it is too dense.
inline constexpr int kFirstBodyNode = 1;      ///< The roots, which do not move, take no part.
inline constexpr int kFirstPushedNode = 2;    ///< The first segment keeps the direction in which it grows.
inline constexpr float kBodyDeadBand = 0.2F;  ///< Fraction of the density at rest by which hair may be denser,
inline constexpr float kBodyRange = 0.35F;    ///< and over which contact with it grows to its greatest.

/// The box of the nodes of blocks begin..end. All of these neither allocate nor throw, and give the same bytes with
/// every instruction set.
[[nodiscard]] BodyBounds boundsOfBody(const BodyNodes& nodes, std::size_t begin, std::size_t end);
/// Adds the nodes of blocks begin..end to the grid, trilinearly.
void splatBody(const BodyNodes& nodes, const BodyGrid& grid, std::size_t begin, std::size_t end);
/// What the grid holds at each node of blocks begin..end: out is [blocks][nodes][kLanes], in the grid's units.
void readBody(const BodyNodes& nodes, const BodyGrid& grid, float* out, std::size_t begin, std::size_t end);

struct BodyPush
{
    BodyGains gains;
    const float* perRest = nullptr; ///< [blocks][nodes][kLanes]: 1/density at rest, m2.
    float densityPerUnit = 0.0F;    ///< Length of hair per volume that a unit of the grid stands for, 1/m2.
    const float* still = nullptr;   ///< Row kStill of the first block; each next block's is `stillStride` floats on.
    std::size_t stillStride = 0;
    float* previous = nullptr; ///< As in BodyNodes: friction changes the velocity of strands that are not asleep.
    float* contact = nullptr;  ///< [blocks][nodes][3][kLanes]: the direction out of hair that is too dense, as long as
                               ///< the contact is strong, 0..1. Strands asleep keep theirs.
    std::uint8_t* dense = nullptr; ///< [blocks]: 0 where no node of the block is in contact with hair.
};
/// What hair around does to the nodes of blocks begin..end, from kFirstPushedNode on.
void pushBody(const BodyNodes& nodes, const BodyGrid& grid, const BodyPush& push, std::size_t begin, std::size_t end);

} // namespace hairpaint::sim
