// Names are cut into words; some tell of a side, some of nothing.
#include "model/heads/joint_names.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace hairpaint::model {

namespace {

/// Words that name no body part: those for programs and for the purpose of a joint, as VRoid, Biped, Rigify, Auto-Rig,
/// Character Creator, Source and Mixamo use them.
constexpr std::array<std::string_view, 17> kIdle = {"j",     "bip",  "c",       "adj",   "sec",      "def",
                                                    "org",   "x",    "stretch", "cc",    "base",     "jnt",
                                                    "joint", "bone", "valve",   "biped", "mixamorig"};

bool isUpper(char c)
{
    return c >= 'A' && c <= 'Z';
}

bool isLower(char c)
{
    return c >= 'a' && c <= 'z';
}

/// In lower case: "LeftUpLeg" is left, up, leg; "IKHand" is ik, hand.
std::vector<std::string> wordsOf(std::string_view name)
{
    std::vector<std::string> words;
    bool goesOn = false;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (!isUpper(c) && !isLower(c)) {
            goesOn = false;
            continue;
        }
        const bool begins =
            isUpper(c) && i > 0 && (isLower(name[i - 1]) || (i + 1 < name.size() && isLower(name[i + 1])));
        if (!goesOn || begins)
            words.emplace_back();
        words.back() += isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
        goesOn = true;
    }
    return words;
}

BodySide sideOf(const std::string& word)
{
    if (word == "l" || word == "left")
        return BodySide::Left;
    return word == "r" || word == "right" ? BodySide::Right : BodySide::Middle;
}

/// "leftarm", all in lower case.
void splitSide(std::string& part, BodySide& side)
{
    for (const auto& [start, told] :
         {std::pair{std::string_view("left"), BodySide::Left}, std::pair{std::string_view("right"), BodySide::Right}})
        if (side == BodySide::Middle && part.size() > start.size() && part.starts_with(start)) {
            side = told;
            part.erase(0, start.size());
        }
}

} // namespace

JointName readJointName(std::string_view name)
{
    // A name space comes first: "mixamorig:Hips".
    if (const std::size_t colon = name.rfind(':'); colon != std::string_view::npos)
        name.remove_prefix(colon + 1);
    JointName read;
    for (const std::string& word : wordsOf(name)) {
        const BodySide side = sideOf(word);
        if (side != BodySide::Middle && read.side == BodySide::Middle)
            read.side = side;
        else if (std::ranges::find(kIdle, word) == kIdle.end())
            read.part += word;
    }
    splitSide(read.part, read.side);
    return read;
}

} // namespace hairpaint::model
