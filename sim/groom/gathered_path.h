// The rest shape of gathered hair: taut over the skin to its tie's ring, through it, and on as the tie's form says.
#pragma once

#include "sim/groom/group_settings.h"
#include "sim/groom/taut_strings.h"
#include "sim/groom/tie.h"

#include <array>
#include <span>
#include <vector>

namespace hairpaint::sim {

/// The node in the ring: those before it lie on the skin, those after it are the tail. The same for all hairs of a
/// group.
[[nodiscard]] int ringNode(int nodes);

/// Lays the hair of one tie. Immutable; any thread. Must not outlive the strings.
///
/// A hair goes through the ring at the side from which it comes, and the further out the longer its course: so that
/// hair from near the ring lies below hair from far away, on the skin and in the ring, and none crosses another.
class GatheredLay
{
public:
    GatheredLay() = default;
    /// `coatM`: how high hair lies that is not taut at all.
    GatheredLay(const Tie& tie, const TautStrings& strings, float coatM);

    /// A hair's course from its root to the ring.
    struct Course
    {
        TautString string;
        std::array<float, kStringPoints - 1> spansM{}; ///< Distances from each of its points to the next.
        float tautM = 0.0F;                            ///< Its length.
        float layer = 0.0F;                            ///< 0..1: height among the hair that goes with it.
        glm::vec2 inRing{0.0F};                        ///< Where it goes through the ring, from its middle, m.
        bool isCore = false;                           ///< It goes through the middle of the ring: `inRing` is 0.
    };
    /// `chance`: 0..1, the hair's own. `isCore`: it goes through the middle of the ring.
    [[nodiscard]] Course courseOf(std::uint32_t face, glm::vec3 rootHd, float chance, bool isCore = false) const;

    /// Fills the nodes from the root to the ring, evenly, of a hair of `lengthM` that reaches it. Returns the length of
    /// the curve through them, m.
    float layTaut(const Course& course, float lengthM, std::span<glm::vec3> nodesHd) const;
    /// Fills the nodes behind the ring, evenly along `freeM`: an arc, as hair falls while the head is upright. The
    /// curve is `freeM` long; returns the length of the line through its nodes, which is what the solver keeps.
    float layTail(const Course& course, float freeM, std::span<glm::vec3> nodesHd) const;
    /// Fills the nodes of a hair that ends before the ring, evenly along the first `lengthM` of its course.
    void layToward(const Course& course, float lengthM, std::span<glm::vec3> nodesHd) const;
    /// Fills the nodes from the ring on, up to `heightM` along its axis as a coil rises (coilGirth() in
    /// curve_formula.inl).
    void layCoil(float heightM, std::span<glm::vec3> fromRingHd) const;

private:
    struct TailPoint
    {
        glm::vec3 middleHd;
        glm::vec3 uHd, vHd; ///< Unit: the ring's axes, carried along without turning about the tail.
    };
    void makeTail();
    /// Moves nodes out until the curve through them, up to the ring, is out of the skin between them, too.
    void liftSpans(std::span<glm::vec3> nodesHd) const;
    [[nodiscard]] glm::vec3 onTail(glm::vec2 inRing, float alongM) const;
    [[nodiscard]] float heightM(const Course& course, float toRingM) const;
    [[nodiscard]] glm::vec3 onCourse(const Course& course, float fromRootM) const;

    const TautStrings* m_strings = nullptr;
    Tie m_tie;
    float m_coatM = 0.0F;
    glm::vec3 m_uHd{1.0F, 0.0F, 0.0F};
    glm::vec3 m_vHd{0.0F, 1.0F, 0.0F};
    std::vector<TailPoint> m_tail; ///< kTailStepM apart.
};

} // namespace hairpaint::sim
