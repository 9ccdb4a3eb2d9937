// The settings of hair cards.
#pragma once

namespace hairpaint::model {

/// They apply to all cards of an export together.
struct CardSettings
{
    static constexpr int kFewestTriangles = 1'000;
    static constexpr int kMostTriangles = 60'000;
    static constexpr int kSmallestAtlasPx = 1024;
    static constexpr int kLargestAtlasPx = 4096;
    static constexpr int kMostLevels = 3;

    int triangles = 15'000;   ///< At most; hair that asks for fewer gets fewer.
    int atlasPx = 2048;       ///< 1024, 2048 or 4096: a side of the textures.
    int levels = 1;           ///< Number of levels of detail; each has half the triangles of the one before.
    bool springBones = false; ///< Joints along the locks, with what avatar programs need to let them swing.
    bool withHead = false;    ///< The head's mesh beside the cards, held by the same skeleton.
    friend bool operator==(const CardSettings&, const CardSettings&) = default;
};

/// Alpha from which a texel of a card is hair.
inline constexpr float kCardCutoff = 0.4F;

} // namespace hairpaint::model
