// Limbs are told by their names, the trunk by what lies between them: programs number and name its joints differently.
#include "model/heads/humanoid_bones.h"

#include "model/heads/joint_names.h"

#include <QStringList>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace hairpaint::model {

namespace {

constexpr auto kRightFromLeft =
    static_cast<std::size_t>(HumanBone::RightEye) - static_cast<std::size_t>(HumanBone::LeftEye);

/// The bones of the middle and of the left side, in the order of HumanBone; those of the right follow from the left.
constexpr std::array<HumanBoneSpec, static_cast<std::size_t>(HumanBone::RightEye)> makeSpecs()
{
    using enum HumanBone;
    return {{
        {"hips", Hips, true},
        {"spine", Hips, true},
        {"chest", Spine, false},
        {"upperChest", Chest, false},
        {"neck", UpperChest, false},
        {"head", Neck, true},
        {"jaw", Head, false},
        {"leftEye", Head, false},
        {"leftUpperLeg", Hips, true},
        {"leftLowerLeg", LeftUpperLeg, true},
        {"leftFoot", LeftLowerLeg, true},
        {"leftToes", LeftFoot, false},
        {"leftShoulder", UpperChest, false},
        {"leftUpperArm", LeftShoulder, true},
        {"leftLowerArm", LeftUpperArm, true},
        {"leftHand", LeftLowerArm, true},
        {"leftThumbMetacarpal", LeftHand, false},
        {"leftThumbProximal", LeftThumbMetacarpal, false},
        {"leftThumbDistal", LeftThumbProximal, false},
        {"leftIndexProximal", LeftHand, false},
        {"leftIndexIntermediate", LeftIndexProximal, false},
        {"leftIndexDistal", LeftIndexIntermediate, false},
        {"leftMiddleProximal", LeftHand, false},
        {"leftMiddleIntermediate", LeftMiddleProximal, false},
        {"leftMiddleDistal", LeftMiddleIntermediate, false},
        {"leftRingProximal", LeftHand, false},
        {"leftRingIntermediate", LeftRingProximal, false},
        {"leftRingDistal", LeftRingIntermediate, false},
        {"leftLittleProximal", LeftHand, false},
        {"leftLittleIntermediate", LeftLittleProximal, false},
        {"leftLittleDistal", LeftLittleIntermediate, false},
    }};
}

constexpr auto kSpecs = makeSpecs();

HumanBone onSide(HumanBone left, BodySide side)
{
    return side == BodySide::Right ? static_cast<HumanBone>(static_cast<std::size_t>(left) + kRightFromLeft) : left;
}

/// A bone of a limb, and names that it goes by, the surest first: what some call an arm others call an upper arm.
struct LimbBone
{
    HumanBone left;
    HumanBone below; ///< The bone of the limb that it hangs from, itself where it is the first.
    std::array<std::string_view, 9> names;
};

/// In the order in which they are looked for.
constexpr std::array<LimbBone, 9> makeLimbs()
{
    using enum HumanBone;
    return {{
        {LeftUpperArm, LeftUpperArm, {"upperarm", "uparm", "armupper", "shldrbend", "shldr", "arm", "shoulder"}},
        {LeftLowerArm, LeftUpperArm, {"lowerarm", "lowarm", "forearm", "forearmbend", "armlower", "elbow", "arm"}},
        {LeftHand, LeftLowerArm, {"wrist", "hand", "palm"}},
        {LeftShoulder, LeftShoulder, {"clavicle", "shoulder", "collar", "collarbone", "clav"}},
        {LeftUpperLeg, LeftUpperLeg, {"upperleg", "upleg", "thigh", "thighbend", "legupper", "femur", "leg", "hip"}},
        {LeftLowerLeg, LeftUpperLeg, {"lowerleg", "lowleg", "calf", "shin", "leglower", "tibia", "knee", "leg"}},
        {LeftFoot, LeftLowerLeg, {"ankle", "foot"}},
        {LeftToes, LeftFoot, {"toebase", "toes", "toe", "ball", "foot"}},
        {LeftEye, LeftEye, {"eye", "faceeye", "eyeball"}},
    }};
}

constexpr auto kLimbs = makeLimbs();

struct Finger
{
    HumanBone left; ///< The first of three.
    std::array<std::string_view, 2> words;
};

constexpr std::array<Finger, 5> makeFingers()
{
    using enum HumanBone;
    return {{
        {LeftThumbMetacarpal, {"thumb", "thumb"}},
        {LeftIndexProximal, {"index", "index"}},
        {LeftMiddleProximal, {"middle", "mid"}},
        {LeftRingProximal, {"ring", "ring"}},
        {LeftLittleProximal, {"little", "pinky"}},
    }};
}

constexpr auto kFingers = makeFingers();

/// What the names of all joints below the first begin with, up to a sign between words: Collada's have the armature's
/// name before their own.
std::string_view sharedStart(std::span<const HeadJoint> joints)
{
    if (joints.size() < 3)
        return {};
    std::string_view shared = joints[1].name;
    for (const HeadJoint& joint : joints.subspan(2)) {
        const std::string_view name = joint.name;
        std::size_t same = 0;
        while (same < std::min(shared.size(), name.size()) && shared[same] == name[same])
            ++same;
        shared = shared.substr(0, same);
    }
    return shared.substr(0, shared.find_last_of("_:.| -") + 1);
}

class BoneFinder
{
    using enum HumanBone;

public:
    explicit BoneFinder(std::span<const HeadJoint> joints) : m_joints(joints)
    {
        const std::string_view start = sharedStart(joints);
        for (const HeadJoint& joint : joints) {
            const std::string_view name = joint.name;
            m_names.push_back(readJointName(name.substr(name.starts_with(start) ? start.size() : 0)));
            m_depths.push_back(joint.parent < 0 ? 0 : m_depths[static_cast<std::size_t>(joint.parent)] + 1);
        }
    }

    HumanoidBones find()
    {
        for (const BodySide side : {BodySide::Left, BodySide::Right})
            for (const LimbBone& limb : kLimbs)
                findLimb(limb, side);
        findTrunk();
        for (const BodySide side : {BodySide::Left, BodySide::Right}) {
            dropShoulderBeside(side);
            for (const Finger& finger : kFingers)
                findFinger(finger, side);
        }
        return m_found;
    }

private:
    [[nodiscard]] int parentOf(int joint) const { return m_joints[static_cast<std::size_t>(joint)].parent; }
    [[nodiscard]] const JointName& nameOf(int joint) const { return m_names[static_cast<std::size_t>(joint)]; }
    [[nodiscard]] int depthOf(int joint) const { return m_depths[static_cast<std::size_t>(joint)]; }
    [[nodiscard]] int count() const { return static_cast<int>(m_joints.size()); }
    [[nodiscard]] bool isTaken(int joint) const
    {
        return std::ranges::find(m_found.joints, joint) != m_found.joints.end();
    }

    /// A joint lies at or below itself, and everything below -1.
    [[nodiscard]] bool isBelow(int joint, int above) const
    {
        while (joint >= 0 && joint != above)
            joint = parentOf(joint);
        return joint == above;
    }

    /// The lowest above both; -1 where one is missing or there is none.
    [[nodiscard]] int joined(int a, int b) const
    {
        if (a < 0 || b < 0)
            return -1;
        while (a >= 0 && !isBelow(b, a))
            a = parentOf(a);
        return a;
    }

    /// Below `above` and not taken, the nearest to the root; -1 where there is none.
    [[nodiscard]] int named(std::string_view part, BodySide side, int above) const
    {
        int best = -1;
        for (int joint = 0; joint < count(); ++joint)
            if (nameOf(joint).part == part && nameOf(joint).side == side && joint != above && isBelow(joint, above) &&
                !isTaken(joint) && (best < 0 || depthOf(joint) < depthOf(best)))
                best = joint;
        return best;
    }

    void findLimb(const LimbBone& limb, BodySide side)
    {
        int above = -1;
        if (limb.below != limb.left) {
            above = m_found[onSide(limb.below, side)];
            if (above < 0)
                return;
        }
        for (const std::string_view name : limb.names) {
            const int joint = name.empty() ? -1 : named(name, side, above);
            if (joint < 0)
                continue;
            m_found[onSide(limb.left, side)] = joint;
            return;
        }
    }

    /// VRM has it between chest and upper arm.
    void dropShoulderBeside(BodySide side)
    {
        int& shoulder = m_found[onSide(LeftShoulder, side)];
        const int arm = m_found[onSide(LeftUpperArm, side)];
        const int trunk = joined(m_found[LeftUpperArm], m_found[RightUpperArm]);
        if (shoulder >= 0 && (arm < 0 || !isBelow(arm, shoulder) || shoulder == trunk || !isBelow(shoulder, trunk)))
            shoulder = -1;
    }

    /// By name; else, as Rigify has it, the last joint of the spine.
    [[nodiscard]] int findHead(int chest) const
    {
        if (const int joint = named("head", BodySide::Middle, chest); joint >= 0)
            return joint;
        int last = -1;
        for (int joint = 0; joint < count(); ++joint)
            if (nameOf(joint).part == "spine" && joint != chest && isBelow(joint, chest) &&
                (last < 0 || depthOf(joint) > depthOf(last)))
                last = joint;
        return last;
    }

    void findTrunk()
    {
        const int chest = joined(m_found[LeftUpperArm], m_found[RightUpperArm]);
        const int legs = joined(m_found[LeftUpperLeg], m_found[RightUpperLeg]);
        m_found[Head] = findHead(chest);
        if (m_found[Head] >= 0)
            m_found[Jaw] = named("jaw", BodySide::Middle, m_found[Head]);
        for (const BodySide side : {BodySide::Left, BodySide::Right})
            if (int& eye = m_found[onSide(LeftEye, side)]; eye >= 0 && !isBelow(eye, m_found[Head]))
                eye = -1;
        const int hips = joined(legs, chest);
        if (hips < 0)
            return;
        m_found[Hips] = hipsAbove(hips); // Biped's legs may hang from the lower end of its spine.
        findSpine(hips, chest);
        findNeck(chest);
    }

    /// The lowest that all limbs hang from, or one above it that is named so.
    [[nodiscard]] int hipsAbove(int lowest) const
    {
        for (int joint = lowest; joint >= 0; joint = parentOf(joint)) {
            const JointName& name = nameOf(joint);
            if (name.side == BodySide::Middle && (name.part == "hips" || name.part == "hip" || name.part == "pelvis"))
                return joint;
        }
        return lowest;
    }

    /// Between the hips and the joint that the arms hang from; none of these has a leg below it.
    void findSpine(int hips, int chest)
    {
        std::vector<int> between;
        for (int joint = chest; joint >= 0 && joint != hips; joint = parentOf(joint))
            between.push_back(joint);
        std::ranges::reverse(between);
        if (between.empty())
            return;
        m_found[Spine] = between.front();
        if (between.size() > 1)
            m_found[between.size() > 2 ? UpperChest : Chest] = between.back();
        if (between.size() > 2)
            m_found[Chest] = between[(between.size() - 1) / 2];
    }

    /// The first between the joint that the arms hang from and the head.
    void findNeck(int chest)
    {
        if (m_found[Head] < 0 || !isBelow(m_found[Head], chest))
            return;
        int neck = -1;
        for (int joint = parentOf(m_found[Head]); joint >= 0 && joint != chest; joint = parentOf(joint))
            neck = joint;
        m_found[Neck] = neck;
    }

    /// Its joints one below the other; those of the palm are the thumb's alone.
    void findFinger(const Finger& finger, BodySide side)
    {
        const int hand = m_found[onSide(LeftHand, side)];
        if (hand < 0)
            return;
        int above = hand;
        std::size_t found = 0;
        for (int joint = hand + 1; joint < count() && found < 3; ++joint) { // Parents come before their children.
            if (joint == above || !isBelow(joint, above) || !isOf(finger, nameOf(joint).part))
                continue;
            const auto bone = static_cast<HumanBone>(static_cast<std::size_t>(finger.left) + found++);
            m_found[onSide(bone, side)] = joint;
            above = joint;
        }
    }

    [[nodiscard]] static bool isOf(const Finger& finger, std::string_view part)
    {
        const auto has = [part](std::string_view word) { return part.find(word) != std::string_view::npos; };
        const bool isEnd = has("end") || has("tip") || has("nub") || has("twist");
        const bool isPalm = finger.left != LeftThumbMetacarpal && (has("carpal") || has("palm"));
        return !isEnd && !isPalm && (has(finger.words[0]) || has(finger.words[1]));
    }

    std::span<const HeadJoint> m_joints;
    std::vector<JointName> m_names;
    std::vector<int> m_depths;
    HumanoidBones m_found;
};

/// The first bone above a joint that is found; HumanBone::Count where there is none.
HumanBone boneAbove(std::span<const HeadJoint> joints, const HumanoidBones& bones, int joint)
{
    for (joint = joints[static_cast<std::size_t>(joint)].parent; joint >= 0;
         joint = joints[static_cast<std::size_t>(joint)].parent)
        for (std::size_t bone = 0; bone < kHumanBoneCount; ++bone)
            if (bones.joints.at(bone) == joint)
                return static_cast<HumanBone>(bone);
    return HumanBone::Count;
}

/// Whether what is above the bone in the skeleton is above it in VRM.
bool hangsRight(std::span<const HeadJoint> joints, const HumanoidBones& bones, HumanBone bone)
{
    const HumanBone above = boneAbove(joints, bones, bones[bone]);
    if (bone == HumanBone::Hips)
        return above == HumanBone::Count;
    for (HumanBone at = humanBoneSpec(bone).parent;; at = humanBoneSpec(at).parent) {
        if (at == above)
            return true;
        if (at == HumanBone::Hips)
            return false;
    }
}

} // namespace

const HumanBoneSpec& humanBoneSpec(HumanBone bone)
{
    static const std::array<std::string, kHumanBoneCount> ids = [] {
        std::array<std::string, kHumanBoneCount> made;
        for (std::size_t i = 0; i < kHumanBoneCount; ++i)
            made.at(i) =
                i < kSpecs.size() ? kSpecs.at(i).id : "right" + std::string(kSpecs.at(i - kRightFromLeft).id).substr(4);
        return made;
    }();
    static const std::array<HumanBoneSpec, kHumanBoneCount> specs = [] {
        std::array<HumanBoneSpec, kHumanBoneCount> made{};
        for (std::size_t i = 0; i < kHumanBoneCount; ++i) {
            made.at(i) = kSpecs.at(i < kSpecs.size() ? i : i - kRightFromLeft);
            made.at(i).id = ids.at(i).c_str();
            if (i >= kSpecs.size() && made.at(i).parent >= HumanBone::LeftEye)
                made.at(i).parent = onSide(made.at(i).parent, BodySide::Right);
        }
        return made;
    }();
    return specs.at(static_cast<std::size_t>(bone));
}

Checked<HumanoidBones> humanoidBones(std::span<const HeadJoint> joints)
{
    if (joints.empty())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "the head came without a skeleton, and a VRM has a whole body's; "
                                                     "export the hair as .glb with spring bones instead")),
                      Clause::Cure::OtherFile);
    HumanoidBones bones = BoneFinder(joints).find();
    // From the hips on, so that what hangs wrongly is no bone above others.
    for (std::size_t i = 0; i < kHumanBoneCount; ++i)
        if (bones.joints.at(i) >= 0 && !hangsRight(joints, bones, static_cast<HumanBone>(i)))
            bones.joints.at(i) = -1;
    QStringList missing;
    for (std::size_t i = 0; i < kHumanBoneCount; ++i) {
        const HumanBoneSpec& spec = humanBoneSpec(static_cast<HumanBone>(i));
        if (spec.required && bones.joints.at(i) < 0)
            missing += QLatin1StringView(spec.id);
    }
    if (!missing.isEmpty())
        return refuse(say(QT_TRANSLATE_NOOP("Files", "among the names of the head's joints these were not found: %1; "
                                                     "export the hair as .glb with spring bones instead"))
                          .arg(missing.join(QLatin1String(", "))),
                      Clause::Cure::OtherFile);
    return bones;
}

} // namespace hairpaint::model
