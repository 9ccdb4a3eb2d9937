// The operations as matrices.
#include "model/importing/usd_transform.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>

namespace hairpaint::model {

namespace {

constexpr std::string_view kPrefix = "xformOp:";
constexpr std::string_view kInvert = "!invert!";
constexpr std::string_view kReset = "!resetXformStack!";

/// "rotateXYZ" turns round x first.
std::optional<glm::mat4> rotationOf(std::string_view axes, std::span<const float> degrees)
{
    glm::mat4 turned(1.0F);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i] < 'X' || axes[i] > 'Z')
            return std::nullopt;
        const auto axis = static_cast<glm::length_t>(axes[i] - 'X');
        glm::vec3 direction(0.0F);
        direction[axis] = 1.0F;
        const float angle = axes.size() == 1 ? degrees[0] : degrees[static_cast<std::size_t>(axis)];
        turned = glm::rotate(glm::mat4(1.0F), glm::radians(angle), direction) * turned;
    }
    return turned;
}

std::optional<glm::mat4> operation(std::string_view kind, std::span<const float> values)
{
    const auto vector = [&values] { return glm::vec3(values[0], values[1], values[2]); };
    if (kind == "translate" && values.size() == 3)
        return glm::translate(glm::mat4(1.0F), vector());
    if (kind == "scale" && values.size() == 3)
        return glm::scale(glm::mat4(1.0F), vector());
    if (kind == "orient" && values.size() == 4)
        return glm::mat4_cast(glm::normalize(glm::quat(values[0], values[1], values[2], values[3])));
    if (kind == "transform" && values.size() == 16) {
        // Rows there, for vectors that stand before a matrix, are columns here.
        glm::mat4 matrix;
        for (std::size_t i = 0; i < values.size(); ++i)
            matrix[static_cast<glm::length_t>(i / 4)][static_cast<glm::length_t>(i % 4)] = values[i];
        return matrix;
    }
    constexpr std::string_view kRotate = "rotate";
    if (kind.starts_with(kRotate)) {
        const std::string_view axes = kind.substr(kRotate.size());
        if ((axes.size() == 1 || axes.size() == 3) && values.size() == axes.size())
            return rotationOf(axes, values);
    }
    return std::nullopt;
}

} // namespace

bool UsdTransform::addOperation(std::string_view name, std::span<const float> values)
{
    std::string_view kind = name.substr(kPrefix.size());
    kind = kind.substr(0, kind.find(':'));
    const std::optional<glm::mat4> matrix = operation(kind, values);
    if (matrix)
        m_operations.insert_or_assign(std::string(name), *matrix);
    return matrix.has_value();
}

bool UsdTransform::leavesParent() const
{
    return std::ranges::find(m_order, kReset) != m_order.end();
}

std::optional<glm::mat4> UsdTransform::toParent() const
{
    glm::mat4 all(1.0F);
    for (std::string_view name : m_order) {
        if (name == kReset) { // What stands before it does not count.
            all = glm::mat4(1.0F);
            continue;
        }
        const bool inverts = name.starts_with(kInvert);
        if (inverts)
            name.remove_prefix(kInvert.size());
        const auto found = m_operations.find(name);
        if (found == m_operations.end())
            return std::nullopt;
        all = all * (inverts ? glm::inverse(found->second) : found->second);
    }
    return all;
}

} // namespace hairpaint::model
