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
    CardSettings cards{};          ///< For formats that make some;
    std::vector<Worn> worn{};      ///< what keeps them out where they swing, and goes with the head.
    std::vector<HeadPart> parts{}; ///< Beside the head's mesh, Hd.
    std::shared_ptr<const sim::MeshTexture> headTexture{}; ///< Null where its file shows none.
    QRgb skinColour = 0xFF808080;                          ///< Of the head beside them.
    std::shared_ptr<const Avatar> avatar{};                ///< Whose body that head is part of, for formats of avatars.
};

} // namespace hairpaint::model
