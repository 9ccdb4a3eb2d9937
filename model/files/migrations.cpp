// The steps from one format version to the next. Version 1 is the first, so there is none yet.
#include "model/files/migrations.h"

#include <QCoreApplication>

#include <array>

namespace hairpaint::model {

namespace {

using Step = void (*)(QJsonObject&);
/// kSteps[n - 1] brings version n to n + 1.
constexpr std::array<Step, kFormatVersion - 1> kSteps = {};

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
