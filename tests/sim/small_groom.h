// A flat square of skin and a group on it, small enough to look at every hair.
#pragma once

#include "sim/groom/groom.h"
#include "tests/support/test_grooms.h"
#include "tests/support/test_heads.h"

#include <memory>

namespace hairpaint::test {

/// 0.04 m2, with about 20,000 candidates of `smallGroup`.
inline std::shared_ptr<const sim::Skin> patch()
{
    return std::make_shared<const sim::Skin>(makePatchHead(16, 0.2F));
}

inline sim::GroomInput::Group smallGroup()
{
    sim::GroomInput::Group group = uniformGroup();
    group.settings.greatestDensityPerM2 = 5e5F;
    group.settings.basisHairs = 256;
    return group;
}

inline std::shared_ptr<const sim::Groom> groomOf(const sim::GroomInput& input)
{
    return sim::GroomBuilder().update(input).grooms.front();
}

} // namespace hairpaint::test
