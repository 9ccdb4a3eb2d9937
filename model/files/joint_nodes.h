// Joints as nodes of a glTF (Khronos, glTF 2.0 specification, section 3.5), and back.
#pragma once

#include "model/heads/head_skeleton.h"

#include <QJsonArray>

#include <optional>
#include <vector>

namespace hairpaint::model {

/// The joints' nodes in their order, the first of which has that number.
[[nodiscard]] QJsonArray nodesOf(const HeadSkeleton& skeleton, int firstNode);
/// The numbers of these nodes.
[[nodiscard]] QJsonArray jointNumbers(const HeadSkeleton& skeleton, int firstNode);

/// Reads a file of ours: `numbers` tells which nodes are joints. None if they are not as nodesOf() writes them; the
/// content of a joint is not checked.
[[nodiscard]] std::optional<std::vector<HeadJoint>> jointsFromNodes(const QJsonArray& nodes, const QJsonArray& numbers);

} // namespace hairpaint::model
