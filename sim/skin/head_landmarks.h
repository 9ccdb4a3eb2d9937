// Points that every head has, by which two heads are aligned.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace hairpaint::sim {

enum class HeadLandmark : std::uint8_t
{
    Crown,
    Hairline, ///< Its middle over the forehead.
    Nape,     ///< The hairline's middle at the back.
    EarLeft,  ///< Middle of the ear's opening; left is the head's own left, +x.
    EarRight,
    NoseTip,
    Chin
};

inline constexpr std::size_t kHeadLandmarkCount = 7;

/// On the skin. Hd, m.
struct HeadLandmarks
{
    std::array<glm::vec3, kHeadLandmarkCount> positionsHd{};

    [[nodiscard]] glm::vec3& operator[](HeadLandmark landmark)
    {
        return positionsHd[static_cast<std::size_t>(landmark)];
    }
    [[nodiscard]] const glm::vec3& operator[](HeadLandmark landmark) const
    {
        return positionsHd[static_cast<std::size_t>(landmark)];
    }
    friend bool operator==(const HeadLandmarks&, const HeadLandmarks&) = default;
};

} // namespace hairpaint::sim
