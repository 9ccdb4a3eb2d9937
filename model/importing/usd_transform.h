// How a prim of USD moves what it holds.
#pragma once

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hairpaint::model {

/// The operations of one prim, as UsdGeomXformable has them.
class UsdTransform
{
public:
    /// `name`: "xformOp:translate". False where such an operation is not known, or has not so many values.
    [[nodiscard]] bool addOperation(std::string_view name, std::span<const float> values);
    void addToOrder(std::string_view name) { m_order.emplace_back(name); }
    /// It stands as it says itself, wherever its parent does.
    [[nodiscard]] bool leavesParent() const;
    /// From the prim's space to its parent's, or to the stage's. None where the order names what is not there.
    [[nodiscard]] std::optional<glm::mat4> toParent() const;

private:
    std::map<std::string, glm::mat4, std::less<>> m_operations;
    std::vector<std::string> m_order; ///< The first is done last.
};

} // namespace hairpaint::model
