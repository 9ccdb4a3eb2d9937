// What holds of curves, whatever file they were read from.
#pragma once

#include "model/importing/curve_reader.h"
#include "model/importing/foreign_curves.h"
#include "model/importing/strand_shape.h"
#include "tests/fuzz/fuzz_input.h"

#include <cmath>

namespace hairpaint::fuzz {

/// What is left once broken strands are out: every strand has its points, and can be measured.
inline void requireWhole(model::ForeignCurves curves)
{
    model::leaveOutBroken(curves);
    model::StrandScratch scratch;
    for (const model::ForeignStrands& strands : curves.groups) {
        require(strands.looks.size() == strands.count());
        require(strands.count() == 0 ? strands.points.empty() : strands.ends.back() == strands.points.size());
        for (std::size_t i = 0; i < strands.count(); ++i) {
            require(strands.strand(i).size() >= 2);
            const model::StrandShape shape = model::measureStrand(strands.strand(i), scratch);
            require(!(shape.lengthM < 0.0F) && scratch.axisHd.size() >= 2);
        }
    }
}

} // namespace hairpaint::fuzz
