// What the names of joints say, in the manners of the programs that skeletons come from.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hairpaint::model {

enum class BodySide : std::uint8_t
{
    Middle,
    Left,
    Right
};

struct JointName
{
    std::string part; ///< In lower case, without what is no word of it: "upperarm", "spine".
    BodySide side = BodySide::Middle;
};

/// "mixamorig:LeftForeArm", "forearm_l", "DEF-forearm.L", "J_Bip_L_LowerArm", "Bip01 L Forearm" and "lForearm" are a
/// left forearm. Digits are left out.
[[nodiscard]] JointName readJointName(std::string_view name);

} // namespace hairpaint::model
