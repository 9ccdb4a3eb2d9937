// Units and axes of what is exported.
#pragma once

#include "model/exporting/card_settings.h"

#include "model/project/head_part.h"
#include "model/project/worn.h"

#include <QRgb>

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace hairpaint::model {

struct Avatar;

/// From ours (m, y up, face toward +z) to another right-handed space. With z up the face looks toward -y.
struct ExportSpace
{
    float unitsPerMetre = 1.0F;
    bool zUp = false;

    [[nodiscard]] glm::vec3 direction(const glm::vec3& own) const
    {
        return zUp ? glm::vec3(own.x, -own.z, own.y) : own;
    }
    [[nodiscard]] glm::vec3 position(const glm::vec3& own) const { return unitsPerMetre * direction(own); }
    [[nodiscard]] float length(float metres) const { return unitsPerMetre * metres; }
    friend bool operator==(const ExportSpace&, const ExportSpace&) = default;
};

/// How a file is written.
struct ExportSettings
{
    ExportSpace space;
    bool groomColours = false;     ///< Its reader takes colours from Unreal's groom attributes alone.
    CardSettings cards{};          ///< Settings of hair cards, for formats that make them.
    std::vector<Worn> worn{};      ///< Worn things: colliders of cards that swing, and exported with the head.
    std::vector<HeadPart> parts{}; ///< Parts of the head's character beside the head's mesh, Hd.
    /// The texture on the head's skin; null where its file has none.
    std::shared_ptr<const sim::MeshTexture> headTexture{};
    QRgb skinColour = 0xFF808080; ///< Colour of the skin of an exported head.
    /// The avatar that the head belongs to; null for formats other than avatars.
    std::shared_ptr<const Avatar> avatar{};
};

} // namespace hairpaint::model
