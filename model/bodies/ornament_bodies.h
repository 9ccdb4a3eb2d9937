// What is put into hair: each fits the unit ball once its proportions are taken out, stands on the skin at z = 0 with z
// away from it and y up, and is made once.
#pragma once

#include "model/bodies/hanging_part.h"
#include "sim/skin/ellipsoid.h"
#include "sim/skin/head_mesh.h"
#include "sim/skin/skin.h"

#include <memory>
#include <span>

namespace hairpaint::model {

inline constexpr glm::vec3 kBowProportions{1.0F, 0.85F, 0.4F};
inline constexpr glm::vec3 kHairpinProportions{1.0F, 0.14F, 0.14F};
inline constexpr glm::vec3 kFlowerProportions{1.0F, 1.0F, 0.45F};
inline constexpr glm::vec3 kCombProportions{1.0F, 0.75F, 0.4F};

[[nodiscard]] std::shared_ptr<const sim::HeadMesh> bowBody();
[[nodiscard]] std::span<const HangingPart> bowTails(); ///< Of bowBody().
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> hairpinBody();
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> flowerBody();
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> combBody();

/// A band of twice the shape's y wide over the skin around the shape's centre, from one end of its x over its z to the
/// other; it lies a little off the skin.
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> headbandBody(const sim::Ellipsoid& shape, const sim::Skin& skin);
/// The same over a ball, made once.
[[nodiscard]] std::shared_ptr<const sim::HeadMesh> looseHeadbandBody();

} // namespace hairpaint::model
