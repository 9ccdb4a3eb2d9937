// A stroke of the comb that holds hair as it lies: the direction map and the gel map in one step.
#pragma once

#include "model/tools/brush_path.h"
#include "model/tools/live_edit.h"
#include "model/tools/lying/lying_hair.h"
#include "model/tools/root_dabs.h"

#include <optional>

namespace hairpaint::model {

/// Holds hair as it lay when the stroke began, since its changes move the hair. One stroke at a time.
class HoldStroke
{
public:
    /// False where there is no hair, or no layer that can be painted on.
    [[nodiscard]] bool begin(const ToolContext& context, const QString& step);
    void moveTo(const ToolEvent& event, const ToolContext& context);
    void cancel();
    void commit();
    [[nodiscard]] bool active() const { return m_edit.active(); }

private:
    void dab(const BrushSample& sample, const ToolContext& context);
    /// Covers what `dab`, of the direction map's texels, covers.
    void cover(const Dab& dab);
    void show(const ToolContext& context);
    void drop();

    LiveEdit m_edit;                  ///< Edits the direction layer, then the gel layer.
    std::optional<std::size_t> m_gel; ///< Index of the gel layer in m_edit; none where it can't be painted on.
    std::optional<LyingField> m_field;
    std::shared_ptr<const sim::TiledRaster> m_shownGel;
    std::optional<StrokeBuffer> m_masks, m_gelMasks;
    std::optional<BrushPath> m_path;
    std::optional<RootDabs> m_roots; ///< Dabs where the stroke goes over strands.
};

} // namespace hairpaint::model
