// Cornrows repeated between two that are painted.
#pragma once

#include "model/tools/live_edit.h"
#include "model/tools/tool.h"
#include "sim/groom/braid_row.h"

#include <array>
#include <optional>
#include <vector>

namespace hairpaint::model {

inline constexpr int kMostRowsBetween = 12;

/// A point in the middle of a row.
struct RowKnot
{
    glm::vec3 positionHd{0.0F}; ///< On the skin.
    float widthM = 0.0F;        ///< Of the strip there.
};
using RowLine = std::vector<RowKnot>;

/// `count` (1 or more) lines that divide the skin between two rows into parts of one width: points at the same fraction
/// of both rows are joined over the skin, and each line has a point of every joint. Of two ends of `b` the one that
/// lies nearer answers to the begin of `a`. As wide as the rows, or as the room between them lets them be.
[[nodiscard]] std::vector<RowLine> linesBetween(const sim::Skin& skin, const sim::BraidRow& a, const sim::BraidRow& b,
                                                int count);

/// A running edit that paints rows between two of a group's cornrows, on the target's layer of the braid map: the two
/// that reach into the selection, else the two that were painted last. Each gets a number of its own. Where strokes are
/// mirrored it paints the other side too, unless the two rows lie on both sides. Nothing is painted over rows that are
/// there. GUI thread.
class RowRepeat
{
public:
    RowRepeat(const ToolContext& context, const QString& text); ///< `text`: what the undo step will be called.

    /// Why there is nothing to repeat: a sentence; empty where there is.
    [[nodiscard]] const QString& problem() const { return m_problem; }
    /// 1 to kMostRowsBetween: as many as lie side by side with partings between them.
    [[nodiscard]] int fittingCount() const;

    /// Shows as many rows instead of those that it showed before.
    void show(int count);
    void commit() { m_edit.commit(); }
    void cancel() { m_edit.cancel(); }

private:
    struct Found;
    [[nodiscard]] std::optional<std::array<Found, 2>> chosen(const std::vector<Found>& rows);
    void paint(const RowLine& line, std::uint16_t number, StrokeBuffer& buffer) const;

    std::shared_ptr<const Head> m_head;
    sim::MapRaster m_map; ///< The braid map before.
    bool m_mirror = false;
    std::array<sim::BraidRow, 2> m_rows;
    std::vector<std::uint16_t> m_numbers; ///< Of new rows.
    LiveEdit m_edit;
    QString m_problem;
};

} // namespace hairpaint::model
