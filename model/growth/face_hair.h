// Eyebrows, eyelashes, beards and whole heads of hair as groups.
#pragma once

#include "model/project/project.h"
#include "model/styles/hair_kinds.h"
#include "model/values/progress.h"

#include <optional>
#include <vector>

namespace hairpaint::model {

/// Groups "Brows" and "Lashes" whose maps are painted where they grow on the head of new projects, and carried from
/// there to another head (style_transfer.h). Their ids are nobody's yet. Empty for a head to which nothing can be
/// carried; none where progress stops it. Any thread; some 100 ms.
[[nodiscard]] std::optional<std::vector<HairGroup>> faceHair(const std::shared_ptr<const Head>& head,
                                                             const Progress& progress = {});

/// A group of hair that grows in a region of its own, such as a beard or the scalp, painted there likewise. Its
/// ids are nobody's yet. None for other kinds, where it is not known on that head, and where progress stops it. Any
/// thread; some 100 ms.
[[nodiscard]] std::optional<HairGroup> grownHair(const HairKind& kind, const std::shared_ptr<const Head>& head,
                                                 const Progress& progress = {});

} // namespace hairpaint::model
