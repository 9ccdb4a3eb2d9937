// Which texels of a map lie on the skin.
#pragma once

#include "model/tools/painting/texel_mask.h"
#include "sim/skin/skin.h"

#include <memory>

namespace hairpaint::model {

/// Those of a map of `size` whose centre lies in a face's uv. A mesh of many faces costs one pass over their texels;
/// where they would lie more than some 16 times over the whole map, every texel counts as skin instead.
[[nodiscard]] TexelMask uvCover(const sim::HeadMesh& mesh, int size);

/// The last answer, for as long as it is asked about the same skin and size.
class UvCover
{
public:
    [[nodiscard]] const TexelMask& of(const std::shared_ptr<const sim::Skin>& skin, int size);

private:
    std::weak_ptr<const sim::Skin> m_skin;
    std::unique_ptr<const TexelMask> m_cover;
};

} // namespace hairpaint::model
