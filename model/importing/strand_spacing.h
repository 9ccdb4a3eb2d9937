// How densely foreign strands stand.
#pragma once

#include "model/importing/head_strands.h"

#include <vector>

namespace hairpaint::model {

/// How far from its neighbours each strand stands, metres, up to some centimetres. Throws std::bad_alloc. Any thread.
[[nodiscard]] std::vector<float> strandSpacingsM(const std::vector<HeadStrand>& strands);

} // namespace hairpaint::model
