// bust-2: the head of new projects.
#include "model/heads/built_in_heads.h"
#include "model/heads/bust_marks.h"

#include <QtGlobal>

#include <array>

namespace hairpaint::heads {

namespace {

constexpr std::array<glm::vec3, 6> kBrowline = {{{0.0120F, 0.0195F, 0.0900F},
                                                 {0.0190F, 0.0226F, 0.0885F},
                                                 {0.0270F, 0.0252F, 0.0855F},
                                                 {0.0360F, 0.0262F, 0.0790F},
                                                 {0.0440F, 0.0244F, 0.0710F},
                                                 {0.0510F, 0.0194F, 0.0610F}}};

constexpr std::array<glm::vec3, 7> kLashline = {{{0.0179F, -0.0042F, 0.0687F},
                                                 {0.0218F, -0.0055F, 0.0724F},
                                                 {0.0265F, -0.0061F, 0.0747F},
                                                 {0.0314F, -0.0059F, 0.0756F},
                                                 {0.0360F, -0.0051F, 0.0755F},
                                                 {0.0403F, -0.0039F, 0.0743F},
                                                 {0.0440F, -0.0025F, 0.0717F}}};

/// Neck, four for cranium and face, upper back, chest and shoulders.
const std::array<sim::Ellipsoid, 8> kColliders = {{
    {{0.00000F, -0.17055F, -0.03047F}, {0.06124F, 0.27842F, 0.05171F}, {0.99962F, -0.02752F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.03119F, -0.01553F}, {0.07730F, 0.08971F, 0.08229F}, {0.76589F, 0.64297F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.01251F, 0.01882F}, {0.07304F, 0.09439F, 0.06936F}, {0.99988F, 0.01586F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.01546F, -0.00292F}, {0.06837F, 0.12159F, 0.07497F}, {0.91979F, -0.39240F, 0.00000F, 0.00000F}},
    {{0.00000F, 0.01216F, -0.03277F}, {0.06846F, 0.09866F, 0.06607F}, {0.99979F, 0.02044F, 0.00000F, 0.00000F}},
    {{0.00000F, -0.36034F, -0.05736F}, {0.10850F, 0.28025F, 0.06372F}, {0.99999F, -0.00275F, 0.00000F, 0.00000F}},
    {{0.02929F, -0.25341F, -0.03541F}, {0.07418F, 0.13546F, 0.06592F}, {0.85626F, -0.04355F, 0.04910F, -0.51208F}},
    {{-0.02929F, -0.25341F, -0.03541F}, {0.07418F, 0.13546F, 0.06592F}, {0.85626F, -0.04355F, -0.04910F, 0.51208F}},
}};

constexpr sim::HeadLandmarks kLandmarks{.positionsHd = {{{0.0F, 0.11024F, -0.03682F},
                                                         {0.0F, 0.0728F, 0.0748F},
                                                         {0.0F, -0.0675F, -0.08245F},
                                                         {0.0729F, -0.0173F, -0.0061F},
                                                         {-0.0729F, -0.0173F, -0.0061F},
                                                         {0.0F, -0.0378F, 0.1069F},
                                                         {0.0F, -0.1101F, 0.0819F}}}};

} // namespace

const HeadRow& bust2()
{
    static const HeadRow head{.name = "bust-2",
                              .title = QT_TRANSLATE_NOOP("Heads", "Display bust"),
                              .landmarks = kLandmarks,
                              .regions = HeadRegions({.hairline = bust::kHairline,
                                                      .beardline = bust::kBeardline,
                                                      .browline = kBrowline,
                                                      .lashline = kLashline,
                                                      .earCentre = bust::kEarCentre,
                                                      .earFlareDegrees = 33.0F,
                                                      .earTiltDegrees = -7.0F,
                                                      .lipsCentre = {0.0F, -0.0690F, 0.0840F},
                                                      .neckBelowY = bust::kNeckBelowY}),
                              .colliders = kColliders,
                              .scalpFraction = 0.2286};
    return head;
}

} // namespace hairpaint::heads
