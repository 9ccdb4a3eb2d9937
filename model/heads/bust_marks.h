// Marks on the skin that several of the built-in busts have in common. Frozen with the rows that name them: a head that
// wants other ones has its own.
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace hairpaint::heads::bust {

inline constexpr std::array<glm::vec3, 23> kHairline = {
    {{0.000F, 0.0745F, 0.0770F},    {0.016F, 0.0750F, 0.0755F},    {0.032F, 0.0765F, 0.0660F},
     {0.044F, 0.0755F, 0.0530F},    {0.052F, 0.0660F, 0.0460F},    {0.058F, 0.0530F, 0.0440F},
     {0.0625F, 0.0400F, 0.0440F},   {0.0675F, 0.0270F, 0.0380F},   {0.0700F, 0.0140F, 0.0270F},
     {0.0710F, 0.0000F, 0.0205F},   {0.0710F, -0.0120F, 0.0185F},  {0.0710F, -0.0165F, 0.0140F},
     {0.0720F, -0.0120F, 0.0105F},  {0.0730F, 0.0030F, 0.0095F},   {0.0740F, 0.0165F, 0.0060F},
     {0.0750F, 0.0240F, -0.0060F},  {0.0750F, 0.0215F, -0.0200F},  {0.0730F, 0.0080F, -0.0310F},
     {0.0700F, -0.0150F, -0.0350F}, {0.0620F, -0.0380F, -0.0420F}, {0.0450F, -0.0560F, -0.0600F},
     {0.0220F, -0.0650F, -0.0730F}, {0.0000F, -0.0630F, -0.0770F}}};

inline constexpr std::array<glm::vec3, 15> kBeardline = {{{0.0000F, -0.0520F, 0.0930F},
                                                          {0.0100F, -0.0520F, 0.0920F},
                                                          {0.0200F, -0.0550F, 0.0850F},
                                                          {0.0310F, -0.0590F, 0.0760F},
                                                          {0.0430F, -0.0520F, 0.0640F},
                                                          {0.0570F, -0.0400F, 0.0440F},
                                                          {0.0670F, -0.0250F, 0.0240F},
                                                          {0.0710F, -0.0150F, 0.0180F},
                                                          {0.0720F, -0.0150F, 0.0110F},
                                                          {0.0690F, -0.0330F, 0.0070F},
                                                          {0.0620F, -0.0560F, 0.0020F},
                                                          {0.0530F, -0.0820F, 0.0030F},
                                                          {0.0380F, -0.1000F, 0.0120F},
                                                          {0.0200F, -0.1080F, 0.0240F},
                                                          {0.0000F, -0.1110F, 0.0290F}}};

inline constexpr glm::vec3 kEarCentre{0.0725F, -0.0140F, -0.0100F};

inline constexpr float kNeckBelowY = -0.128F;

} // namespace hairpaint::heads::bust
