// bust-1: frozen, for the files that name it.
#include "model/heads/built_in_heads.h"
#include "model/heads/bust_marks.h"

#include <QtGlobal>

#include <array>

namespace hairpaint::heads {

namespace {

constexpr std::array<glm::vec3, 6> kBrowline = {{{0.0120F, 0.0225F, 0.0900F},
                                                 {0.0190F, 0.0255F, 0.0885F},
                                                 {0.0270F, 0.0280F, 0.0855F},
                                                 {0.0360F, 0.0290F, 0.0790F},
                                                 {0.0440F, 0.0270F, 0.0710F},
                                                 {0.0510F, 0.0220F, 0.0610F}}};

/// Neck and nape, three for cranium and face, upper back, chest, shoulders.
const std::array<sim::Ellipsoid, 8> kColliders = {{
    {{0.00000F, -0.05539F, -0.02580F}, {0.05054F, 0.16534F, 0.05051F}, {0.99878F, -0.04944F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.02648F, -0.00653F}, {0.07877F, 0.08933F, 0.09215F}, {0.14584F, -0.98931F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.00276F, 0.01176F}, {0.07663F, 0.10586F, 0.07596F}, {0.98874F, 0.14964F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.00237F, 0.01396F}, {0.07359F, 0.12621F, 0.06829F}, {0.95812F, -0.28636F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.18646F, -0.04885F}, {0.08421F, 0.10051F, 0.04598F}, {0.99769F, -0.06791F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.25718F, -0.03504F}, {0.12888F, 0.09846F, 0.07704F}, {0.99765F, 0.06859F, 0.00000F, 0.00000F}},
    {{0.09392F, -0.21708F, -0.04535F}, {0.06859F, 0.05267F, 0.06070F}, {0.78422F, 0.55136F, -0.22813F, -0.17020F}},
    {{-0.09392F, -0.21708F, -0.04535F}, {0.06859F, 0.05267F, 0.06070F}, {0.78422F, 0.55136F, 0.22813F, 0.17020F}},
}};

constexpr sim::HeadLandmarks kLandmarks{.positionsHd = {{{0.0F, 0.11097F, -0.03705F},
                                                         {0.0F, 0.0745F, 0.0782F},
                                                         {0.0F, -0.0625F, -0.0770F},
                                                         {0.0742F, -0.0178F, -0.0064F},
                                                         {-0.0742F, -0.0178F, -0.0064F},
                                                         {0.0F, -0.0363F, 0.1109F},
                                                         {0.0F, -0.1120F, 0.0881F}}}};

} // namespace

const HeadRow& bust1()
{
    static const HeadRow head{.name = "bust-1",
                              .title = QT_TRANSLATE_NOOP("Heads", "Mannequin of version 0.1"),
                              .landmarks = kLandmarks,
                              .regions = HeadRegions({.hairline = bust::kHairline,
                                                      .beardline = bust::kBeardline,
                                                      .browline = kBrowline,
                                                      .lashline = {},
                                                      .earCentre = bust::kEarCentre,
                                                      .earFlareDegrees = 28.0F,
                                                      .earTiltDegrees = 12.0F,
                                                      .lipsCentre = {0.0F, -0.0708F, 0.0850F},
                                                      .neckBelowY = bust::kNeckBelowY}),
                              .colliders = kColliders,
                              .scalpFraction = 0.1979};
    return head;
}

} // namespace hairpaint::heads
