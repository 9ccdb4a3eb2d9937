// How densely hair fills the space around a head.
#pragma once

#include "model/cards/sampled_hair.h"

#include <glm/glm.hpp>

#include <vector>

namespace hairpaint::model {

/// A grid over all hair, Wo. Immutable once made; any thread.
class HairField
{
public:
    HairField(const CurveSet& set, const SampledHair& hair);

    /// Away from hair and head, about unit; small where it is as dense on all sides.
    [[nodiscard]] glm::vec3 outward(const glm::vec3& positionWo) const;
    /// How much light from all around comes there, 0..1.
    [[nodiscard]] float openness(const glm::vec3& positionWo) const;

private:
    void deposit(const SampledHair& hair);
    void fillHead(const CurveSet& set);
    void measureOpenness();
    void blurFilled();

    [[nodiscard]] std::size_t indexOf(const glm::ivec3& cell) const
    {
        return (static_cast<std::size_t>(cell.z) * static_cast<std::size_t>(m_size.y) +
                static_cast<std::size_t>(cell.y)) *
                   static_cast<std::size_t>(m_size.x) +
               static_cast<std::size_t>(cell.x);
    }
    [[nodiscard]] float at(const std::vector<float>& values, const glm::vec3& positionWo) const;

    glm::vec3 m_originWo{0.0F}; ///< Middle of the first cell.
    float m_cellM = 0.003F;
    glm::ivec3 m_size{1};
    std::vector<float> m_areaPerM; ///< Hair's area in a cell over its volume, 1/m.
    std::vector<float> m_filled;   ///< 0..1, blurred.
    std::vector<float> m_openness;
};

} // namespace hairpaint::model
