// The strip of quads that stands for a lock of hair.
#pragma once

#include "model/cards/hair_field.h"
#include "model/cards/lock_tree.h"

#include <cstdint>
#include <vector>

namespace hairpaint::model {

/// A cross-section of the strip. Side, normal and tangent (toward the tip) are unit and at right angles: seen from
/// outside with the root up, the side points right.
struct StripNode
{
    glm::vec3 middleWo{0.0F};
    glm::vec3 sideWo{1.0F, 0.0F, 0.0F};
    glm::vec3 normalWo{0.0F, 0.0F, 1.0F};
    float halfWidthM = 0.0F;
    float alongM = 0.0F; ///< Distance from the first node along the strip.
};

struct CardStrip
{
    std::vector<StripNode> nodes;     ///< 2 or more, root first.
    std::vector<std::uint32_t> hairs; ///< Indices into SampledHair: the hairs that are drawn on the strip.
    float openness = 0.0F; ///< Mean openness in HairField, 0..1: how near the strip is to the hair's surface.
    bool flyaway = false;
    [[nodiscard]] float lengthM() const { return nodes.back().alongM; }
    [[nodiscard]] float greatestWidthM() const;
    [[nodiscard]] float areaM2() const;
    [[nodiscard]] int triangles() const { return 2 * (static_cast<int>(nodes.size()) - 1); }
};

/// A point as the strip sees it.
struct StripPoint
{
    float across = 0.0F;  ///< -1 at its left border, 1 at its right.
    float alongM = 0.0F;  ///< Distance from the first node along the strip.
    float heightM = 0.0F; ///< Height over the strip, along its normal.
};

/// Where points of one curve, root first, lie on a strip: each is sought near the one before. One thread.
class StripProjector
{
public:
    explicit StripProjector(const CardStrip& strip) : m_strip(strip) {}
    [[nodiscard]] StripPoint next(const glm::vec3& pointWo);

private:
    const CardStrip& m_strip;
    std::size_t m_segment = 0;
};

/// The strip of a lock. It follows the lock's mean, is as long and as wide as about nine of ten hairs need, faces away
/// from hair and head, and turns along its length no faster than needed.
[[nodiscard]] CardStrip stripOf(const SampledHair& hair, const HairLock& lock, const HairField& field);

} // namespace hairpaint::model
