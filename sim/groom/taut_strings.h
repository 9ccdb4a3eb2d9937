// Strings drawn taut over the skin from anywhere on it to one point: the shortest paths there.
#pragma once

#include "sim/groom/skin_distance.h"
#include "sim/groom/taut_string.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// The strings of the skin's vertices, made where they are asked for: see pullLanes().
class TautStrings
{
public:
    TautStrings() = default;
    TautStrings(SkinDistance distance, glm::vec3 endHd);

    [[nodiscard]] glm::vec3 endHd() const { return m_endHd; }
    [[nodiscard]] glm::vec3 outwardHd() const { return m_outwardHd; } ///< Unit: the skin's normal below the end.
    [[nodiscard]] glm::vec3 centreHd() const { return m_centreHd; }   ///< About the middle of the head.
    [[nodiscard]] const SkinDistance& distance() const { return m_distance; }

    /// Makes the strings of these faces' vertices. Uses parallelFor.
    void prepare(std::span<const std::uint32_t> faces);
    /// Those prepared so far.
    [[nodiscard]] const std::vector<TautString>& strings() const { return m_strings; }
    /// Indices of the strings of a face's vertices; the face was prepared. Any thread.
    [[nodiscard]] std::array<std::uint32_t, 3> ofFace(std::uint32_t face) const;

private:
    /// At most kLanes.
    void pull(std::span<TautString> strings, std::span<const std::uint32_t> vertices) const;

    SkinDistance m_distance;
    glm::vec3 m_endHd{0.0F};
    glm::vec3 m_outwardHd{0.0F, 1.0F, 0.0F};
    glm::vec3 m_centreHd{0.0F};
    std::vector<std::uint32_t> m_stringOf; ///< [vertices], kNone where there is none yet.
    std::vector<TautString> m_strings;
};

} // namespace hairpaint::sim
