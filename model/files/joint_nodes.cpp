// Names, translations, rotations and children.
#include "model/files/joint_nodes.h"

#include "model/files/json_fields.h"

#include <QJsonObject>

namespace hairpaint::model {

namespace {

/// That many numbers; false where there are others.
template<qsizetype N>
bool readNumbers(const QJsonValue& value, std::array<float, static_cast<std::size_t>(N)>& numbers)
{
    const QJsonArray array = value.toArray();
    if (array.size() != N)
        return false;
    for (qsizetype i = 0; i < N; ++i) {
        if (!array.at(i).isDouble())
            return false;
        // What is written is never -0, which would not come back.
        numbers.at(static_cast<std::size_t>(i)) = static_cast<float>(array.at(i).toDouble()) + 0.0F;
    }
    return true;
}

} // namespace

QJsonArray nodesOf(const HeadSkeleton& skeleton, int firstNode)
{
    std::vector<QJsonArray> children(skeleton.joints.size());
    for (std::size_t i = 1; i < skeleton.joints.size(); ++i)
        children[static_cast<std::size_t>(skeleton.joints[i].parent)].append(firstNode + static_cast<int>(i));
    QJsonArray nodes;
    for (std::size_t i = 0; i < skeleton.joints.size(); ++i) {
        const HeadJoint& joint = skeleton.joints[i];
        const glm::vec3& t = joint.translation;
        const glm::quat& r = joint.rotation;
        QJsonObject node{
            {QStringLiteral("name"), QString::fromStdString(joint.name)},
            {QStringLiteral("translation"), QJsonArray{shortestDouble(t.x), shortestDouble(t.y), shortestDouble(t.z)}},
            {QStringLiteral("rotation"),
             QJsonArray{shortestDouble(r.x), shortestDouble(r.y), shortestDouble(r.z), shortestDouble(r.w)}}};
        if (!children[i].isEmpty())
            node.insert(QStringLiteral("children"), children[i]);
        nodes.append(node);
    }
    return nodes;
}

QJsonArray jointNumbers(const HeadSkeleton& skeleton, int firstNode)
{
    QJsonArray numbers;
    for (int i = 0; i < static_cast<int>(skeleton.joints.size()); ++i)
        numbers.append(firstNode + i);
    return numbers;
}

std::optional<std::vector<HeadJoint>> jointsFromNodes(const QJsonArray& nodes, const QJsonArray& numbers)
{
    if (numbers.size() > static_cast<qsizetype>(HeadSkeleton::kMostJoints))
        return std::nullopt;
    std::vector<HeadJoint> joints(static_cast<std::size_t>(numbers.size()));
    const qint64 first = numbers.at(0).toInteger(-1);
    for (qsizetype i = 0; i < numbers.size(); ++i) {
        if (first < 0 || numbers.at(i).toInteger(-1) != first + i || first + i >= nodes.size())
            return std::nullopt;
        const QJsonObject node = nodes.at(first + i).toObject();
        HeadJoint& joint = joints[static_cast<std::size_t>(i)];
        std::array<float, 3> t{};
        std::array<float, 4> r{};
        if (!readNumbers<3>(node.value(QLatin1String("translation")), t) ||
            !readNumbers<4>(node.value(QLatin1String("rotation")), r))
            return std::nullopt;
        joint.name = node.value(QLatin1String("name")).toString().toStdString();
        joint.translation = {t[0], t[1], t[2]};
        joint.rotation = {r[3], r[0], r[1], r[2]};
        const QJsonArray children = node.value(QLatin1String("children")).toArray();
        for (const auto& child : children) {
            const qint64 number = child.toInteger(-1) - first;
            if (number <= i || number >= numbers.size())
                return std::nullopt;
            joints[static_cast<std::size_t>(number)].parent = static_cast<int>(i);
        }
    }
    return joints;
}

} // namespace hairpaint::model
