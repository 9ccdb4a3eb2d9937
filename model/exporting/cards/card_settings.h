// What is wanted of hair cards.
#pragma once

namespace hairpaint::model {

/// Of all cards of an export together.
struct CardSettings
{
    static constexpr int kFewestTriangles = 1'000;
    static constexpr int kMostTriangles = 60'000;
    static constexpr int kSmallestAtlasPx = 1024;
    static constexpr int kLargestAtlasPx = 4096;

    int triangles = 15'000;   ///< At most; hair that asks for fewer gets fewer.
    int atlasPx = 2048;       ///< 1024, 2048 or 4096: a side of the textures.
    bool springBones = false; ///< Joints along the locks, with what avatar programs need to let them swing.
    friend bool operator==(const CardSettings&, const CardSettings&) = default;
};

/// Alpha from which a texel of a card is hair.
inline constexpr float kCardCutoff = 0.4F;

} // namespace hairpaint::model
