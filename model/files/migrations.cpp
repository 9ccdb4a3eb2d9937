// The steps from one format version to the next.
#include "model/files/migrations.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>
#include <array>
#include <cmath>

namespace hairpaint::model {

namespace {

using Step = void (*)(QJsonObject&);
/// `physics.body`, a fraction of the rest shape, became `physics.stiffness_m`: hair of the former default is that of a
/// usual fibre, and all of it a wire that stands on 20 cm. `physics.parting` and `physics.sweep_back` went: what they
/// did is painted once maps and head are read (former_combing.h); a reader ignores them.
void toVersion2(QJsonObject& root)
{
    constexpr double kUsualBody = 0.15;
    constexpr double kUsualStiffnessM = 0.05;
    constexpr double kExponent = 0.73;
    const QLatin1StringView groupsKey("groups");
    const QLatin1StringView settingsKey("settings");
    const QLatin1StringView physicsKey("physics");
    QJsonArray groups = root.value(groupsKey).toArray();
    for (QJsonValueRef value : groups) {
        QJsonObject group = value.toObject();
        QJsonObject settings = group.value(settingsKey).toObject();
        QJsonObject physics = settings.value(physicsKey).toObject();
        const QJsonValue body = physics.value(QLatin1StringView("body"));
        if (!body.isDouble())
            continue;
        const double fraction = std::clamp(body.toDouble(), 0.0, 1.0) / kUsualBody;
        physics.insert(QLatin1StringView("stiffness_m"), kUsualStiffnessM * std::pow(fraction, kExponent));
        settings.insert(physicsKey, physics);
        group.insert(settingsKey, settings);
        value = group;
    }
    if (!groups.isEmpty())
        root.insert(groupsKey, groups);
}

/// Version 3 adds the array `worn`; what was there before is as it was.
void toVersion3(QJsonObject& /*root*/) {}

/// Version 4 adds parts to head.glb.
void toVersion4(QJsonObject& /*root*/) {}

/// kSteps[n - 1] brings version n to n + 1.
constexpr std::array<Step, kFormatVersion - 1> kSteps = {toVersion2, toVersion3, toVersion4};

} // namespace

Checked<QJsonObject> migrated(QJsonObject root)
{
    const QJsonValue version = root.value(QLatin1String("format_version"));
    const int from = version.toInt(0);
    if (from < 1)
        return refuse(QCoreApplication::translate("Files", "its format version is missing"));
    if (from > kFormatVersion)
        return refuse(QCoreApplication::translate("Files", "its format is %1, and this Hair Paint reads up to %2")
                          .arg(from)
                          .arg(kFormatVersion),
                      Clause::Cure::NewerProgram);
    for (auto step = static_cast<std::size_t>(from); step <= kSteps.size(); ++step)
        kSteps[step - 1](root);
    root.insert(QLatin1String("format_version"), kFormatVersion);
    return root;
}

} // namespace hairpaint::model
