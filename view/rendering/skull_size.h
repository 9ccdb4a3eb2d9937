// The size of a head as the light on hair takes it, found once a head.
#pragma once

#include "sim/skin/head_mesh.h"

#include <memory>

namespace hairpaint::rendering {

class SkullSize
{
public:
    /// Mean distance of the upper head's skin from its middle, from some of its vertices, m; 0 without any.
    [[nodiscard]] float radiusM(const std::shared_ptr<const sim::HeadMesh>& head);

private:
    std::shared_ptr<const sim::HeadMesh> m_head;
    float m_radiusM = 0.0F;
};

} // namespace hairpaint::rendering
