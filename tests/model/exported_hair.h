// Hair on a ball, and its export.
#pragma once

#include "model/formats/export_format.h"
#include "sim/motion/simulation.h"
#include "tests/support/mannequin.h"

#include <memory>
#include <utility>
#include <vector>

namespace hairpaint::test {

inline std::shared_ptr<const sim::TiledRaster> flat(int channels, sim::Texel value)
{
    return std::make_shared<const sim::TiledRaster>(256, channels, value);
}

inline sim::GroomInput::Group hairGroup(int id, std::uint16_t density, std::uint16_t length, std::uint16_t curl)
{
    sim::GroomInput::Group input;
    input.id = id;
    input.settings.greatestDensityPerM2 = 20'000.0F;
    input.settings.greatestLengthM = 0.2F;
    input.settings.basisHairs = 256;
    for (const sim::MapRule& rule : sim::kMapRules)
        input.maps[rule.slot] = flat(rule.channels, rule.defaultValue);
    input.maps[sim::MapSlot::Density] = flat(1, {density});
    input.maps[sim::MapSlot::Length] = flat(1, {length});
    input.maps[sim::MapSlot::Curl] = flat(1, {curl});
    input.maps[sim::MapSlot::Colour] = flat(3, {65535, 32896, 0});
    return input;
}

/// A frame of hair in its rest shape.
inline std::shared_ptr<const sim::StrandFrame> frameOf(std::vector<sim::GroomInput::Group> groups)
{
    sim::GroomInput input;
    input.skin = std::make_shared<const sim::Skin>(test::makeBallHead());
    input.groups = std::move(groups);
    sim::Simulation simulation;
    simulation.setInput(input);
    auto frame = std::make_shared<sim::StrandFrame>();
    simulation.writeFrame(*frame);
    return frame;
}

/// Every group of the frame, named "Group 1" and so on.
inline model::CurveOptions allOf(const sim::StrandFrame& frame)
{
    model::CurveOptions options;
    options.groups.reserve(frame.groups.size());
    for (const sim::GroupFrame& group : frame.groups)
        options.groups.push_back(
            {.id = group.groom->groupId, .name = QStringLiteral("Group %1").arg(group.groom->groupId)});
    return options;
}

/// Exports in the format for the ending of `path`.
inline model::Result<void> exported(const std::shared_ptr<const sim::StrandFrame>& frame, const QString& path,
                                    const model::Progress& progress = {}, const char* target = "any")
{
    return model::exportHair(frame,
                             {.format = model::findExportFormat(path),
                              .target = model::findExportTarget(QLatin1StringView(target)),
                              .curves = allOf(*frame)},
                             path, progress);
}

/// An avatar whose body stands beside the hair.
inline std::shared_ptr<const model::Avatar> mannequinAvatar(float droop = 0.0F)
{
    model::RiggedMesh body = makeMannequin(droop);
    auto avatar = std::make_shared<model::Avatar>();
    avatar->name = QStringLiteral("Mannequin");
    avatar->author = QStringLiteral("Ann");
    avatar->skeleton = std::move(body.skeleton);
    avatar->bones = *model::humanoidBones(avatar->skeleton.joints);
    avatar->skin = std::make_shared<const sim::Skin>(std::move(body));
    return avatar;
}

/// Smaller than the window offers, so that cards are soon there.
inline constexpr int kTinyAtlasPx = 256;

/// Exports in that format.
inline model::Result<void> exportedAs(const model::ExportFormat& format,
                                      const std::shared_ptr<const sim::StrandFrame>& frame, const QString& path,
                                      const model::Progress& progress = {})
{
    static const std::shared_ptr<const model::Avatar> avatar = mannequinAvatar();
    return model::exportHair(frame,
                             {.format = &format,
                              .target = &model::exportTargets().front(),
                              .curves = allOf(*frame),
                              .cards = {.triangles = model::CardSettings::kFewestTriangles, .atlasPx = kTinyAtlasPx},
                              .avatar = format.isAvatar ? avatar : nullptr},
                             path, progress);
}

} // namespace hairpaint::test
