// What a stroke that lays or shapes hair goes along: the skin, or strands where it is over hair.
#pragma once

#include "model/tools/brush_path.h"
#include "model/tools/root_dabs.h"
#include "model/tools/strokes/skin_frames.h"
#include "model/tools/strokes/stroke_heading.h"

#include <memory>
#include <optional>

namespace hairpaint::model {

/// What one tool keeps for its strokes. GUI thread.
struct SkinStroke
{
    std::unique_ptr<SkinFrames> frames; ///< Kept from stroke to stroke.
    std::optional<BrushPath> path;      ///< Spacing of dabs on the skin; only while a stroke lasts.
    std::optional<RootDabs> roots;      ///< Dabs where the stroke goes over strands; only while a stroke lasts.
    StrokeHeading heading;              ///< Direction of the pointer's movement.

    /// The head that a stroke on the direction map may go over; null where none can.
    [[nodiscard]] static const Head* headFor(const ToolContext& context)
    {
        const Head* head = context.document.project().head.get();
        return context.target.map == MapKind::Direction && head != nullptr && head->skin != nullptr ? head : nullptr;
    }

    /// Prepares `frames` for a stroke over that head.
    void look(const Head& head)
    {
        if (frames == nullptr || !frames->isOf(head.skin))
            frames = std::make_unique<SkinFrames>(head.skin);
    }

    /// `size`: side of the layer, texels. Dabs are an eighth of their diameter apart, half a texel at least.
    void begin(const Head& head, const ToolContext& context, int size)
    {
        constexpr float kSpacing = 1.0F / 8.0F;
        constexpr float kLeastStepTx = 0.5F;
        path.emplace(head.skin.get(), context.settings.brushSizeM * kSpacing, kLeastStepTx / static_cast<float>(size));
        roots.emplace(context, size);
        heading.reset();
    }
    void end()
    {
        path.reset();
        roots.reset();
    }
};

} // namespace hairpaint::model
