// A map as the colours that show it, in the form of a colour map.
#pragma once

#include "model/map_spec.h"

#include <memory>

namespace hairpaint::model {

/// Three channels, sRGB as encoded: a scalar's place on its scale from white, an index's palette colour, a colour
/// itself. `resolved`: of Document::resolved. Uniform tiles stay uniform.
[[nodiscard]] std::shared_ptr<const sim::TiledRaster> colouredMap(const sim::TiledRaster& resolved,
                                                                  const MapSpec& spec);

/// The same of a map that changes: tiles that stayed keep their coloured ones, so that a change costs what it touched.
class MapColours
{
public:
    [[nodiscard]] std::shared_ptr<const sim::TiledRaster> of(std::shared_ptr<const sim::TiledRaster> resolved,
                                                             const MapSpec& spec);

private:
    std::shared_ptr<const sim::TiledRaster> m_resolved; ///< What m_coloured shows.
    std::shared_ptr<const sim::TiledRaster> m_coloured;
    const MapSpec* m_spec = nullptr;
};

} // namespace hairpaint::model
