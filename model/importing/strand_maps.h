// The maps that strands on a head were grown from, as far as they can be told from them.
#pragma once

#include "model/importing/head_strands.h"
#include "model/importing/skin_texels.h"
#include "model/project/project.h"

#include <optional>

namespace hairpaint::model {

/// A group of that name with maps of density, length, direction and, where the strands have any, curl, curl size,
/// colour and tip colour, and with settings that reach as far as they do. There must be strands. Its ids are nobody's
/// yet. None where `progress` cancels. Strands weigh on the texels around them by how far apart they stand, so that
/// between them is no hole, and density adds up to their number; beyond the last ones values go on outward.
[[nodiscard]] std::optional<HairGroup> groupFromStrands(const HeadStrands& onHead, bool hasColours,
                                                        const SkinTexels& texels, const QString& name,
                                                        const std::shared_ptr<const Head>& head,
                                                        const Progress& progress = {});

} // namespace hairpaint::model
