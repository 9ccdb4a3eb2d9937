// Cuts of all hair of a group at once: trimmed all round, to a level, in layers.
#pragma once

#include "model/tools/cutting/cut_lengths.h"
#include "model/tools/cutting/cut_tips.h"
#include "model/tools/cutting/strand_lengths.h"
#include "model/tools/live_edit.h"
#include "sim/motion/strand_frame.h"

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace hairpaint::model {

/// How long hair may be between two points of the head; what is shorter stays as it is.
struct GradedLengths
{
    glm::vec3 topHd{0.0F};
    glm::vec3 bottomHd{0.0F};
    float topM = 0.1F;    ///< Greatest length at the top, m.
    float bottomM = 0.3F; ///< Greatest length at the bottom, m.
    /// Whether it is a fade: length changes with height, each millimetre by about the same factor, as clipper guards
    /// follow each other. Else layers: length changes evenly with the distance from the top.
    bool fades = false;
    /// Fractions of the way from top to bottom, 0..1, between which the length changes.
    float from = 0.0F, to = 1.0F;

    [[nodiscard]] float lengthM(glm::vec3 rootHd) const;
};

/// A running cut of a group's drawn hair: each call replaces what the one before showed. It cuts the hair as it lay
/// when this was made, inside the selection, on the target's length layer; tip colours that are cut off are gone. GUI
/// thread.
class GroupCut
{
public:
    /// `text`: what the undo step will be called. `frame` holds hair of the group, every hair positioned.
    GroupCut(ToolContext& context, std::shared_ptr<const sim::StrandFrame> frame, const QString& text);

    /// False where the layer is missing, hidden or locked, or where there is no hair.
    [[nodiscard]] bool active() const { return m_edit.active(); }
    [[nodiscard]] float longestM() const; ///< The longest hair by the map, m.
    [[nodiscard]] float lowestHd();       ///< The height to which drawn hair hangs.
    /// The lowest and the highest root, Hd.
    [[nodiscard]] std::pair<glm::vec3, glm::vec3> lowestAndHighestRoot() const;

    /// Shortens every hair by `byM`, but none to less than `leastM`.
    void trim(float byM, float leastM);
    /// Cuts every hair where it first goes below `heightHd`, curls included.
    void toLevel(float heightHd);
    void grade(const GradedLengths& lengths);

    void commit() { m_edit.commit(); }
    void cancel() { m_edit.cancel(); }

private:
    /// `keptOf(slot, lengthM)`: the fraction of that length that stays; 1 or more: all of it. For a baby hair,
    /// `lengthM` is the map's length.
    void cut(const std::function<float(std::uint32_t slot, float lengthM)>& keptOf);
    [[nodiscard]] const sim::Groom& groom() const { return *m_hair->groom; }
    void measureHeights();
    /// `visit(slot, points)` for each drawn hair, points in head space. Several threads.
    void forEachCurve(const std::function<bool(std::uint32_t)>& wanted,
                      const std::function<void(std::uint32_t, std::span<const glm::vec3>)>& visit) const;

    std::shared_ptr<const sim::StrandFrame> m_frame;
    const sim::GroupFrame* m_hair = nullptr; ///< The group's hair in m_frame; null where there is none.
    LiveEdit m_edit;
    std::optional<CutLengths> m_lengths;
    std::optional<CutTips> m_tips;
    std::optional<StrandLengths> m_before;
    std::vector<float> m_lowestHd; ///< By slot: the lowest height of the hair; empty until measureHeights() has run.
};

} // namespace hairpaint::model
