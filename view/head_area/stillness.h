// Whether the hair that is shown moves.
#pragma once

#include "sim/motion/strand_frame.h"
#include "view/rendering/scene.h"

#include <QSize>

#include <memory>

namespace hairpaint::view {

/// Compares frames with the one that was shown when it last moved, so that a slow drift is noticed too. GUI thread.
class Stillness
{
public:
    /// Whether the picture of `frame` differs from the one remembered: another groom, another pose, or a node of hair
    /// that lies more than a pixel elsewhere (of a few thousand nodes that stand for all). Remembers `frame` then.
    /// Takes under 0.1 ms.
    [[nodiscard]] bool moved(const std::shared_ptr<const sim::StrandFrame>& frame, const rendering::Camera& camera,
                             QSize areaPx);

private:
    std::shared_ptr<const sim::StrandFrame> m_shown;
};

} // namespace hairpaint::view
