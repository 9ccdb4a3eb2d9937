// Hair of another program over a ball, as the import dialog shows it.
#pragma once

#include "sim/base/rounded.h"
#include "tests/support/test_heads.h"
#include "view/dialogs/hair_import_dialog.h"

#include <memory>

namespace hairpaint::test {

/// Twelve straight strands of 2.5 cm over the upper half of a ball of 10 cm radius, in centimetres, the face toward
/// -y; the file tells that z is up, not the unit.
inline model::ForeignCurves strandsInCentimetres()
{
    model::ForeignCurves curves;
    curves.upAxis = model::UpAxis::Z;
    model::ForeignStrands& strands = curves.groups.emplace_back();
    for (int i = 0; i < 12; ++i) {
        const float turn = static_cast<float>(i) * 2.4F;
        const float height = 0.3F + 0.05F * static_cast<float>(i);
        const float across = std::sqrt(1.0F - height * height);
        const glm::vec3 outward(across * sim::cosRounded(turn), across * sim::sinRounded(turn), height);
        for (const float radius : {10.0F, 11.2F, 12.5F})
            strands.points.push_back(outward * radius);
        strands.ends.push_back(static_cast<std::uint32_t>(strands.points.size()));
        strands.looks.emplace_back();
    }
    return curves;
}

inline view::HairImportSample importSample()
{
    auto head = std::make_shared<model::Head>();
    head->skin = std::make_shared<const sim::Skin>(makeBallHead());
    return view::HairImportSample::of(strandsInCentimetres(), head);
}

} // namespace hairpaint::test
